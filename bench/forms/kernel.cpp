#include "bench/forms/kernel.hpp"

#include "bench/forms/compiled.hpp"

namespace shadefit::forms {

std::span<const CompiledForm> compiled_forms(Width width) {
  constexpr std::array tables{&Tables::scalar, &Tables::sse2, &Tables::avx2, &Tables::avx512};
  return *tables.at(static_cast<std::size_t>(width));
}

std::vector<Width> widths_here() {
  std::vector<Width> widths{Width::scalar, Width::sse2};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) widths.push_back(Width::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512vl")) {
    widths.push_back(Width::avx512);
  }
  return widths;
}

std::string_view name(Width width) {
  constexpr std::array<std::string_view, 4> names{"scalar", "SSE2", "AVX2", "AVX-512"};
  return names.at(static_cast<std::size_t>(width));
}

}  // namespace shadefit::forms
