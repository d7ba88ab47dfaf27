#pragma once

#include <string>
#include <vector>

#include "fit/better/better.hpp"

/// The part of the report on better constants and forms at the same cost.
namespace shadefit {

/// A table for each target, and the published curves that no alternative beats.
std::string better_section(const std::vector<Comparison>& comparisons);

}  // namespace shadefit
