#include "bench/forms/batch_lanes.hpp"
#include "bench/forms/compiled.hpp"

/// Registers of AVX-512.
namespace shadefit::forms {

constinit const std::span<const CompiledForm> Tables::avx512(
    table<xsimd::batch<float, xsimd::avx512bw>, xsimd::batch<double, xsimd::avx512bw>>);

}  // namespace shadefit::forms
