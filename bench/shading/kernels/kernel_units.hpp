#pragma once

#include "bench/shading/kernels/kernel.hpp"

/// Where the kernels of each width are.
namespace shadefit::shade {

/// Each in a unit of its own, compiled with its instructions.
struct KernelUnits {
  static const Kernels sse2, avx2, avx512;
};

}  // namespace shadefit::shade
