#include "bench/device/evaluator.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace shadefit::device {

namespace {

std::vector<std::uint32_t> spirv_of(const ShaderCompiler& compiler, const ShaderFunction& function,
                                    ShaderLanguage language, Arguments arguments, ShaderPrecision precision) {
  auto spirv = compiler.spirv(evaluating_shader(function, language, arguments, precision), language);
  return precision == ShaderPrecision::float16 ? with_halves(spirv) : spirv;
}

}  // namespace

Evaluator::Evaluator(VulkanDevice& device, const ShaderCompiler& compiler, const ShaderFunction& function,
                     ShaderLanguage language, Arguments arguments, ShaderPrecision precision)
    : device_(device),
      program_(device.load(spirv_of(compiler, function, language, arguments, precision))),
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
