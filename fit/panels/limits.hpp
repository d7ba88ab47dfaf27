#pragma once

#include "fit/study/study.hpp"

namespace shadefit {

/// Gives the formulas of a study of one variable their limits as values: sin(x)/x is 1 at x = 0, x log(x) is
/// 0. Beside such a place digits cancel. So a polynomial that agrees with the formula to 20 digits replaces
/// it near the place. x log(x) has no such polynomial: there the limit replaces the value at the place
/// alone. A part with a parameter stays as it is, and so does a formula without a limit.
void take_limits(ReadStudy& study);

}  // namespace shadefit
