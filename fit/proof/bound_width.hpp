#pragma once

namespace shadefit {

/// The default relative width of bounds: far below any printed digit.
inline constexpr double usual_width = 1e-9;
/// The ends of an enclosure are doubles, so it cannot be narrower than a few of their steps of 2.2e-16.
inline constexpr double least_width = 1e-15;

}  // namespace shadefit
