#pragma once

#include <optional>
#include <string>

#include "fit/catalogue/family.hpp"
#include "fit/study/study.hpp"

/// The families as studies of one setting.
namespace shadefit {

/// The study of a family under a metric, with the formulas near its peak and the starts that are known. A
/// relative error is that of the family; that of a lobe counts where the target is at least 1/255, one code
/// of an 8-bit linear target. Empty if it has no meaning anywhere.
std::optional<Study> study_of(const Family& family, const Setting& setting, const Metric& metric);

/// Target and weight of a Fresnel form for a surface, over c. Without a named surface an absolute error is
/// that of the weight, for every f0; else errors are those of the reflectance. The range is cut where the
/// target has fallen.
Study fresnel_study(const Surface& surface, Error error);

/// Multiplies the weight of a study by another. An empty one changes nothing.
void multiply_weight(Study& study, const std::string& weight);

}  // namespace shadefit
