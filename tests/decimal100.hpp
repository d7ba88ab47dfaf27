#pragma once

#include "fit/scalars/multiprecision.hpp"

namespace shadefit {

/// A binary floating-point number of (at least) 100 decimal digits, wider than any that is tested.
using Decimal100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

}  // namespace shadefit
