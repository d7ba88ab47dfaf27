#include "bench/device/timing_shader.hpp"

#include <fmt/format.h>

#include "bench/device/vulkan_device.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit::device {
namespace {

std::string head() {
  return fmt::format(
      "#version 450\n"
      "layout(local_size_x = {}) in;\n"
      "layout(set = 0, binding = 0, std430) buffer Output {{ float result[]; }};\n"
      "layout(push_constant) uniform Push {{ uint count, factor; }} push;\n",
      threads_per_group);
}

/// The thread's point in a range: the middle of one of 1024 equal parts. Each argument visits them in another
/// order.
std::string place_in(const bench::Range& range, std::size_t argument) {
  constexpr int places = 1024;
  constexpr std::array steps{397, 631, 829, 1021};  // odd: each visits all places
  return fmt::format("{:.9e} + {:.9e} * ((float((gl_GlobalInvocationID.x * {}u) & {}u) + 0.5) / {}.0)",
                     range.from, range.to - range.from, steps.at(argument), places - 1, places);
}

}  // namespace

std::string timing_shader(const ShaderFunction& function, std::span<const bench::Range> ranges,
                          ShaderPrecision precision) {
  constexpr std::uint32_t streams = 4;
  // The type of the chain's numbers is that of the function.
  const std::string_view type = precision == ShaderPrecision::float16 ? "mediump float" : "float";
  std::string code =
      head() + shader_code(std::span(&function, 1), Language::glsl, precision, std::array<OthersText, 0>()) +
      "\nvoid main() {\n";
  code += fmt::format("  {} t = uintBitsToFloat(push.factor);\n", type);
  for (std::size_t a = 0; a < ranges.size(); ++a)
    code += fmt::format("  {} b{} = {};\n", type, a, place_in(ranges[a], a));
  std::string sum;
  for (std::uint32_t s = 0; s < streams; ++s) {
    code += fmt::format("  {} r{} = {}.0;\n", type, s, s);
    sum += fmt::format("{}r{}", s == 0 ? "" : " + ", s);
  }
  code += "  for (uint turn = 0u; turn < push.count; ++turn) {\n";
  for (std::uint32_t e = 0; e < evaluations_a_turn; ++e) {
    std::string arguments;
    for (std::size_t a = 0; a < ranges.size(); ++a)
      arguments += fmt::format("{}b{} + t * r{}", a == 0 ? "" : ", ", a, e % streams);
    code += fmt::format("    r{} = {}({});\n", e % streams, function.name, arguments);
  }
  return code + fmt::format("  }}\n  result[gl_GlobalInvocationID.x] = {};\n}}\n", sum);
}

ShaderFunction chain_alone() {
  return {bench::form_name, {"c"}, Symbolic::variable("c")};
}

}  // namespace shadefit::device
