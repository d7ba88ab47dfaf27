#pragma once

#include <array>

/// The number of nodes that a fit needs.
namespace shadefit {

/// The Gauss rules on which fits are polished and checked. If two neighbours agree, the error of the larger
/// rule is a fraction of their difference. From one rule to the next, the error of an entire integrand falls
/// by a factor of at least 1e3. After a substitution the slowest convergence is like n^-16: a factor of at
/// least 9.
inline constexpr std::array<unsigned, 10> fit_rules{14, 18, 22, 26, 30, 38, 56, 84, 126, 190};

}  // namespace shadefit
