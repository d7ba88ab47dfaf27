#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/scalars/narrow_result.hpp"

/// Bounds for a program in float or half on a CPU or a GPU: its true value, its computed value, and their
/// distance.
namespace shadefit {

/// A value of a program. Every operation and function is rounded to the nearest number of the format; with a
/// `gpu` it is as wrong as that device may be, and subnormal numbers may be flushed to zero.
///
/// The error of an operation is its own rounding plus the effect of its operands' errors, by the mean value
/// theorem between the true and the computed operands. It is also never more than what the two enclosures
/// allow. That helps where a slope is infinite: next to a root the enclosures shrink with the box, and the
/// float 1 - x is not negative for x <= 1. Source: Higham 2002, "Accuracy and Stability of Numerical
/// Algorithms", 2nd edition, section 3.3.
template <class Format>
struct RunningNarrow {
  Interval value;     ///< encloses the true value
  Interval computed;  ///< encloses every number that the program may have, with its products rounded or not
  double error = 0;   ///< at least |computed - true|
  const GpuModel* gpu = nullptr;  ///< the device of an operand or a result; null for a number
  int additions = 0;              ///< the additions of the sum that this is, without those inside its terms

  /// A number of the format as an operand.
  static RunningNarrow exact(const Interval& value, const GpuModel* gpu = nullptr) {
    return enclosed(value, with_flushed(value, gpu), gpu == nullptr ? 0 : least_normal, gpu);
  }

  /// A number that is rounded to the nearest of the format before the program runs.
  static RunningNarrow rounded_number(const Interval& value) { return rounded(value, value, Interval(0)); }

  /// How an operation rounds.
  enum class Rounds {
    to_nearest,  ///< to the nearest number of the format
    within,      ///< to a number within the relative error
  };

  /// An operation whose true results lie in `value`. The results for the computed operands lie in `result`
  /// and differ by at most `inherited`; then they are rounded, by a relative error.
  static RunningNarrow rounded(const Interval& value, const Interval& result, const Interval& inherited,
                               const GpuModel* gpu = nullptr, Rounds rounds = Rounds::to_nearest,
                               double relative = unit_roundoff) {
    const Interval rounding = Interval(largest_magnitude_in(result)) * Interval(relative) +
                              Interval(gpu == nullptr ? half_least : least_normal);
    const bool is_nearest = rounds == Rounds::to_nearest;
    const Interval off = is_nearest ? result : span_of(widened_by_gpu(ends(result), relative));
    return enclosed(value, with_flushed(to_format(off), gpu),
                    largest_magnitude_in(Interval(inherited + rounding)), gpu);
  }

  /// The same for an operation without rounding.
  static RunningNarrow enclosed(const Interval& value, const Interval& computed, double error,
                                const GpuModel* gpu = nullptr) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    if (!is_bounded(value) || !is_bounded(computed)) return {value, any_number(), unknown, gpu};
    return {value, computed, std::fmin(error, largest_magnitude_in(Interval(computed - value))), gpu};
  }

  /// A function of a GPU: its results lie between `results`, and are off by at most `own`. They are floats; a
  /// narrower format rounds them once more, or cuts them off.
  static RunningNarrow of_gpu(const Interval& value, Ends results, const Interval& own,
                              const Interval& inherited, const GpuModel* gpu) {
    const Interval rounding =
        is_narrow ? Interval(largest_magnitude_in(span_of(results))) * Interval(cut) : Interval(0);
    return enclosed(value, with_flushed(to_format(span_of(with_cut(results))), gpu),
                    largest_magnitude_in(Interval(inherited + own + rounding + Interval(least_normal))), gpu);
  }

  /// The effect of an operand's error on a result. `slope` encloses the derivative between the true and the
  /// computed operand. An exact operand has no effect, even if the slope is infinite.
  static Interval effect(const Interval& slope, double error) {
    return error > 0 ? Interval(largest_magnitude_in(slope)) * Interval(error) : Interval(0);
  }

  /// The device of two operands.
  static const GpuModel* gpu_of(const RunningNarrow& a, const RunningNarrow& b) {
    return a.gpu != nullptr ? a.gpu : b.gpu;
  }

  /// The ends of an enclosure.
  static Ends ends(const Interval& x) { return {lower_end(x), upper_end(x)}; }

  Interval both() const { return Scalar<Interval>::hull(value, computed); }

