#pragma once

#include <array>
#include <vector>

#include "fit/study/study.hpp"

namespace shadefit {

/// One number for each variable, and 0 beyond: a table has millions.
using SampledPlace = std::array<double, most_axes>;

/// A form and its target at the same places.
struct SampledCurve {
  std::vector<SampledPlace> places;
  std::vector<double> target, form;  ///< NaN where a formula has no value
};

/// A study at these parameters: in one variable at 1001 even places from end to end, in two on a grid of 49 x
/// 49 such places (the last variable changes fastest), in three of 13 x 13 x 13; of measured rows at each
/// row.
SampledCurve sample_curve(const ReadStudy& study, const std::vector<double>& parameters);

/// The same at one place.
SampledCurve sample_place(const ReadStudy& study, const std::vector<double>& parameters,
                          const std::vector<double>& place);

/// Appends the places of another.
void append(SampledCurve& curve, SampledCurve other);

/// A formula of the study at these places.
std::vector<double> values_at(const ReadStudy& study, const Symbolic& formula,
                              const std::vector<double>& parameters, const std::vector<SampledPlace>& places);

}  // namespace shadefit
