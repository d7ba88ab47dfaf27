#include "bench/forms/batch_lanes.hpp"
#include "bench/forms/compiled.hpp"

/// Registers of AVX-512.
namespace shadefit::forms {
namespace {

using Architecture = xsimd::avx512bw;
constexpr auto table =
    table_of<xsimd::batch<float, Architecture>, xsimd::batch<double, Architecture>>(AllForms());

}  // namespace

constinit const std::span<const CompiledForm> Tables::avx512(table);

}  // namespace shadefit::forms
