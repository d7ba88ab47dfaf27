#pragma once

#include <string>

namespace shadefit {

/// The libraries inside the command with their versions, as one line without an end: "with Boost 1.74.0, ..,
/// zlib 1.2.13". GMP, MPFR and MPFI are asked when the command runs, since a user can exchange them; the
/// others are those that it was built with.
std::string libraries_inside();

}  // namespace shadefit
