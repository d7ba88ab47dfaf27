#pragma once

#include "bench/shading/kernels/kernel.hpp"

/// The kernels of each width.
namespace shadefit::shade {

/// Each is in its own unit, compiled with its instructions.
struct KernelUnits {
  static const Kernels sse2, avx2, avx512;
};

}  // namespace shadefit::shade
