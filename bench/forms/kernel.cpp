#include "bench/forms/kernel.hpp"

#include <stdexcept>

#include "bench/forms/compiled.hpp"

namespace shadefit::forms {
namespace {

std::vector<CompiledForm> copied(std::span<const CompiledForm> table) {
  return {table.begin(), table.end()};
}

}  // namespace

std::vector<CompiledForm> scalar_forms() {
  return copied(Tables::scalar);
}
std::vector<CompiledForm> sse2_forms() {
  return copied(Tables::sse2);
}
std::vector<CompiledForm> avx2_forms() {
  return copied(Tables::avx2);
}
std::vector<CompiledForm> avx512_forms() {
  return copied(Tables::avx512);
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
  switch (width) {
    case Width::scalar:
      return "scalar";
    case Width::sse2:
      return "SSE2";
    case Width::avx2:
      return "AVX2";
    case Width::avx512:
      return "AVX-512";
  }
  throw std::logic_error("a width without a name");
}

}  // namespace shadefit::forms
