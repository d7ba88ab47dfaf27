#include "bench/shading/kernels/compiled.hpp"

/// Registers of AVX-512.
namespace shadefit::shade {

constinit const Kernels KernelUnits::avx512 = kernels_of<xsimd::avx512bw>(forms::Width::avx512);

}  // namespace shadefit::shade
