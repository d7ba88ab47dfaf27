#include "fit/study/require_values.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "fit/scalars/multiprecision.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The first node where a formula has a value that does not pass, as text: "x = 0.5". Empty if there is none.
template <class Passes>
std::string first_place(const ReadStudy& study, const Symbolic& formula, const StudyNodes& nodes,
                        const Passes& passes) {
  for (std::size_t n = 0; n < nodes.weights.size(); ++n) {
    const auto coordinate = [&](std::size_t axis) { return static_cast<double>(nodes.coordinates[axis][n]); };
    const double value = evaluate<double>(formula, [&](const std::string& name) {
      std::size_t axis = 0;
      while (study.axes[axis].variable != name) ++axis;
      return coordinate(axis);
    });
    if (passes(value)) continue;
    std::string place;
    for (std::size_t axis = 0; axis < study.axes.size(); ++axis)
      place += (axis == 0 ? "" : ", ") + study.axes[axis].variable + " = " + to_text(coordinate(axis));
    return place;
  }
  return "";
}

Decimal50 magnitude_at(const ReadStudy& study, const Symbolic& formula, const Decimal50& x) {
  // Parameters without a relation to each other: what vanishes for all parameters vanishes for these.
  return abs(evaluate<Decimal50>(formula, [&](const std::string& name) {
    if (name == study.axes.front().variable) return x;
    std::size_t i = 0;
    while (study.parameters[i] != name) ++i;
    return sqrt(Decimal50(static_cast<int>(i) + 2)) / 2;
  }));
}

/// A zero of the target near which |form / target| grows without bound. Empty if there is none.
std::string zero_of_target(const ReadStudy& study) {
  const StudyAxis& axis = study.axes.front();
  for (const double zero : zeros_of(study.target, axis)) {
    const int inwards = zero < axis.upper ? 1 : -1;
    const auto ratio = [&](const char* distance) {
      const Decimal50 x =
          Decimal50(zero) + inwards * Decimal50(distance) * Decimal50(axis.upper - axis.lower);
      return Decimal50(magnitude_at(study, study.form, x) / magnitude_at(study, study.target, x));
    };
    const Decimal50 far = ratio("1e-6"), near = ratio("1e-12");
    // A power of the distance above 1/6 grows more than this; a logarithm doubles.
    constexpr int growth = 10;
    if (isnan(far) || isnan(near) || near <= growth * far) continue;
    return axis.variable + " = " + to_text(zero);
  }
  return "";
}

}  // namespace

void require_values(const ReadStudy& study, const StudyNodes& nodes) {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  const auto is_weight = [](double value) { return value >= 0 && std::isfinite(value); };
  if (const auto place = first_place(study, study.target, nodes, is_finite); !place.empty())
    throw UserError("--target has no finite value at " + place);
  if (const auto place = first_place(study, study.weight, nodes, is_weight); !place.empty())
    throw UserError("--weight is negative, or has no finite value, at " + place);
  if (study.error == Error::absolute) return;
  const auto inverse = Symbolic::number("1") / study.target;
  auto place = first_place(study, inverse, nodes, is_finite);
  if (place.empty() && study.axes.size() == 1) place = zero_of_target(study);
  if (!place.empty())
    throw UserError("--error 'relative' divides by the target, which is 0 at " + place +
                    ": leave that place out of --over");
}

}  // namespace shadefit
