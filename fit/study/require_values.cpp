#include "fit/study/require_values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fit/scalars/hinges.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The place of a node as text: "x = 0.5", or "line 3 of 'rows.csv'".
std::string place_of(const ReadStudy& study, const StudyNodes& nodes, std::size_t node) {
  if (study.rows)
    return "line " + std::to_string(line_of_row(*study.rows, node + 1)) + " of '" +
           study.rows->file.unescaped() + "'";
  std::vector<double> place;
  for (const auto& coordinate : nodes.coordinates) place.push_back(static_cast<double>(coordinate[node]));
  return to_text(study.axes, place);
}

/// The first node whose value fails the check, as text. Empty if all values pass.
template <class Passes>
std::string first_place(const ReadStudy& study, const std::vector<double>& values, const StudyNodes& nodes,
                        const Passes& passes) {
  const auto found = std::find_if_not(values.begin(), values.end(), passes);
  return found == values.end() ? ""
                               : place_of(study, nodes, static_cast<std::size_t>(found - values.begin()));
}

/// ", and acos takes -1 to 1"; empty for an operation that takes all numbers.
std::string numbers_taken_by(const Symbolic& operation) {
  const auto takes = [&](const char* numbers) { return ", and " + operation.name() + " takes " + numbers; };
  if (operation.kind() == Symbolic::Kind::real_power) return ", and a power takes a base of 0 or more";
  if (operation.kind() != Symbolic::Kind::function) return "";
  const std::string& name = operation.name();
  if (name == "acos" || name == "asin") return takes("-1 to 1");
  if (name == "log" || name == "log2") return takes("numbers above 0");
  if (name == "log1p") return takes("numbers above -1");
  return name == "sqrt" ? takes("0 and numbers above") : "";
}

/// Why a formula has no finite value: the operation that has none though its operands have, ": acos(1.2) is
/// nan, and acos takes -1 to 1". Empty inside an integral.
std::string reason_of(const Symbolic& formula, const std::function<double(const std::string&)>& value_of) {
  if (formula.kind() == Symbolic::Kind::integral) return "";
  if (formula.kind() == Symbolic::Kind::choice) {
    const bool is_first =
        evaluate<double>(formula.part(0), value_of) < evaluate<double>(formula.part(1), value_of);
    return reason_of(formula.part(is_first ? 2 : 3), value_of);
  }
  std::vector<Symbolic> values;
  for (const Symbolic& part : formula.parts()) {
    const double value = evaluate<double>(part, value_of);
    if (!std::isfinite(value)) return reason_of(part, value_of);
    values.push_back(Symbolic::number(to_text(value)));
  }
  const double value = evaluate<double>(formula, value_of);
  if (std::isfinite(value)) return "";  // as a double; a node may be wider
  return ": " + to_text(formula.with_parts(values)) + " is " +
         (std::isnan(value) ? "nan" : decimal(value, 6)) + numbers_taken_by(formula);
}

/// The same at a node, by its number.
std::string reason_at(const ReadStudy& study, const StudyNodes& nodes, std::size_t node) {
  return reason_of(study.target, [&](const std::string& name) {
    const std::vector<std::string> variables = variables_of(study.axes);
    const auto axis = static_cast<std::size_t>(std::ranges::find(variables, name) - variables.begin());
    return static_cast<double>(nodes.coordinates.at(axis)[node]);
  });
}

/// The form at parameters without a relation to each other: where it is 0 or infinite for these, it is for
/// nearly all.
Symbolic at_any_parameters(const ReadStudy& study) {
  std::vector<double> parameters;
  for (std::size_t i = 0; i < study.parameters.size(); ++i)
    parameters.push_back(std::sqrt(static_cast<double>(i) + 2) / 2);
  return at_parameters(study, study.form, parameters);
}

