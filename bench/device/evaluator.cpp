#include "bench/device/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "bench/device/dispatches.hpp"

namespace shadefit::device {
namespace {

constexpr std::string_view glsl_head =
    "#version 450\n"
    "layout(local_size_x = {}) in;\n"
    "layout(set = 0, binding = 0, std430) writeonly buffer Output {{ float result[]; }};\n"
    "layout(set = 0, binding = 1, std430) readonly buffer Input {{ float given[]; }};\n"
    "layout(push_constant) uniform Push {{ uint from, size; }} push;\n\n"
    "{}\n"
    "void main() {{\n"
    "  uint thread = gl_GlobalInvocationID.x";
constexpr std::string_view hlsl_head =
    "[[vk::binding(0, 0)]] RWStructuredBuffer<float> result;\n"
    "[[vk::binding(1, 0)]] StructuredBuffer<float> given;\n"
    "struct Push {{ uint from, size; }};\n"
    "[[vk::push_constant]] ConstantBuffer<Push> push;\n\n"
    "{1}\n"
    "[numthreads({0}, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {{\n"
    "  uint thread = id.x";

/// The code that `emit` writes for a function, and a main function that calls it once per thread. With the
/// first push word i, thread t reads its arguments from place i + t and writes its result there; the second
/// push word is the number of threads that do.
std::string evaluating_shader(const ShaderFunction& function, ShaderPrecision precision, Language language) {
  const std::string code =
      shader_code(std::span(&function, 1), language, precision, std::array<OthersText, 0>());
  const std::size_t count = function.arguments.size();
  std::string arguments;
  for (std::size_t a = 0; a < count; ++a)
    arguments += fmt::format("{}given[i * {}u + {}u]", a == 0 ? "" : ", ", count, a);
  return fmt::format(fmt::runtime(language == Language::hlsl ? hlsl_head : glsl_head), threads_per_group,
                     code) +
         fmt::format(", i = push.from + thread;\n  if (thread < push.size) result[i] = {}({});\n}}\n",
                     function.name, arguments);
}

}  // namespace

Evaluator::Evaluator(VulkanDevice& device, const ShaderCompiler& compiler, const ShaderFunction& function,
                     ShaderPrecision precision, Language language)
    : device_(device),
      program_(
          device.load(compiler.spirv(evaluating_shader(function, precision, language), precision, language))),
      argument_count_(function.arguments.size()) {}

std::span<const float> Evaluator::of(std::span<const float> arguments) {
  const std::size_t count = arguments.size() / argument_count_;
  if (arguments.size() > device_.input().size())
    throw std::logic_error("more arguments than a device's buffer holds");
  std::ranges::copy(arguments, device_.input().begin());
  in_short_dispatches(count, most_threads, [&](std::uint64_t from, std::uint64_t n) {
    const auto size = static_cast<std::uint32_t>(n);
    return device_.run(program_, size, {static_cast<std::uint32_t>(from), size});
  });
  return device_.output().first(count);
}

}  // namespace shadefit::device
