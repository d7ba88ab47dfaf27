#pragma once

#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// A checkpoint that ends the work with CheckFailed once so many seconds have passed from now on. It calls
/// `checkpoint`, a copy of which it holds, first.
Checkpoint limited(const Checkpoint& checkpoint, double seconds);

}  // namespace shadefit