/// A zero of the target near which |form / target| grows without bound. Empty if there is none.
std::string zero_of_target(const ReadStudy& study) {
  const StudyAxis& axis = study.axes.front();
  const Symbolic form = at_any_parameters(study);
  for (double zero : zeros_of(study.target, axis)) {
    // Next to an end it is the end: sin(x) at pi.
    constexpr double end = 1e-12;
    const double length = axis.upper - axis.lower;
    if (zero - axis.lower < end * length) zero = axis.lower;
    if (axis.upper - zero < end * length) zero = axis.upper;
    const int inwards = zero < axis.upper ? 1 : -1;
    const auto ratio = [&](const char* distance) {
      const Decimal50 x =
          Decimal50(zero) + inwards * Decimal50(distance) * Decimal50(axis.upper - axis.lower);
      const auto at_x = [&](const std::string&) { return x; };
      return Decimal50(abs(in_50_digits(form, at_x) / in_50_digits(study.target, at_x)));
    };
    const Decimal50 far = ratio("1e-6"), near = ratio("1e-12");
    // From one distance to the other, a power above 1/6 grows more than this; a logarithm doubles.
    constexpr int growth = 10;
    if (isnan(far) || isnan(near) || near <= growth * far) continue;
    return axis.variable + " = " + to_text(zero);
  }
  return "";
}

/// A place that is approached: on each axis from an end, or the same at all distances.
struct Approach {
  std::vector<double> from;
  std::vector<double> direction;  ///< for the distance 1; 0 where an axis takes no part
};

/// The variables of a study at a distance from a place.
template <class T>
auto place_near(const ReadStudy& study, const Approach& approach, const T& distance) {
  return [&study, &approach, distance](const std::string& name) {
    std::size_t i = 0;
    while (study.axes[i].variable != name) ++i;
    return T(T(approach.from[i]) + distance * T(approach.direction[i]));
  };
}

/// |formula| at a distance from a place: in 50 digits, if double and long double do not tell it alike.
Decimal50 size_near(const ReadStudy& study, const Symbolic& formula, const Approach& approach,
                    const Decimal50& distance) {
  const auto narrow = evaluate<double>(formula, place_near(study, approach, static_cast<double>(distance)));
  const auto wide =
      evaluate<long double>(formula, place_near(study, approach, static_cast<long double>(distance)));
  constexpr long double alike = 1e-6L;  // a growth by half is asked for
  if (wide != 0 && std::abs(narrow - wide) <= alike * std::abs(wide)) return abs(Decimal50(wide));
  return abs(in_50_digits(formula, place_near(study, approach, distance)));
}

/// The density there, as a factor of the integral.
Decimal50 density_near(const ReadStudy& study, const Approach& approach, const Decimal50& distance) {
  Decimal50 product = 1;
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    const Decimal50 x = approach.from[i] + distance * approach.direction[i];
    product *= in_50_digits(study.axes[i].density, [&](const std::string&) { return x; });
  }
  return product;
}

/// Whether a formula grows without bound, and for least squares so fast that the integral of its square does
/// not converge. d^n, the volume within a distance d on n axes, has to fall faster than the square grows.
bool is_too_large(const ReadStudy& study, const Symbolic& formula, const Approach& approach, Norm norm) {
  const auto n = std::count_if(approach.direction.begin(), approach.direction.end(),
                               [](double direction) { return direction != 0; });
  const Decimal50 far("1e-6"), near("1e-12"), nearest("1e-24");
  const Decimal50 at_far = size_near(study, formula, approach, far),
                  at_near = size_near(study, formula, approach, near);
  // From each distance to the next a logarithm doubles; what is bounded changes by a share of 1e-6, but a
  // lobe may lie between two of them. It falls faster than any power, and from above.
  constexpr double grown = 1.5, power = 1e100, constant = 0.999;
  if (!(at_near > grown * at_far)) return false;
  const Decimal50 at_nearest = size_near(study, formula, approach, nearest);
  if (!(at_nearest > grown * at_near)) return false;
  if (at_near > power * at_far && at_nearest < power * at_near) return false;
  if (norm == Norm::minimax) return true;
  const Decimal50 square_at_far =
      at_far * at_far * pow(far, static_cast<int>(n)) * density_near(study, approach, far);
  const Decimal50 square_at_near =
      at_near * at_near * pow(near, static_cast<int>(n)) * density_near(study, approach, near);
  return square_at_near > constant * square_at_far;
}

