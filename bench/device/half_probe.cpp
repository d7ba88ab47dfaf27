#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bench/device/evaluator.hpp"
#include "bench/device/half_errors.hpp"
#include "bench/device/probe.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/narrow_result.hpp"

namespace shadefit::device {
namespace {

/// The halves from one up to, not including, another. Both are positive, or both are negative or -0, and the
/// second is the farther from 0.
void append_halves(std::vector<float>& halves, float from, float to) {
  const auto bits = [](float x) { return Eigen::numext::bit_cast<std::uint16_t>(Eigen::half(x)); };
  for (std::uint16_t i = bits(from); i < bits(to); ++i)
    halves.push_back(static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(i)));
}

double ulp_of_half(double x) {
  return power_of_two(std::ilogb(x) + 1 - HalfFormat::digits);
}
double absolute(double) {
  return 1;
}

/// The largest error of a function at these halves, in a unit that its true value has.
template <class Truth>
LargestError largest_in_half(VulkanDevice& device, const Symbolic& function, const std::vector<float>& halves,
                             double (*unit)(double), const Truth& truth) {
  const ShaderCompiler compiler;
  Evaluator evaluator(device, compiler, {"probed", {"x"}, function}, ShaderLanguage::glsl, Arguments::input,
                      ShaderPrecision::float16);
  LargestError found{-1};
  const auto results = evaluator.of_input(halves);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const double exact = truth(static_cast<double>(halves[i]));
    const double off = std::abs(static_cast<double>(std::bit_cast<float>(results[i])) - exact);
    double error = off / unit(exact);
    if (std::isnan(error)) error = HUGE_VAL;
    if (error > found.error) found = {error, {halves[i]}, 0};
  }
  found.count = halves.size();
  return found;
}

}  // namespace

HalfProbe probe_halves(VulkanDevice& device) {
  require_half(device.info());
  constexpr auto least_normal = static_cast<float>(least_normal_of<HalfFormat>);
  constexpr float after_two = 0x1.004p1F,
                  infinite = 0x1p16F;  // the next halves after 2 and after the largest
  std::vector<float> exponents, far, near, normal, with_normal_reciprocal;
  append_halves(exponents, 0.0F, 16.0F);
  append_halves(exponents, -0.0F, -14.0F);
  exponents.push_back(-14.0F);
  append_halves(far, least_normal, 0.5F);
  append_halves(far, after_two, infinite);
  append_halves(near, 0.5F, after_two);
  append_halves(normal, least_normal, infinite);
  append_halves(with_normal_reciprocal, least_normal, 0x1p14F);
  with_normal_reciprocal.push_back(0x1p14F);

  const Symbolic x = Symbolic::variable("x");
  const Symbolic exp2 = Symbolic::function("exp2", {x}), log2 = Symbolic::function("log2", {x});
  const auto true_log2 = [](double a) { return std::log2(a); };
  return {largest_in_half(device, exp2, exponents, ulp_of_half, [](double a) { return std::exp2(a); }),
          largest_in_half(device, log2, far, ulp_of_half, true_log2),
          largest_in_half(device, log2, near, absolute, true_log2),
          largest_in_half(device, Symbolic::function("sqrt", {x}), normal, ulp_of_half,
                          [](double a) { return std::sqrt(a); }),
          largest_in_half(device, Symbolic::number("1") / x, with_normal_reciprocal, ulp_of_half,
                          [](double a) { return 1 / a; })};
}

}  // namespace shadefit::device
