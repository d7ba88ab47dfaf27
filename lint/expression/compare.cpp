#include "lint/expression/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "lint/expression/curve_comparison.hpp"

namespace shadefit::lint {
namespace {

/// A formula and all its parts, each before its own.
std::vector<Symbolic> all_parts(const Symbolic& formula) {
  std::vector<Symbolic> parts{formula};
  for (const Symbolic& part : formula.parts()) std::ranges::copy(all_parts(part), std::back_inserter(parts));
  return parts;
}

bool has_all_constants(const KnownSet& set, const Symbolic& formula) {
  const std::set<std::string> names = names_of(formula);
  return std::ranges::all_of(set.constants,
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

/// The formula with 1 for a variable.
Symbolic with_one(const Symbolic& formula, const std::string& variable) {
  return evaluate<Symbolic>(formula, [&](const std::string& name) {
    return name == variable ? Symbolic::number("1") : Symbolic::variable(name);
  });
}

/// The formula with x for each power of a variable x: a program may compute that elsewhere.
Symbolic without_inner_powers(const Symbolic& formula) {
  if (formula.kind() == Symbolic::Kind::real_power && formula.part(0).kind() == Symbolic::Kind::variable)
    return formula.part(0);
  std::vector<Symbolic> parts = formula.parts();
  for (Symbolic& part : parts) part = without_inner_powers(part);
  return formula.with_parts(std::move(parts));
}

/// The numbers with which an expression compares something.
std::vector<double> numbers_compared_in(const Symbolic& expression) {
  std::vector<double> numbers;
  for (const Symbolic& part : all_parts(expression))
    for (std::size_t side = 0; part.kind() == Symbolic::Kind::choice && side < 2; ++side)
      if (part.part(side).is_of_numbers())
        numbers.push_back(evaluate<double>(part.part(side), [](const auto&) { return 0.0; }));
  return numbers;
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
        comparison_(set, parts_) {}

  std::optional<ExpressionMatch> form() const {
    if (comparison_.has({set_.formula, constants_})) return ExpressionMatch{set_.formula, constants_};
    const std::vector<double> published = published_values(set_);
    if (constants_ == published || !holds_changed(published) || !comparison_.has({set_.formula, published}))
      return std::nullopt;
    return ExpressionMatch{.form = set_.formula, .constants = published, .is_published = true};
  }

  /// The form with another number as a missing threshold. The values at some places do not show it, because
  /// the branches nearly join there.
  std::optional<ExpressionMatch> compared(const std::vector<std::size_t>& missing) const {
    constexpr double near = 0.05;  // nearer ones may join the branches better
    if (comparison_.is_empty()) return std::nullopt;
    const std::vector<double> thresholds = numbers_compared_in(parts_.back().formula);
    for (const std::size_t constant : missing) {
      if (thresholds_of(set_, set_.formula, constants_, set_.constants[constant].name).empty()) continue;
      for (const double number : thresholds) {
        if (is_near(number, constants_[constant], near)) continue;
        std::vector<double> other = constants_;
        other[constant] = number;
        if (comparison_.has({set_.formula, other}))
          return ExpressionMatch{.form = set_.formula, .constants = other, .replaced = constant};
      }
    }
    return std::nullopt;
  }

  /// A part of the form alone is not a slip: the rest may be in another statement.
  std::optional<ExpressionMatch> replaced(const std::vector<std::size_t>& missing) const {
    if (comparison_.is_empty()) return std::nullopt;
    const std::vector<Curve> allowed = allowed_curves();
    for (const std::size_t constant : missing) {
      for (const double number : parts_.back().numbers) {
        if (count_held({number}, numbers_) > 0) continue;
        std::vector<double> other = constants_;
        other[constant] = std::copysign(number, constants_[constant]);
        if (comparison_.has_other({set_.formula, other}, allowed, same_curve))
          return ExpressionMatch{.form = set_.formula, .constants = other, .replaced = constant};
      }
    }
    return std::nullopt;
  }

  std::optional<ExpressionMatch> slipped() const {
    // Rounding hides a smaller difference.
    constexpr double hidden = 1e-4;
    if (comparison_.is_empty() || parts_.back().held < numbers_.size()) return std::nullopt;
    const std::vector<Curve> allowed = allowed_curves();
    for (std::size_t i = 0; i < constants_.size(); ++i)
      for (std::size_t j = i + 1; j < constants_.size(); ++j)
        for (const std::vector<double>& other : exchanged(i, j))
          if (comparison_.has_other({set_.formula, other}, allowed, hidden))
            return ExpressionMatch{.form = set_.formula,
                                   .constants = other,
                                   .slip = fmt::format("{} and {} exchanged", set_.constants[i].printed,
                                                       set_.constants[j].printed)};
    for (const Mutant& mutant : mutants_of(set_.formula))
      if (has_variable(mutant.formula) &&
          comparison_.has_other({mutant.formula, constants_}, allowed, hidden))
        return ExpressionMatch{.form = mutant.formula, .constants = constants_, .slip = mutant.words};
    return std::nullopt;
  }

 private:
  /// What is right: the form and its parts, and the form without inner powers, or with 1 for a variable.
  std::vector<Curve> allowed_curves() const {
    std::vector<Curve> allowed;
    for (const Symbolic& part : all_parts(set_.formula)) allowed.push_back({part, constants_});
    allowed.push_back({without_inner_powers(set_.formula), constants_});
    for (const KnownAxis& axis : set_.axes)
      if (axis.lower <= 1 && 1 <= axis.upper)
        allowed.push_back({with_one(set_.formula, axis.variable), constants_});
    return allowed;
  }

  /// Whether the expression has each number that differs from the published one. Otherwise it tells nothing
  /// about that number.
  bool holds_changed(const std::vector<double>& published) const {
    std::vector<double> changed;
    for (std::size_t i = 0; i < published.size(); ++i)
      if (constants_[i] != published[i]) changed.push_back(std::abs(constants_[i]));
    return !parts_.empty() && count_held(parts_.back().numbers, changed) == changed.size();
  }

  /// The constants with two of them exchanged: each with its sign, and with that of its new place.
  std::vector<std::vector<double>> exchanged(std::size_t i, std::size_t j) const {
    if (std::abs(constants_[i]) == std::abs(constants_[j])) return {};
    std::vector<double> moved = constants_;
    std::swap(moved[i], moved[j]);
    std::vector<double> signed_there = moved;
    for (const std::size_t k : {i, j}) signed_there[k] = std::copysign(moved[k], constants_[k]);
    return {signed_there, moved};
  }

  /// Without one, a curve is a number, as the result of a clamp may be.
  bool has_variable(const Symbolic& formula) const {
    const std::set<std::string> names = names_of(formula);
    return std::ranges::any_of(set_.axes,
                               [&](const KnownAxis& axis) { return names.contains(axis.variable); });
  }

  const KnownSet& set_;
  const std::vector<double>&constants_, &numbers_;
  std::vector<ExpressionPart> parts_;
  CurveComparison comparison_;
};

}  // namespace

std::set<std::string> names_of(const Symbolic& formula) {
  std::set<std::string> names;
  for (const Symbolic& part : all_parts(formula))
    if (part.kind() == Symbolic::Kind::variable) names.insert(part.name());
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
  if (auto match = whole.compared(missing)) return match;
  if (auto match = whole.form()) return match;
  if (auto match = whole.replaced(missing)) return match;
  if (const auto core = core_of(set)) {
    if (auto match = ExpressionMatcher(expression, *core, constants, numbers).replaced(missing)) {
      match->form = set.formula;
      return match;
    }
  }
  return whole.slipped();
}

}  // namespace shadefit::lint