  /// The compiler of a GPU may add a number to an inner part of a sum: Mesa makes (a + 1) + b of (a + b) + 1.
  /// Then each partial sum differs by the number, and so does what is rounded.
  friend RunningNarrow operator+(const RunningNarrow& a, const RunningNarrow& b) {
    const Interval errors = Interval(a.error) + Interval(b.error), sum = a.computed + b.computed;
    const GpuModel* const on = gpu_of(a, b);
    const int inner = a.additions + b.additions;
    const bool may_move = on != nullptr && (a.gpu == nullptr || b.gpu == nullptr);
    const double number = may_move ? largest_magnitude_in(a.gpu == nullptr ? a.computed : b.computed) : 0;
    const Interval moved = Interval(number) * Interval(inner * unit_roundoff);
    RunningNarrow result =
        rounded(a.value + b.value, Scalar<Interval>::hull(sum - moved, sum + moved), errors + moved, on);
    result.additions = inner + 1;
    return result;
  }
  friend RunningNarrow operator-(const RunningNarrow& a) {
    return {-a.value, -a.computed, a.error, a.gpu, a.additions};
  }
  friend RunningNarrow operator-(const RunningNarrow& a, const RunningNarrow& b) { return a + -b; }
  /// a' b' - a b = a' (b' - b) + (a' - a) b. The compiler of a GPU may regroup a product of three (Mesa moves
  /// numbers inward), so a single product need not be the nearest float; its error of half an ulp remains.
  friend RunningNarrow operator*(const RunningNarrow& a, const RunningNarrow& b) {
    const Interval x(largest_magnitude_in(a.computed)), y(largest_magnitude_in(b.value));
    return rounded(a.value * b.value, a.computed * b.computed, x * Interval(b.error) + Interval(a.error) * y,
                   gpu_of(a, b), gpu_of(a, b) == nullptr ? Rounds::to_nearest : Rounds::within);
  }
  /// a'/b' - a/b = ((a' - a) - (b' - b) a/b)/b'.
  friend RunningNarrow operator/(const RunningNarrow& a, const RunningNarrow& b) {
    const Interval quotient = a.value / b.value, least(smallest_magnitude_in(b.computed));
    const Interval inherited =
        (Interval(a.error) + Interval(b.error) * Interval(largest_magnitude_in(quotient))) / least;
    const GpuModel* const on = gpu_of(a, b);
    if (on == nullptr) return rounded(quotient, a.computed / b.computed, inherited);
    return rounded(quotient, a.computed / b.computed, inherited, on, Rounds::within,
                   of_function(on->quotient_ulps));
  }

  /// The relative error of a GPU's function with a normal result.
  static constexpr double of_function(double ulps) {
    return is_narrow ? cut + ulps * float_ulp * (1 + cut) : ulps * float_ulp;
  }

  static constexpr bool is_narrow = Format::digits < FloatFormat::digits;

 private:
  static constexpr double unit_roundoff = power_of_two(-Format::digits);  ///< of a result, relative
  static constexpr double cut = 2 * unit_roundoff;                        ///< of a result that is cut off
  static constexpr double half_least = least_of<Format> / 2;              ///< of a subnormal one
  static constexpr double least_normal = least_normal_of<Format>;

  /// The numbers that results may be rounded to: rounding is monotonic. The results themselves stay included,
  /// because a fused multiply-add does not round the product. From overflow on nothing is known.
  static Interval to_format(const Interval& result) {
    const auto round = [](double x) { return static_cast<double>(NarrowResult<Format>::rounded(x)); };
    const double lower = round(lower_end(result)), upper = round(upper_end(result));
    if (!(std::isfinite(lower) && std::isfinite(upper))) return any_number();
    return Scalar<Interval>::hull(result, shadefit::span_of(lower, upper));
  }
  static Ends with_cut(Ends x) {
    if constexpr (is_narrow) {
      const auto cut_off = [](double v) { return static_cast<double>(NarrowResult<Format>::cut_off(v)); };
      x = {std::fmin(x.lower, cut_off(x.lower)), std::fmax(x.upper, cut_off(x.upper))};
    }
    return x;
  }
  static Interval span_of(Ends x) {
    return x.lower <= x.upper ? shadefit::span_of(x.lower, x.upper) : any_number();
  }

  /// On a GPU a subnormal number may also be zero.
  static Interval with_flushed(const Interval& numbers, const GpuModel* gpu) {
    const bool may_flush = gpu != nullptr && smallest_magnitude_in(numbers) < least_normal;
    return may_flush ? Scalar<Interval>::hull(numbers, Interval(0)) : numbers;
  }
};

/// A function without a slope here has only its enclosures, which are wide on wide boxes. Of a GPU only the
/// functions of `GpuModel` are known, and those that consist of them.
template <class Format>
struct Scalar<RunningNarrow<Format>> {
  using T = RunningNarrow<Format>;

