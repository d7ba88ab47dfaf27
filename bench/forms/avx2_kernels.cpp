#include "bench/forms/batch_lanes.hpp"
#include "bench/forms/compiled.hpp"

/// Registers of AVX2.
namespace shadefit::forms {

constinit const std::span<const CompiledForm> Tables::avx2(
    table<xsimd::batch<float, xsimd::fma3<xsimd::avx2>>, xsimd::batch<double, xsimd::fma3<xsimd::avx2>>>);

}  // namespace shadefit::forms
