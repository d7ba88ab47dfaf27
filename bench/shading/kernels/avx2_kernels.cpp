#include "bench/shading/kernels/compiled.hpp"

/// Registers of AVX2 with fused multiply-adds.
namespace shadefit::shade {

constinit const Kernels KernelUnits::avx2 = kernels_of<xsimd::fma3<xsimd::avx2>>(forms::Width::avx2);

}  // namespace shadefit::shade
