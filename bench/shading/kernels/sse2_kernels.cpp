#include "bench/shading/kernels/compiled.hpp"

/// Registers of SSE2.
namespace shadefit::shade {

constinit const Kernels KernelUnits::sse2 = kernels_of<xsimd::sse2>(forms::Width::sse2);

}  // namespace shadefit::shade
