#include "bench/forms/batch_lanes.hpp"
#include "bench/forms/compiled.hpp"

/// Registers of SSE2.
namespace shadefit::forms {

constinit const std::span<const CompiledForm> Tables::sse2(
    table<xsimd::batch<float, xsimd::sse2>, xsimd::batch<double, xsimd::sse2>>);

}  // namespace shadefit::forms
