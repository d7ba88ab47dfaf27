#include "lint/expression/curve_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace shadefit::lint {
namespace {

using Values = std::vector<double>;
using Places = std::vector<std::vector<double>>;

/// All parts of an expression, inner ones first.
ExpressionPart collect(const Symbolic& formula, const std::vector<double>& wanted,
                       std::vector<ExpressionPart>& parts) {
  ExpressionPart whole{formula, {}, {}};
  if (formula.kind() == Symbolic::Kind::variable) whole.names.insert(formula.name());
  if (formula.kind() == Symbolic::Kind::number) whole.numbers.push_back(constant<double>(formula.name()));
  for (const Symbolic& inner : formula.parts()) {
    const ExpressionPart part = collect(inner, wanted, parts);
    whole.names.insert(part.names.begin(), part.names.end());
    whole.numbers.insert(whole.numbers.end(), part.numbers.begin(), part.numbers.end());
  }
  whole.held = count_held(whole.numbers, wanted);
  if (!formula.parts().empty()) parts.push_back(whole);
  return whole;
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

}  // namespace

bool is_near(double a, double b, double slack) {
  return std::abs(a - b) <= slack * std::max(std::abs(a), std::abs(b));
}

std::size_t count_held(const std::vector<double>& numbers, const std::vector<double>& wanted) {
  constexpr double same_number = 1e-6;  // to all digits of float32
  return static_cast<std::size_t>(std::ranges::count_if(wanted, [&](double value) {
    return std::ranges::any_of(numbers, [&](double number) { return is_near(number, value, same_number); });
  }));
}

std::vector<ExpressionPart> full_parts(const Symbolic& formula, const std::vector<double>& wanted) {
  std::vector<ExpressionPart> parts;
  const std::size_t held = collect(formula, wanted, parts).held;
  std::erase_if(parts, [&](const ExpressionPart& part) { return part.held < held || held == 0; });
  return parts;
}

CurveComparison::CurveComparison(const KnownSet& set, const std::vector<ExpressionPart>& parts) : set_(set) {
  Places places = places_in(set.axes);
  for (std::vector<double>& place : places_beside_thresholds(set, places)) places.push_back(std::move(place));
  inner_places_ = places.size();
  for (std::vector<double>& end : ends_of(set.axes)) places.push_back(std::move(end));
  places_ = std::move(places);
  for (const ExpressionPart& part : parts) {
    if (part.names.size() != set.axes.size()) continue;
    std::vector<std::string> order(part.names.begin(), part.names.end());
    do {
      curves_.push_back(values_at(part.formula, order, places_));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

bool CurveComparison::has(const Curve& curve) const {
  return is_there(values_of(curve), inner_places_);
}

bool CurveComparison::has_other(const Curve& curve, const std::vector<Curve>& allowed, double hidden) const {
  const Values values = values_of(curve);
  return is_there(values, values.size()) && std::ranges::none_of(allowed, [&](const Curve& other) {
           return are_same(values, values_of(other), values.size(), hidden);
         });
}

bool CurveComparison::is_there(const Values& values, std::size_t count) const {
  return largest(values) > 0 && std::ranges::any_of(curves_, [&](const Values& other) {
           return are_same(other, values, count, same_curve);
         });
}

CurveComparison::Values CurveComparison::values_of(const Curve& curve) const {
  Places places = places_;
  std::vector<std::string> names;
  for (const KnownAxis& axis : set_.axes) names.push_back(axis.variable);
  for (const KnownConstant& constant : set_.constants) names.push_back(constant.name);
  for (std::vector<double>& place : places) std::ranges::copy(curve.constants, std::back_inserter(place));
  return values_at(curve.form, names, places);
}

}  // namespace shadefit::lint