/// The ways to the border of the range: to each end of one axis, and of several at once. An axis that takes
/// no part stays at a place inside that has no relation to the others.
std::vector<Approach> approaches(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges) {
  std::vector<Approach> result{{{}, {}}};
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    const StudyAxis& axis = study.axes[i];
    const double length = axis.upper - axis.lower;
    const double inside = axis.lower + length * (0.31830988618 + 0.0915 * static_cast<double>(i));
    std::vector<Approach> longer;
    for (const Approach& approach : result) {
      const auto append = [&](double from, double direction) {
        longer.push_back(approach);
        longer.back().from.push_back(from);
        longer.back().direction.push_back(direction);
      };
      append(inside, 0);
      append(axis.lower, length);
      append(axis.upper, -length);
    }
    result = std::move(longer);
  }
  result.erase(result.begin());  // the place inside
  if (study.axes.size() == 1) {
    const StudyAxis& axis = study.axes.front();
    for (const StudyEdge& edge : edges.front()) {
      if (edge.power == 1 || edge.at == axis.lower || edge.at == axis.upper) continue;
      // The way stays inside the range.
      result.push_back({{edge.at}, {axis.lower - edge.at}});
      result.push_back({{edge.at}, {axis.upper - edge.at}});
    }
  }
  return result;
}

}  // namespace

void require_finite(const ReadStudy& study, const Symbolic& formula, const std::string& option, Norm norm,
                    const std::vector<std::vector<StudyEdge>>& edges) {
  if (study.rows || study.error == Error::relative) return;
  const Symbolic weighted = study.weight * formula;
  const std::vector<Hinge> hinges = hinges_of(weighted);
  // Without a pole nothing is infinite.
  if (std::none_of(hinges.begin(), hinges.end(), [](const Hinge& hinge) { return hinge.is_pole; })) return;
  for (const Approach& approach : approaches(study, edges)) {
    if (!is_too_large(study, weighted, approach, norm)) continue;
    std::string place;
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
      if (approach.direction[i] == 0) continue;
      place += (place.empty() ? "" : ", ") + study.axes[i].variable + " = " + to_text(approach.from[i]);
    }
    throw UserError(option + (is_one(study.weight) ? "" : " times --weight") + " is not finite at " + place +
                    (norm == Norm::minimax ? ", so no constants have a largest error"
                                           : ", and the integral of its square does not converge there") +
                    "; leave that place out of --over");
  }
}

void require_finite_form(const ReadStudy& study, Norm norm) {
  require_finite(study, at_any_parameters(study), "--form", norm, edges_of(study));
}

void require_dependence(const ReadStudy& study, const std::vector<bool>& is_open) {
  for (std::size_t i = 0; i < is_open.size(); ++i) {
    if (!is_open[i]) continue;
    const std::string& name = study.parameters[i];
    for (const Symbolic& kink : moving_kinks(study)) {
      if (free_variables(kink).contains(name))
        throw UserError("--form has no derivative by its parameter '" + name +
                        "', which only moves a jump: hold it, for example by --fix " + name + "=0.5");
    }
    throw UserError("--form does not depend on its parameter '" + name + "'");
  }
}

std::vector<double> require_values(const ReadStudy& study, const StudyNodes& nodes) {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  // A row of weight 0 would still count as one in the standard errors.
  const auto is_weight = [&](double value) {
    return (study.rows ? value > 0 : value >= 0) && std::isfinite(value);
  };
  const std::vector<double> target =
      study.rows ? study.rows->value : values_at_nodes(study, study.target, nodes);
  if (const auto node =
          static_cast<std::size_t>(std::ranges::find_if_not(target, is_finite) - target.begin());
      node < target.size())
    throw UserError("--target has no finite value at " + place_of(study, nodes, node) +
                    (study.rows ? "" : reason_at(study, nodes, node)));
  const std::vector<double> weights =
      is_one(study.weight) ? std::vector<double>{} : values_at_nodes(study, study.weight, nodes);
  if (const auto place = first_place(study, weights, nodes, is_weight); !place.empty())
    throw UserError(study.rows ? "--weight must be finite and greater than 0; it is not at " + place
                               : "--weight is negative, or has no finite value, at " + place);
  const auto is_zero = [](double value) { return value == 0; };
  if (!weights.empty() && std::ranges::all_of(weights, is_zero))
    throw UserError("--weight '" + to_text(study.weight) + "' is 0 in the whole range: no error would count");
  if (study.error == Error::absolute) return target;
  auto place = first_place(study, target, nodes, [&](double value) { return is_finite(1 / value); });
  if (place.empty() && study.axes.size() == 1 && !study.rows) place = zero_of_target(study);
  if (!place.empty())
    throw UserError("--error 'relative' divides by the target, which is 0 at " + place +
                    (study.rows ? ": leave that row out" : ": leave that place out of --over"));
  return target;
}

}  // namespace shadefit
