#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace shadefit {

/// Parameters on the other side of infinity, for an exchange that ran away from `start` to `end`.
///
/// Some forms are the same where parameters are infinite with either sign: (a x + b)/(d x + 1) is
/// (a x + b)/(d x) there. Its best constants may be finite and of the other sign. An exchange whose level
/// falls towards infinity does not step over it, and starts there again: the parameters that grew change
/// their sign, all by one scale. Of some scales between those of `start` and of `end` it is the smallest
/// whose level is not far above the least. Empty if no parameter grew much, or if the level is finite at no
/// scale.
std::optional<std::vector<double>> beyond_infinity(
    const std::vector<double>& start, const std::vector<double>& end,
    const std::function<double(const std::vector<double>&)>& level);

}  // namespace shadefit
