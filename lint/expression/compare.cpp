#include "lint/expression/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lint/expression/absorbed.hpp"
#include "lint/expression/mutants.hpp"

namespace shadefit::lint {
namespace {

using Values = std::vector<double>;
using Places = std::vector<std::vector<double>>;

/// Published digits and their floats differ by 1e-7, and polynomials with large terms enlarge that.
constexpr double same_curve = 1e-5;

/// Numbers that are the same to all digits of float32 differ by less than this, relatively.
constexpr double same_number = 1e-6;

bool is_near(double a, double b, double slack) {
  return std::abs(a - b) <= slack * std::max(std::abs(a), std::abs(b));
}

/// How many of the wanted numbers are among these, to the accuracy of a float.
std::size_t count_held(const std::vector<double>& numbers, const std::vector<double>& wanted) {
  return static_cast<std::size_t>(std::ranges::count_if(wanted, [&](double value) {
    return std::ranges::any_of(numbers, [&](double number) { return is_near(number, value, same_number); });
  }));
}

/// A part of an expression with what it holds.
struct Part {
  Symbolic formula;
  std::set<std::string> names;
  std::vector<double> numbers;
  std::size_t held = 0;  ///< how many of the wanted numbers
};

/// All parts of an expression, inner ones first.
Part collect(const Symbolic& formula, const std::vector<double>& wanted, std::vector<Part>& parts) {
  Part whole{formula, {}, {}};
  if (formula.kind() == Symbolic::Kind::variable) whole.names.insert(formula.name());
  if (formula.kind() == Symbolic::Kind::number) whole.numbers.push_back(constant<double>(formula.name()));
  for (const Symbolic& inner : formula.parts()) {
    const Part part = collect(inner, wanted, parts);
    whole.names.insert(part.names.begin(), part.names.end());
    whole.numbers.insert(whole.numbers.end(), part.numbers.begin(), part.numbers.end());
  }
  whole.held = count_held(whole.numbers, wanted);
  if (!formula.parts().empty()) parts.push_back(whole);
  return whole;
}

/// The parts that hold as many of the wanted numbers as the whole does, inner ones first. Empty if it holds
/// none.
std::vector<Part> full_parts(const Symbolic& formula, const std::vector<double>& wanted) {
  std::vector<Part> parts;
  const std::size_t held = collect(formula, wanted, parts).held;
  std::erase_if(parts, [&](const Part& part) { return part.held < held || held == 0; });
  return parts;
}

/// Places inside the ranges, not in simple ratios to each other: multiples of the generalised golden ratio
/// (the R sequence of M. Roberts, 2018).
Places places_in(const std::vector<KnownAxis>& axes) {
  constexpr int count = 9;
  constexpr std::array<double, 3> steps{0.6180339887498949, 0.7548776662466927, 0.5698402909980532};
  Places places;
  for (int i = 1; i <= count; ++i) {
    std::vector<double>& place = places.emplace_back();
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const double share = std::fmod(i * steps[axis], 1.0);
      place.push_back(axes[axis].lower + (axes[axis].upper - axes[axis].lower) * share);
    }
  }
  return places;
}

/// Places on both sides of the thresholds of the form, in turn at one of the other places. All of those may
/// lie on one side. They are far from the threshold, because another near one may join the branches better.
Places places_beside_thresholds(const KnownSet& set, const Places& places) {
  constexpr double far = 2;
  Places beside;
  for (std::size_t axis = 0; axis < set.axes.size(); ++axis) {
    const KnownAxis& range = set.axes[axis];
    for (const double threshold : thresholds_of(set, set.formula, published_values(set), range.variable)) {
      for (const double value : {threshold / far, threshold * far}) {
        if (!(range.lower < value && value < range.upper)) continue;
        beside.push_back(places[beside.size() % places.size()]);
        beside.back()[axis] = value;
      }
    }
  }
  return beside;
}

/// Places near the lower and the upper ends, where a lost term may be all that is left.
Places ends_of(const std::vector<KnownAxis>& axes) {
  Places ends(2);
  constexpr double near = 1e-4;
  for (const KnownAxis& axis : axes) {
    ends[0].push_back(axis.lower + (axis.upper - axis.lower) * near);
    ends[1].push_back(axis.upper - (axis.upper - axis.lower) * near);
  }
  return ends;
}

/// The values of a formula at places. Its names are in the order of a place's numbers.
Values values_at(const Symbolic& formula, const std::vector<std::string>& names, const Places& places) {
  Values values;
  for (const std::vector<double>& place : places) {
    values.push_back(evaluate<double>(formula, [&](const std::string& name) {
      const auto found = std::ranges::find(names, name);
      return found == names.end() ? std::nan("") : place[static_cast<std::size_t>(found - names.begin())];
    }));
  }
  return values;
}

double largest(const Values& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Whether the first `count` values of two curves agree, to `slack` of the largest. Places where both have no
/// value do not count.
bool are_same(const Values& a, const Values& b, std::size_t count, double slack) {
  const double most = largest(b);
  std::size_t finite = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(a[i]) != std::isfinite(b[i])) return false;
    if (!std::isfinite(b[i])) continue;
    ++finite;
    if (!(std::abs(a[i] - b[i]) <= slack * most)) return false;
  }
  return 2 * finite > count;
}

