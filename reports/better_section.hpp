#pragma once

#include <string>
#include <vector>

#include "fit/better.hpp"

/// The part of the report that says what would be better at the same cost.
namespace shadefit {

/// How the report compares: published curves against the least largest error of each form, to more digits
/// than it shows.
inline constexpr Contest report_contest{.width = 1e-6, .only_minimax = true};

/// A table for each target, and which published curves nothing here beats.
std::string better_section(const std::vector<Comparison>& comparisons);

}  // namespace shadefit
