#pragma once

#include "fit/scalars/narrow_result.hpp"

/// Half arithmetic on operands of any format.
namespace shadefit {

/// On halves it is the arithmetic of Eigen::half.
using HalfResult = NarrowResult<HalfFormat>;

}  // namespace shadefit
