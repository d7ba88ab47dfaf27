#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "approx/scalar.hpp"
#include "fit/scalars/narrow_result.hpp"

/// How wrong the functions of a GPU are.
namespace shadefit {

/// Two ends. The arithmetic that makes them rounds them to doubles or to numbers of a format.
struct Ends {
  double lower = 0;
  double upper = 0;
};

/// An ulp of a float, relative: at most so much of the number.
inline constexpr double float_ulp = power_of_two(1 - FloatFormat::digits);

/// The largest errors of a graphics device's arithmetic in float, in real-valued ulps. Additions, products
/// and fused ones have half an ulp. exp and log are exp2 and log2 with a product, and pow(x, y) is exp2(y
/// log2 x).
struct GpuModel {
  double exp2_ulps = 0;      ///< of a result that is a normal number
  double log2_ulps = 0;      ///< outside of [1/2, 2]
  double log2_near_one = 0;  ///< inside: an absolute error
  double quotient_ulps = 0;
  double root_ulps = 0;
  double wave_error = 0x1p-11;  ///< of sin and cos between -pi and pi: absolute, as Vulkan demands
  bool operator==(const GpuModel&) const = default;
};

/// What is assumed of a GPU that is not at hand. docs/devices.md has what was measured.
/// - exp2: NVIDIA states 2 ulp ("CUDA C++ Programming Guide", mathematical functions). Two drivers for CPUs
///   have 3.46 (Mesa's lavapipe) and 3.37 (SwiftShader), by every float. 4 is the whole number above.
/// - log2: Vulkan's precision, 3 ulp outside of [1/2, 2] and 2^-21 inside (Khronos, "Vulkan Specification",
///   appendix "Vulkan Environment for SPIR-V", precision of GLSL.std.450 instructions).
/// - A quotient: 2.5 ulp, by the same appendix.
/// - sin and cos: 2^-11 between -pi and pi, by the same appendix.
/// - A root is 1/(1/sqrt(x)), the inner one within 2 ulp there: 5 ulp cover both.
inline constexpr GpuModel usual_gpu{.exp2_ulps = 4,
                                    .log2_ulps = 3,
                                    .log2_near_one = 0x1p-21,
                                    .quotient_ulps = 2.5,
                                    .root_ulps = 5,
                                    .wave_error = 0x1p-11};

/// `usual_gpu` in words. In half, functions, quotients and roots may be cut off: on an H200 all of them are
/// but log2, by driver 580.159.04 (reports/devices/h200).
inline constexpr std::string_view gpu_assumption =
    "exp2 within 4 ulp of a float, log2 within 3, between 1/2 and 2 within 2^-21; exp and pow made of them in "
    "float, then rounded to the format or cut off; subnormals kept or flushed to zero; a multiplication and an "
    "addition fused or not; a number added to an inner part of a sum or not";

/// Results that may be off by a part of them, at least by the least float. Infinity stays.
inline Ends widened_by_gpu(Ends x, double relative) {
  const auto off = [&](double end) {
    return std::isinf(end) ? 0 : relative * std::abs(end) + least_of<FloatFormat>;
  };
  return {x.lower - off(x.lower), x.upper + off(x.upper)};
}

/// All results of exp2 between the ends, before they are rounded to float.
inline Ends gpu_exp2(Ends x, const GpuModel& gpu) {
  const Ends y = widened_by_gpu({std::exp2(x.lower), std::exp2(x.upper)}, gpu.exp2_ulps * float_ulp);
  return {std::max(y.lower, 0.0), y.upper};
}

/// The largest error of log2 between the ends, x.lower >= 0. log2(0) is -infinity without an error.
inline double gpu_log2_error(Ends x, const GpuModel& gpu) {
  const auto outside = [&](double at) {
    return at > 0 ? gpu.log2_ulps * float_ulp * std::abs(std::log2(at)) : 0;
  };
  constexpr double half = 0.5, two = 2;
  double error = x.lower <= two && half <= x.upper ? gpu.log2_near_one : 0;
  if (x.lower < half) error = std::max(error, outside(x.lower));
  if (x.upper > two) error = std::max(error, outside(x.upper));
  return error;
}

/// All results of log2 between the ends, likewise. log2(x) with its error added or subtracted rises with x on
/// each side of 1/2 and of 2. At these two the error may jump.
inline Ends gpu_log2(Ends x, const GpuModel& gpu) {
  const auto error_at = [&](double end) { return gpu_log2_error({end, end}, gpu); };
  Ends y{std::log2(x.lower) - error_at(x.lower), std::log2(x.upper) + error_at(x.upper)};
  const double jump = std::max(gpu.log2_near_one, gpu.log2_ulps * float_ulp);
  for (const double end : {0.5, 2.0}) {
    if (!(x.lower <= end && end <= x.upper)) continue;
    y = {std::min(y.lower, std::log2(end) - jump), std::max(y.upper, std::log2(end) + jump)};
  }
  return y;
}

/// The largest error of sin and cos between the ends. Beyond pi the argument is first reduced by whole turns:
/// that is taken to cost an ulp of the argument.
inline double gpu_wave_error(Ends x, const GpuModel& gpu) {
  return gpu.wave_error + float_ulp * std::max(std::abs(x.lower), std::abs(x.upper));
}

/// All results of pow between the ends, likewise; x.lower >= 0. The logarithm and its product with p are
/// floats, which may overflow to an infinity that is right.
inline Ends gpu_power(Ends x, Ends p, const GpuModel& gpu) {
  const Ends l = gpu_log2(x, gpu);
  const auto [lower, upper] =
      std::minmax({l.lower * p.lower, l.lower * p.upper, l.upper * p.lower, l.upper * p.upper});
  // Half an ulp of the product, and of the logarithm where its error is less than that.
  return gpu_exp2(widened_by_gpu({lower, upper}, float_ulp), gpu);
}

/// The largest relative error of pow between the ends, x.lower >= 0: that of exp2, and what those of the
/// logarithm and of its product with p do to the exponent. Infinite where x may be 0.
inline double gpu_power_error(Ends x, Ends p, const GpuModel& gpu) {
  const double l = std::max(std::abs(std::log2(x.lower)), std::abs(std::log2(x.upper)));
  const double q = std::max(std::abs(p.lower), std::abs(p.upper)), of_log2 = gpu_log2_error(x, gpu);
  const double exponent = q * (of_log2 + float_ulp * (l + of_log2)) + least_of<FloatFormat>;
  const double own = gpu.exp2_ulps * float_ulp;
  return own + (1 + own) * std::expm1(exponent * Scalar<double>::ln2());
}

}  // namespace shadefit
