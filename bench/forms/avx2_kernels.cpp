#include "bench/forms/batch_lanes.hpp"
#include "bench/forms/compiled.hpp"

/// Registers of AVX2.
namespace shadefit::forms {
namespace {

using Architecture = xsimd::fma3<xsimd::avx2>;
constexpr auto table =
    table_of<xsimd::batch<float, Architecture>, xsimd::batch<double, Architecture>>(AllForms());

}  // namespace

constinit const std::span<const CompiledForm> Tables::avx2(table);

}  // namespace shadefit::forms
