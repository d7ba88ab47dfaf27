#pragma once

#include "fit/study/study.hpp"

namespace shadefit {

/// Gives the formulas of a study of one variable their limits as values: sin(x)/x is 1 at x = 0, x log(x) is
/// 0. Beside such a place digits cancel, so near it a polynomial stands for the formula that agrees with it
/// to 20 digits; where there is none, as for x log(x), the limit stands at the place alone. Parts with a
/// parameter stay as they are, and so does what has no limit.
void take_limits(ReadStudy& study);

}  // namespace shadefit
