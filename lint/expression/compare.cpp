#include "lint/expression/compare.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lint/expression/curves.hpp"
#include "lint/expression/mutants.hpp"

namespace shadefit::lint {
namespace {

/// The form and all its parts.
void append_parts(const Curve& curve, std::vector<Curve>& parts) {
  parts.push_back(curve);
  for (const Symbolic& part : curve.form.parts()) append_parts({part, curve.constants}, parts);
}

void append_names(const Symbolic& formula, std::set<std::string>& names) {
  if (formula.kind() == Symbolic::Kind::variable) names.insert(formula.name());
  for (const Symbolic& part : formula.parts()) append_names(part, names);
}

bool has_all_constants(const KnownSet& set, const Symbolic& formula) {
  const std::set<std::string> names = names_of(formula);
  return std::all_of(set.constants.begin(), set.constants.end(),
                     [&](const KnownConstant& constant) { return names.count(constant.name) > 0; });
}

/// The innermost part of the form that has all its constants, as a set of its own. For a phase function of k
/// = a g - b g^3 it is that polynomial. Empty if it is the whole form, or so simple that it occurs elsewhere.
std::optional<KnownSet> core_of(const KnownSet& set) {
  constexpr int least_operations = 3;
  Symbolic core = set.formula;
  for (bool is_innermost = false; !is_innermost;) {
    is_innermost = true;
    for (const Symbolic& part : core.parts()) {
      if (!has_all_constants(set, part)) continue;
      core = part;
      is_innermost = false;
      break;
    }
  }
  const std::set<std::string> names = names_of(core);
  KnownSet small = set;
  small.formula = core;
  std::erase_if(small.axes, [&](const KnownAxis& axis) { return names.count(axis.variable) == 0; });
  if (small.axes.empty() || small.axes.size() == set.axes.size()) return std::nullopt;
  return count_operations(core).total() < least_operations ? std::nullopt : std::optional(std::move(small));
}

/// Compares an expression with a form.
class ExpressionMatcher {
 public:
  ExpressionMatcher(const Symbolic& expression, const KnownSet& set, const std::vector<double>& constants,
                    const std::vector<double>& numbers)
      : set_(set),
        constants_(constants),
        numbers_(numbers),
        parts_(full_parts(expression, numbers)),
        comparison_(set, parts_) {
    append_parts({set.formula, constants}, allowed_);
  }

  std::optional<ExpressionMatch> form() const {
    if (comparison_.has({set_.formula, constants_})) return ExpressionMatch{set_.formula, constants_};
    const std::vector<double> published = published_values(set_);
    if (constants_ == published || !holds_changed(published) || !comparison_.has({set_.formula, published}))
      return std::nullopt;
    return ExpressionMatch{.form = set_.formula, .constants = published, .is_published = true};
  }

  /// The published constants are also right with half of the form, or another simple multiple: a factor may
  /// be folded in.
  std::optional<ExpressionMatch> multiple() const {
    if (constants_ != published_values(set_) || !comparison_.has_multiple({set_.formula, constants_}))
      return std::nullopt;
    return ExpressionMatch{set_.formula, constants_};
  }

  /// A part of the form alone is not a slip: the rest may be in another statement.
  std::optional<ExpressionMatch> replaced(const std::vector<std::size_t>& missing) const {
    if (comparison_.is_empty()) return std::nullopt;
    for (const std::size_t constant : missing) {
      for (const double number : parts_.back().numbers) {
        if (count_held({number}, numbers_) > 0) continue;
        std::vector<double> other = constants_;
        other[constant] = std::copysign(number, constants_[constant]);
        if (comparison_.has_other({set_.formula, other}, allowed_, same_curve))
          return ExpressionMatch{.form = set_.formula, .constants = other, .replaced = constant};
      }
    }
    return std::nullopt;
  }

  std::optional<ExpressionMatch> slipped() const {
    // Rounding hides a smaller difference.
    constexpr double hidden = 1e-4;
    if (comparison_.is_empty() || parts_.back().held < numbers_.size()) return std::nullopt;
    for (const Mutant& mutant : mutants_of(set_.formula))
      if (comparison_.has_other({mutant.formula, constants_}, allowed_, hidden))
        return ExpressionMatch{.form = mutant.formula, .constants = constants_, .slip = mutant.words};
    return std::nullopt;
  }

 private:
  /// Whether the expression has each number that differs from the published one. Otherwise it tells nothing
  /// about that number.
  bool holds_changed(const std::vector<double>& published) const {
    std::vector<double> changed;
    for (std::size_t i = 0; i < published.size(); ++i)
      if (constants_[i] != published[i]) changed.push_back(std::abs(constants_[i]));
    return !parts_.empty() && count_held(parts_.back().numbers, changed) == changed.size();
  }

  const KnownSet& set_;
  const std::vector<double>&constants_, &numbers_;
  std::vector<Part> parts_;
  CurveComparison comparison_;
  std::vector<Curve> allowed_;
};

}  // namespace

std::set<std::string> names_of(const Symbolic& formula) {
  std::set<std::string> names;
  append_names(formula, names);
  return names;
}

bool is_form(const Symbolic& expression, const KnownSet& set, const std::vector<double>& constants,
             const std::vector<double>& numbers) {
  return ExpressionMatcher(expression, set, constants, numbers).form().has_value();
}

std::optional<ExpressionMatch> match_expression(const Symbolic& expression, const KnownSet& set,
                                                const std::vector<double>& constants,
                                                const std::vector<double>& numbers,
                                                const std::vector<std::size_t>& missing) {
  const ExpressionMatcher whole(expression, set, constants, numbers);
  if (auto match = whole.form()) return match;
  if (missing.empty())
    if (auto match = whole.multiple()) return match;
  if (auto match = whole.replaced(missing)) return match;
  if (const auto small = core_of(set)) {
    const ExpressionMatcher core(expression, *small, constants, numbers);
    auto match = core.form();
    if (!match) match = core.replaced(missing);
    if (match) {
      match->form = set.formula;
      match->is_core = true;
    }
    if (match && match->replaced) return match;
    if (auto slip = whole.slipped()) return slip;
    return match;
  }
  return whole.slipped();
}

}  // namespace shadefit::lint
