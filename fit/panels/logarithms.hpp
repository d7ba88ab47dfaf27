#pragma once

#include <optional>
#include <vector>

#include "fit/study/study.hpp"

/// Forms that are exponentials, as their logarithms.
namespace shadefit {

/// The logarithms of form and target, if the form is a product of powers and exponentials that is positive at
/// these parameters: a target that is not positive counts as 0. Empty for another form. Where form and target
/// fall to 1e-300, their logarithms still tell which is larger.
std::optional<ReadStudy> logarithms_of(const ReadStudy& study, const std::vector<double>& parameters);

}  // namespace shadefit