  static T exp(const T& x) {
    if (x.gpu != nullptr) return exp2(x * T::rounded_number(one() / shadefit::ln2<Interval>()));
    return of(shadefit::exp, x, shadefit::exp(x.both()));
  }
  static T exp2(const T& x) {
    const Interval inherited = T::effect(shadefit::exp2(x.both()) * shadefit::ln2<Interval>(), x.error);
    if (x.gpu == nullptr) return T::rounded(shadefit::exp2(x.value), shadefit::exp2(x.computed), inherited);
    const Ends results = gpu_exp2(ends_of(x), *x.gpu);
    const Interval own = Interval(results.upper) * Interval(x.gpu->exp2_ulps * float_ulp);
    return T::of_gpu(shadefit::exp2(x.value), results, own, inherited, x.gpu);
  }
  static T log(const T& x) {
    if (x.gpu != nullptr) return log2(x) * T::rounded_number(shadefit::ln2<Interval>());
    return of(shadefit::log, x, one() / x.both());
  }
  static T log2(const T& x) {
    const Interval inherited = T::effect(one() / (x.both() * shadefit::ln2<Interval>()), x.error);
    if (x.gpu == nullptr) return T::rounded(shadefit::log2(x.value), shadefit::log2(x.computed), inherited);
    const Interval own(ends_of(x).lower > 0 ? gpu_log2_error(ends_of(x), *x.gpu) : unbounded_error);
    return T::of_gpu(shadefit::log2(x.value), gpu_log2(ends_of(x), *x.gpu), own, inherited, x.gpu);
  }
  static T expm1(const T& x) { return of(shadefit::expm1, x, shadefit::exp(x.both())); }
  static T log1p(const T& x) { return of(shadefit::log1p, x, one() / (one() + x.both())); }
  static T log1p_remainder(const T& x) { return of(shadefit::log1p_remainder, x, any_number()); }
  static T sqrt(const T& x) {
    const Interval inherited = T::effect(one() / (Interval(2) * shadefit::sqrt(x.both())), x.error);
    if (x.gpu == nullptr) return T::rounded(shadefit::sqrt(x.value), shadefit::sqrt(x.computed), inherited);
    return T::rounded(shadefit::sqrt(x.value), shadefit::sqrt(x.computed), inherited, x.gpu,
                      T::Rounds::within, T::of_function(x.gpu->root_ulps));
  }
  static T sin(const T& x) { return wave(shadefit::sin, x, shadefit::cos(x.both())); }
  static T cos(const T& x) { return wave(shadefit::cos, x, shadefit::sin(x.both())); }
  static T tan(const T& x) { return of(shadefit::tan, x, one() + square(shadefit::tan(x.both()))); }
  static T asin(const T& x) {
    return of(shadefit::asin, x, one() / shadefit::sqrt(one() - square(x.both())));
  }
  static T acos(const T& x) {
    return of(shadefit::acos, x, one() / shadefit::sqrt(one() - square(x.both())));
  }
  static T atan(const T& x) { return of(shadefit::atan, x, one() / (one() + square(x.both()))); }
  static T sinh(const T& x) { return of(shadefit::sinh, x, shadefit::cosh(x.both())); }
  static T cosh(const T& x) { return of(shadefit::cosh, x, shadefit::sinh(x.both())); }
  static T tanh(const T& x) { return of(shadefit::tanh, x, one() - square(shadefit::tanh(x.both()))); }
  /// 2/sqrt(pi) exp(-x^2) is at most 1.13.
  static T erf(const T& x) { return of(shadefit::erf, x, Interval(2)); }
  static T erfc(const T& x) { return of(shadefit::erfc, x, Interval(2)); }
  static T atan2(const T& y, const T& x) {
    const Interval value = shadefit::atan2(y.value, x.value);
    if (const GpuModel* const gpu = T::gpu_of(x, y))
      return T::enclosed(value, any_number(), unbounded_error, gpu);
    return T::rounded(value, shadefit::atan2(y.computed, x.computed), any_number());
  }
  static T floor(const T& x) { return step(shadefit::floor, x); }
  static T sign(const T& x) { return step(shadefit::signum, x); }
  static T abs(const T& x) {
    return T::enclosed(shadefit::abs(x.value), shadefit::abs(x.computed), x.error, x.gpu);
  }