/// If the first `count` values are a simple multiple (1/2, pi, 1/ln 2) of another curve, the values divided
/// by that factor. Otherwise empty.
std::optional<Values> without_factor(const Values& values, const Values& of, std::size_t count) {
  const auto largest_of = std::max_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(count),
                                           [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double factor = values[static_cast<std::size_t>(largest_of - of.begin())] / *largest_of;
  if (!std::isfinite(factor) || factor == 0 || !is_common_number(factor)) return std::nullopt;
  Values divided = values;
  for (double& value : divided) value /= factor;
  return divided;
}

/// A form of the variables and constants of a set, with values of the constants.
struct Curve {
  Symbolic form;
  std::vector<double> constants;
};

/// The curves of the parts of an expression, for each order of their names, and with numbers for variables.
class CurveComparison {
 public:
  CurveComparison(const KnownSet& set, const std::vector<Part>& parts) : set_(set) {
    Places places = places_in(set.axes);
    for (std::vector<double>& place : places_beside_thresholds(set, places))
      places.push_back(std::move(place));
    inner_places_ = places.size();
    for (std::vector<double>& end : ends_of(set.axes)) places.push_back(std::move(end));
    sample(parts, places, {});
    if (set.axes.size() < 2) return;
    // A number of the expression may be the value of a variable: g = 0.76. Not at the ends: there, as at 0,
    // the curve may not depend on all constants.
    for (std::size_t axis = 0; axis < set.axes.size(); ++axis) {
      for (const double number : parts.empty() ? Values{} : parts.back().numbers) {
        if (number <= set.axes[axis].lower || number >= set.axes[axis].upper) continue;
        Places held = places;
        for (std::vector<double>& place : held) place[axis] = number;
        sample(parts, held, axis);
      }
    }
  }

  bool is_empty() const { return sampled_.empty(); }

  /// Whether a part has this curve inside the ranges. Their ends are left out, because programs have branches
  /// there.
  bool has(const Curve& curve) const {
    return std::ranges::any_of(sampled_, [&](const Sampled& sampled) {
      return is_there(sampled, values_of(curve, sampled.places), inner_places_);
    });
  }

  /// Whether a part has a simple multiple of this curve inside the ranges: exp2(-1 - a c) is half of exp2(-a
  /// c).
  bool has_multiple(const Curve& curve) const {
    return std::ranges::any_of(sampled_, [&](const Sampled& sampled) {
      const Values values = values_of(curve, sampled.places);
      return largest(values) > 0 && std::ranges::any_of(sampled.curves, [&](const Values& other) {
               const auto divided = without_factor(other, values, inner_places_);
               return divided && are_same(*divided, values, inner_places_, same_curve);
             });
    });
  }

  /// Whether a part has this curve, also at the ends, and the curve differs from all allowed ones by more
  /// than `hidden` of the largest value.
  bool has_other(const Curve& curve, const std::vector<Curve>& allowed, double hidden) const {
    return std::ranges::any_of(sampled_, [&](const Sampled& sampled) {
      const Values values = values_of(curve, sampled.places);
      return is_there(sampled, values, values.size()) &&
             std::ranges::none_of(allowed, [&](const Curve& other) {
               return are_same(values, values_of(other, sampled.places), values.size(), hidden);
             });
    });
  }

 private:
  struct Sampled {
    Places places;
    std::vector<Values> curves;
  };

  /// Also for the curve times the factor of the set.
  bool is_there(const Sampled& sampled, const Values& values, std::size_t count) const {
    const auto has = [&](const Values& wanted) {
      return std::ranges::any_of(
          sampled.curves, [&](const Values& other) { return are_same(other, wanted, count, same_curve); });
    };
    if (!(largest(values) > 0)) return false;
    if (has(values)) return true;
    if (set_.times.empty()) return false;
    // A sum of multiples is a multiple too.
    Values multiple = values;
    for (double& value : multiple) value *= set_.factor;
    return has(multiple);
  }

  /// `held`: the variable that has a number's value at all these places.
  void sample(const std::vector<Part>& parts, const Places& places, std::optional<std::size_t> held) {
    Sampled sampled{places, {}};
    Places free = places;
    if (held)
      for (std::vector<double>& place : free) place.erase(place.begin() + static_cast<std::ptrdiff_t>(*held));
    for (const Part& part : parts) {
      if (part.names.size() != set_.axes.size() - (held ? 1 : 0)) continue;
      std::vector<std::string> order(part.names.begin(), part.names.end());
      do {
        sampled.curves.push_back(values_at(part.formula, order, free));
      } while (std::next_permutation(order.begin(), order.end()));
    }
    if (!sampled.curves.empty()) sampled_.push_back(std::move(sampled));
  }

  Values values_of(const Curve& curve, Places places) const {
    std::vector<std::string> names;
    for (const KnownAxis& axis : set_.axes) names.push_back(axis.variable);
    for (std::size_t i = 0; i < set_.constants.size(); ++i) {
      names.push_back(set_.constants[i].name);
      for (std::vector<double>& place : places) place.push_back(curve.constants[i] / set_.factor);
    }
    return values_at(curve.form, names, places);
  }

  const KnownSet& set_;
  std::size_t inner_places_ = 0;
  std::vector<Sampled> sampled_;
};

/// The form and all its parts.
void append_parts(const Curve& curve, std::vector<Curve>& parts) {
  parts.push_back(curve);
  for (const Symbolic& part : curve.form.parts()) append_parts({part, curve.constants}, parts);
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

/// Adds the numbers with which an expression compares something.
void append_thresholds(const Symbolic& expression, std::vector<double>& thresholds) {
  if (expression.kind() == Symbolic::Kind::choice)
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      if (is_number(expression.part(side)))
        thresholds.push_back(evaluate<double>(expression.part(side), [](const auto&) { return 0.0; }));
  for (const Symbolic& part : expression.parts()) append_thresholds(part, thresholds);
}

/// Whether a form compares something with this name.
bool compares_with(const Symbolic& form, const std::string& name) {
  const auto is_name = [&](const Symbolic& side) {
    return side.kind() == Symbolic::Kind::variable && side.name() == name;
  };
  if (form.kind() == Symbolic::Kind::choice && (is_name(form.part(0)) || is_name(form.part(1)))) return true;
  return std::ranges::any_of(form.parts(), [&](const Symbolic& part) { return compares_with(part, name); });
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

  /// The published constants are also right with half of the form, or another simple multiple: a factor may
  /// be folded in.
  std::optional<ExpressionMatch> multiple() const {
    if (constants_ != published_values(set_) || !comparison_.has_multiple({set_.formula, constants_}))
      return std::nullopt;
    return ExpressionMatch{set_.formula, constants_};
  }

  /// The form with another number as a missing threshold. The values at some places do not show it, because
  /// the branches nearly join there.
  std::optional<ExpressionMatch> compared(const std::vector<std::size_t>& missing) const {
    constexpr double near = 0.05;  // nearer ones may join the branches better
    if (comparison_.is_empty()) return std::nullopt;
    std::vector<double> thresholds;
    append_thresholds(parts_.back().formula, thresholds);
    for (const std::size_t constant : missing) {
      if (!compares_with(set_.formula, set_.constants[constant].name)) continue;
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

  /// The form with an inner part computed elsewhere, perhaps with a slip.
  std::optional<ExpressionMatch> absorbed(const Symbolic& expression) const;

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
  /// What is right: the form and its parts, without a variable that is 1, and with inner parts elsewhere.
  std::vector<Curve> allowed_curves() const {
    std::vector<Curve> allowed;
    append_parts({set_.formula, constants_}, allowed);
    for (const KnownAxis& axis : set_.axes)
      if (axis.lower <= 1 && 1 <= axis.upper)
        allowed.push_back(
            {with_part(set_.formula, Symbolic::variable(axis.variable), Symbolic::number("1")), constants_});
    for (const Absorbed& one : absorbed_parts())
      allowed.push_back(
          {with_part(one.outer.formula, Symbolic::variable(one.name), Symbolic::variable(one.variable)),
           constants_});
    return allowed;
  }

  /// The inner parts whose constants are not in the expression.
  std::vector<Absorbed> absorbed_parts() const {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < constants_.size(); ++i)
      if (count_held({std::abs(constants_[i])}, numbers_) == 0) missing.push_back(i);
    return absorbed_in(set_, constants_, missing);
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
  std::vector<Part> parts_;
  CurveComparison comparison_;
};

std::optional<ExpressionMatch> ExpressionMatcher::absorbed(const Symbolic& expression) const {
  constexpr int least_operations = 3;  // simpler ones occur elsewhere
  if (parts_.empty()) return std::nullopt;
  for (const Absorbed& one : absorbed_parts()) {
    if (count_operations(one.outer.formula).total() < least_operations) continue;
    const ExpressionMatcher outer(expression, one.outer, constants_, numbers_);
    auto match = outer.form();
    if (!match) match = outer.slipped();
    if (!match) continue;
    match->form = with_part(match->form, Symbolic::variable(one.name), one.inner);
    match->is_core = match->slip.empty();
    return match;
  }
  return std::nullopt;
}

}  // namespace

std::set<std::string> names_of(const Symbolic& formula) {
  std::set<std::string> names;
  if (formula.kind() == Symbolic::Kind::variable) names.insert(formula.name());
  for (const Symbolic& part : formula.parts()) names.merge(names_of(part));
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
  if (missing.empty())
    if (auto match = whole.multiple()) return match;
  if (auto match = whole.replaced(missing)) return match;
  if (auto match = whole.absorbed(expression)) return match;
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
