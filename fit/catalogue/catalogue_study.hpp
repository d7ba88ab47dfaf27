#pragma once

#include <optional>
#include <string>
#include <utility>

#include "approx/cosine.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/study/study.hpp"

/// The families as studies of one setting.
namespace shadefit {

/// The upper and the lower end of a range of cosines.
using CosineRange = std::pair<Cosine<double>, Cosine<double>>;

/// The places that count for an error; empty if it has no meaning anywhere. The relative error of a lobe has
/// one where the target is at least 1/255, one code of an 8-bit linear target.
std::optional<CosineRange> ends_of(const Family& family, const Setting& setting, const Domain& domain,
                                   Error error);

/// The study of a family between two places of c, with the formulas near its peak and the starts that are
/// known. A relative error is that of the family.
Study study_of(const Family& family, const Setting& setting, const Metric& metric, const CosineRange& ends);

/// Target and weight of a Fresnel form for a surface, over c. Without a named surface an absolute error is
/// that of the weight, for every f0; else errors are those of the reflectance.
Study fresnel_study(const Surface& surface, Error error);

/// The same for a fit: the range is cut where the target has fallen.
Study fresnel_study_to_fit(const Surface& surface, Error error);

/// Multiplies the weight of a study by another. An empty one changes nothing.
void multiply_weight(Study& study, const std::string& weight);

/// The root mean square of the weight of a metric over such a study; 1 of an empty one.
double scale_of_weight(const Study& study, const std::string& weight);

}  // namespace shadefit
