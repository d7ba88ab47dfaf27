#pragma once

#include "fit/better/better_study.hpp"

namespace shadefit {

/// Rounds the constants of the first published contender, and of what is better at its cost, to float and to
/// half, and bounds their errors there. To be called after `prove_contenders`.
///
/// In float, and in half of two variables, the bound is proven: that of the error in real numbers and that of
/// what rounding adds. In half of one variable the form is evaluated at every half of the range. Measured
/// rows are evaluated, in both formats. For the form of what is better, constants in half are searched for
/// too, but in two variables: from its own and from the published ones if they are of that form. They are
/// added where they gain 1 %. They keep exact ends, but may lose other properties.
void round_contenders(StudyComparison& comparison, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
