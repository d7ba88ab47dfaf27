#include "lint/expression/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "lint/expression/mutants.hpp"

namespace shadefit::lint {
namespace {

/// Numbers of full float32 digits are nearer to each other than this.
constexpr double same_number = 1e-6;

bool is_near(double a, double b, double slack) {
  return std::abs(a - b) <= slack * std::max(std::abs(a), std::abs(b));
}

/// A part of an expression with what it holds.
struct Part {
  Symbolic formula;
  std::set<std::string> names;
  std::vector<double> numbers;
  std::size_t held = 0;  ///< how many of the wanted numbers
};

std::size_t count_held(const std::vector<double>& numbers, const std::vector<double>& wanted) {
  return static_cast<std::size_t>(std::count_if(wanted.begin(), wanted.end(), [&](double value) {
    return std::any_of(numbers.begin(), numbers.end(),
                       [&](double number) { return is_near(number, value, same_number); });
  }));
}

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

/// The parts that hold as many of the wanted numbers as the whole does.
std::vector<Part> full_parts(const Symbolic& formula, const std::vector<double>& wanted) {
  std::vector<Part> parts;
  const std::size_t held = collect(formula, wanted, parts).held;
  std::erase_if(parts, [&](const Part& part) { return part.held < held || held == 0; });
  return parts;
}

/// Places inside the ranges, in no simple ratio to each other: multiples of the golden ratio and its kin (the
/// R sequence of M. Roberts, 2018).
std::vector<std::vector<double>> places_in(const std::vector<KnownAxis>& axes) {
  constexpr int count = 9;
  constexpr std::array<double, 3> steps{0.6180339887498949, 0.7548776662466927, 0.5698402909980532};
  std::vector<std::vector<double>> places;
  for (int i = 1; i <= count; ++i) {
    std::vector<double> place;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const double share = std::fmod(i * steps[axis], 1.0);
      place.push_back(axes[axis].lower + (axes[axis].upper - axes[axis].lower) * share);
    }
    places.push_back(std::move(place));
  }
  return places;
}

using Values = std::vector<double>;

/// The values of a formula at places, its names in the order of the numbers of a place.
Values values_at(const Symbolic& formula, const std::vector<std::string>& names,
                 const std::vector<std::vector<double>>& places) {
  Values values;
  for (const std::vector<double>& place : places) {
    values.push_back(evaluate<double>(formula, [&](const std::string& name) {
      const auto found = std::find(names.begin(), names.end(), name);
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

/// Whether two curves agree, to `slack` of the largest value. Places where both have no value do not count.
bool are_same(const Values& a, const Values& b, double slack) {
  const double most = largest(b);
  std::size_t finite = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isfinite(a[i]) != std::isfinite(b[i])) return false;
    if (!std::isfinite(b[i])) continue;
    ++finite;
    if (!(std::abs(a[i] - b[i]) <= slack * most)) return false;
  }
  return 2 * finite > a.size();
}

/// The curves of the parts of an expression at the same places as the form.
struct Sampled {
  std::vector<std::vector<double>> places;
  std::vector<Values> curves;  ///< of each part, in each order of its names
};

/// Compares curves at a few places.
class CurveComparison {
 public:
  CurveComparison(const KnownSet& set, const std::vector<Part>& parts) : set_(set) {
    const std::vector<std::vector<double>> places = places_in(set.axes);
    sample(parts, places, {});
    if (set.axes.size() < 2) return;
    // A number of the expression may be the value of a variable: g = 0.76.
    for (std::size_t axis = 0; axis < set.axes.size(); ++axis) {
      for (const double number : parts.empty() ? Values{} : parts.back().numbers) {
        if (number < set.axes[axis].lower || number > set.axes[axis].upper) continue;
        std::vector<std::vector<double>> held = places;
        for (std::vector<double>& place : held) place[axis] = number;
        sample(parts, held, axis);
      }
    }
  }

  bool is_empty() const { return sampled_.empty(); }

  /// Whether a part has the values of a form that is not the same as one of `others`.
  bool has(const Symbolic& form, const std::vector<double>& constants,
           const std::vector<std::pair<Symbolic, std::vector<double>>>& others = {}) const {
    // Digits of floats and published digits differ by 1e-7, and polynomials with large terms enlarge that.
    constexpr double slack = 1e-5;
    // A difference that is less is none: rounding hides it.
    constexpr double hidden = 1e-4;
    return std::any_of(sampled_.begin(), sampled_.end(), [&](const Sampled& sampled) {
      const Values curve = values_of(form, constants, sampled.places);
      if (!(largest(curve) > 0)) return false;
      const bool is_there = std::any_of(sampled.curves.begin(), sampled.curves.end(),
                                        [&](const Values& other) { return are_same(other, curve, slack); });
      return is_there && std::none_of(others.begin(), others.end(), [&](const auto& other) {
               return are_same(curve, values_of(other.first, other.second, sampled.places), hidden);
             });
    });
  }

 private:
  /// `held`: the variable whose value is a number there.
  void sample(const std::vector<Part>& parts, const std::vector<std::vector<double>>& places,
              std::optional<std::size_t> held) {
    Sampled sampled{places, {}};
    std::vector<std::vector<double>> free = places;
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

  Values values_of(const Symbolic& form, const std::vector<double>& constants,
                   std::vector<std::vector<double>> places) const {
    std::vector<std::string> names;
    for (const KnownAxis& axis : set_.axes) names.push_back(axis.variable);
    for (std::size_t i = 0; i < set_.constants.size(); ++i) {
      names.push_back(set_.constants[i].name);
      for (std::vector<double>& place : places) place.push_back(constants[i]);
    }
    return values_at(form, names, places);
  }

  const KnownSet& set_;
  std::vector<Sampled> sampled_;
};

/// The form and all its parts.
void append_parts(const Symbolic& form, const std::vector<double>& constants,
                  std::vector<std::pair<Symbolic, std::vector<double>>>& parts) {
  parts.emplace_back(form, constants);
  for (const Symbolic& part : form.parts()) append_parts(part, constants, parts);
}

}  // namespace

std::optional<ExpressionMatch> match_expression(const Symbolic& expression, const KnownSet& set,
                                                const std::vector<double>& constants,
                                                const std::vector<double>& numbers,
                                                const std::vector<std::size_t>& missing) {
  const std::vector<Part> parts = full_parts(expression, numbers);
  const CurveComparison comparison(set, parts);
  if (comparison.is_empty()) return std::nullopt;
  if (comparison.has(set.formula, constants)) return ExpressionMatch{set.formula, constants};
  // A part of the form alone is no slip: the rest may stand in another statement.
  std::vector<std::pair<Symbolic, std::vector<double>>> allowed;
  append_parts(set.formula, constants, allowed);
  for (const std::size_t constant : missing) {
    for (const double number : parts.back().numbers) {
      if (count_held({number}, numbers) > 0) continue;
      std::vector<double> other = constants;
      other[constant] = std::copysign(number, constants[constant]);
      if (comparison.has(set.formula, other, allowed))
        return ExpressionMatch{.form = set.formula, .constants = other, .replaced = constant};
    }
  }
  if (parts.back().held < numbers.size()) return std::nullopt;
  for (const Mutant& mutant : mutants_of(set.formula))
    if (comparison.has(mutant.formula, constants, allowed))
      return ExpressionMatch{mutant.formula, constants, mutant.words};
  return std::nullopt;
}

}  // namespace shadefit::lint
