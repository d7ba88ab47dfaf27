#include "bench/device/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <string_view>

#include "bench/device/dispatches.hpp"

namespace shadefit::device {
namespace {

constexpr std::string_view glsl_head =
    "#version 450\n"
    "layout(local_size_x = {}) in;\n"
    "layout(set = 0, binding = 0, std430) writeonly buffer Output {{ float result[]; }};\n"
    "layout(set = 0, binding = 1, std430) readonly buffer Input {{ uint given[]; }};\n"
    "layout(push_constant) uniform Push {{ uint from, size; }} push;\n\n"
    "{}\n"
    "void main() {{\n"
    "  uint thread = gl_GlobalInvocationID.x";
constexpr std::string_view hlsl_head =
    "[[vk::binding(0, 0)]] RWStructuredBuffer<float> result;\n"
    "[[vk::binding(1, 0)]] StructuredBuffer<uint> given;\n"
    "struct Push {{ uint from, size; }};\n"
    "[[vk::push_constant]] ConstantBuffer<Push> push;\n\n"
    "{1}\n"
    "[numthreads({0}, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {{\n"
    "  uint thread = id.x";

/// The arguments of thread i as code. `as_float` is the language's function from a bit pattern to its float.
std::string arguments_of(const ShaderFunction& function, Arguments arguments, std::string_view as_float) {
  const std::size_t count = function.arguments.size();
  if (arguments == Arguments::patterns) return fmt::format("{}(push.from + i)", as_float);
  std::string list;
  for (std::size_t a = 0; a < count; ++a)
    list += fmt::format("{}{}(given[i * {}u + {}u])", a == 0 ? "" : ", ", as_float, count, a);
  return list;
}

/// The code that `emit` writes for a function, and a main function that calls it once per thread. The threads
/// below the second push word write their result: with `patterns` thread i writes word i of the output, with
/// `input` it writes word i + the first push word.
std::string evaluating_shader(const ShaderFunction& function, ShaderLanguage language, Arguments arguments,
                              ShaderPrecision precision) {
  const bool is_hlsl = language == ShaderLanguage::hlsl;
  const std::string code = shader_code(std::span(&function, 1), is_hlsl ? Language::hlsl : Language::glsl,
                                       precision, std::array<OthersText, 0>());
  return fmt::format(fmt::runtime(is_hlsl ? hlsl_head : glsl_head), threads_per_group, code) +
         fmt::format(", i = {};\n  if (thread < push.size) result[i] = {}({});\n}}\n",
                     arguments == Arguments::patterns ? "thread" : "push.from + thread", function.name,
                     arguments_of(function, arguments, is_hlsl ? "asfloat" : "uintBitsToFloat"));
}

}  // namespace

Evaluator::Evaluator(VulkanDevice& device, const ShaderCompiler& compiler, const ShaderFunction& function,
                     ShaderLanguage language, Arguments arguments, ShaderPrecision precision)
    : device_(device),
      program_(device.load(
          compiler.spirv(evaluating_shader(function, language, arguments, precision), language, precision))),
      argument_count_(function.arguments.size()) {}

void Evaluator::over_patterns(
    std::uint32_t from, std::uint32_t to,
    const std::function<void(std::uint32_t, std::span<const std::uint32_t>)>& take) {
  const std::size_t most = std::min<std::size_t>(device_.output().size(), most_threads);
  in_short_dispatches(to - from, most, [&](std::uint64_t begin, std::uint64_t count) {
    const auto first = from + static_cast<std::uint32_t>(begin), n = static_cast<std::uint32_t>(count);
    const double seconds = device_.run(program_, n, {first, n, 0, 0});
    take(first, device_.output().first(n));
    return seconds;
  });
}

std::span<const std::uint32_t> Evaluator::of_input(std::span<const float> arguments) {
  const std::size_t count = arguments.size() / argument_count_;
  if (arguments.size() > device_.input().size() || count > device_.output().size())
    throw std::logic_error("more arguments than a device's buffer holds");
  std::transform(arguments.begin(), arguments.end(), device_.input().begin(),
                 [](float x) { return std::bit_cast<std::uint32_t>(x); });
  in_short_dispatches(count, most_threads, [&](std::uint64_t from, std::uint64_t n) {
    const auto size = static_cast<std::uint32_t>(n);
    return device_.run(program_, size, {static_cast<std::uint32_t>(from), size, 0, 0});
  });
  return device_.output().first(count);
}

}  // namespace shadefit::device