  /// The slopes of x^p are p x^(p-1) and x^p log x.
  static T power(const T& x, const T& p) {
    const Interval b = x.both(), q = p.both();
    const Interval by_x = q * shadefit::power(b, Interval(q - one()));
    const Interval by_p = shadefit::power(b, q) * shadefit::log(b);
    const Interval inherited = T::effect(by_x, x.error) + T::effect(by_p, p.error);
    const Interval value = shadefit::power(x.value, p.value);
    const GpuModel* const gpu = T::gpu_of(x, p);
    if (gpu == nullptr) return T::rounded(value, shadefit::power(x.computed, p.computed), inherited);
    if (T::is_narrow) return narrow_power(x, p, value, gpu);
    if (!(ends_of(x).lower >= 0))
      return T::of_gpu(value, {-unbounded_error, unbounded_error}, any_number(), inherited, gpu);
    const Ends results = gpu_power(ends_of(x), ends_of(p), *gpu);
    const Interval own = Interval(results.upper) * Interval(gpu_power_error(ends_of(x), ends_of(p), *gpu));
    return T::of_gpu(value, results, own, inherited, gpu);
  }

  /// Certain only if the condition has one answer for both the true and the computed operands.
  static Certainty less(const T& a, const T& b) {
    const Certainty truly = shadefit::less(a.value, b.value);
    return truly == shadefit::less(a.computed, b.computed) ? truly : Certainty::unknown;
  }
  static T select(Certainty condition, const T& a, const T& b) {
    if (condition == Certainty::yes) return a;
    if (condition == Certainty::no) return b;
    return T::enclosed(hull(a.value, b.value), hull(a.computed, b.computed), unbounded_error,
                       T::gpu_of(a, b));
  }
  /// The larger of two numbers moves by no more than one of them.
  static T max(const T& a, const T& b) {
    return T::enclosed(shadefit::max(a.value, b.value), shadefit::max(a.computed, b.computed),
                       std::fmax(a.error, b.error), T::gpu_of(a, b));
  }
  static T min(const T& a, const T& b) { return -max(-a, -b); }

  static T integer(int n) { return T::rounded_number(Interval(n)); }
  static T from_decimal(std::string_view decimal) { return T::rounded_number(constant<Interval>(decimal)); }
  static T pi() { return T::rounded_number(shadefit::pi<Interval>()); }
  static T ln2() { return T::rounded_number(shadefit::ln2<Interval>()); }

 private:
  static constexpr double unbounded_error = std::numeric_limits<double>::infinity();

  /// On a GPU pow(x, p) is exp2(p log2 x). In half the product is a half too. 0^p is 0, for p > 0. A compiler
  /// may make p - 1 multiplications of a whole p that is a number of the code, as NVIDIA's does of 5: each
  /// rounds by half an ulp, in any order.
  static T narrow_power(const T& x, const T& p, const Interval& value, const GpuModel* gpu) {
    const auto [lower, upper] = ends_of(x);
    if (lower > 0) {
      const T result = exp2(p * log2(x));
      if (!is_whole_number(p)) return T::enclosed(value, result.computed, result.error, gpu);
      T product = x;
      for (int factors = 1; factors < ends_of(p).lower; ++factors) product = product * x;
      return T::enclosed(value, hull(result.computed, product.computed),
                         std::fmax(result.error, product.error), gpu);
    }
    if (!(lower == 0 && ends_of(p).lower > 0)) return T::enclosed(value, any_number(), unbounded_error, gpu);
    const Interval none(0);
    const Interval most = upper > 0 ? exp2(p * log2(T::exact(Interval(upper), gpu))).computed : none;
    return T::enclosed(value, hull(none, most), unbounded_error, gpu);
  }
  static bool is_whole_number(const T& p) {
    const auto [lower, upper] = ends_of(p);
    return p.gpu == nullptr && p.error == 0 && lower == upper && lower >= 2 && lower == std::floor(lower);
  }
  static Ends ends_of(const T& x) { return T::ends(x.computed); }
  static Interval one() { return Interval(1); }
  static Interval square(const Interval& x) { return shadefit::power(x, 2); }
  static Interval hull(const Interval& a, const Interval& b) { return Scalar<Interval>::hull(a, b); }
  template <class F>
  static T of(const F& function, const T& x, const Interval& slope) {
    if (x.gpu != nullptr) return T::enclosed(function(x.value), any_number(), unbounded_error, x.gpu);
    return T::rounded(function(x.value), function(x.computed), T::effect(slope, x.error));
  }
  template <class F>
  static T wave(const F& function, const T& x, const Interval& slope) {
    if (x.gpu == nullptr) return of(function, x, slope);
    const Interval value = function(x.value);
    const double own = gpu_wave_error(ends_of(x), *x.gpu);
    const Ends exact = T::ends(function(x.computed));
    return T::of_gpu(value, {exact.lower - own, exact.upper + own}, Interval(own), T::effect(slope, x.error),
                     x.gpu);
  }
  template <class F>
  static T step(const F& function, const T& x) {
    return T::enclosed(function(x.value), function(x.computed), unbounded_error, x.gpu);
  }
};

}  // namespace shadefit
