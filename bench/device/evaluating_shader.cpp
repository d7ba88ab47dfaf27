#include "bench/device/evaluating_shader.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string_view>

#include "bench/device/vulkan_device.hpp"

namespace shadefit::device {
namespace {

/// The arguments of thread i as code. `as_float` is the language's function from a bit pattern to its float.
std::string arguments_of(const ShaderFunction& function, Arguments arguments, const std::string& as_float) {
  const std::size_t count = function.arguments.size();
  if (arguments == Arguments::patterns) return as_float + "(push.from + i)";
  std::string list;
  for (std::size_t a = 0; a < count; ++a)
    list += fmt::format("{}{}(given[i * {}u + {}u])", a == 0 ? "" : ", ", as_float, count, a);
  return list;
}

/// The index of a thread's result in the output, and of its arguments in the input.
std::string_view place_of(Arguments arguments) {
  return arguments == Arguments::patterns ? "thread" : "push.from + thread";
}

std::string glsl_shader(const ShaderFunction& function, Arguments arguments, const std::string& code) {
  return fmt::format(
      "#version 450\n"
      "layout(local_size_x = {}) in;\n"
      "layout(set = 0, binding = 0, std430) writeonly buffer Output {{ float result[]; }};\n"
      "layout(set = 0, binding = 1, std430) readonly buffer Input {{ uint given[]; }};\n"
      "layout(push_constant) uniform Push {{ uint from, size; }} push;\n\n"
      "{}\n"
      "void main() {{\n"
      "  uint thread = gl_GlobalInvocationID.x, i = {};\n"
      "  if (thread < push.size) result[i] = {}({});\n"
      "}}\n",
      threads_per_group, code, place_of(arguments), function.name,
      arguments_of(function, arguments, "uintBitsToFloat"));
}

std::string hlsl_shader(const ShaderFunction& function, Arguments arguments, const std::string& code) {
  return fmt::format(
      "[[vk::binding(0, 0)]] RWStructuredBuffer<float> result;\n"
      "[[vk::binding(1, 0)]] StructuredBuffer<uint> given;\n"
      "struct Push {{ uint from, size; }};\n"
      "[[vk::push_constant]] ConstantBuffer<Push> push;\n\n"
      "{}\n"
      "[numthreads({}, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {{\n"
      "  uint thread = id.x, i = {};\n"
      "  if (thread < push.size) result[i] = {}({});\n"
      "}}\n",
      code, threads_per_group, place_of(arguments), function.name,
      arguments_of(function, arguments, "asfloat"));
}

}  // namespace

std::string evaluating_shader(const ShaderFunction& function, ShaderLanguage language, Arguments arguments,
                              ShaderPrecision precision) {
  const bool is_hlsl = language == ShaderLanguage::hlsl;
  const std::string code = shader_code(std::span(&function, 1), is_hlsl ? Language::hlsl : Language::glsl,
                                       precision, std::array<std::string, 0>());
  return is_hlsl ? hlsl_shader(function, arguments, code) : glsl_shader(function, arguments, code);
}

}  // namespace shadefit::device
