#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>

/// Compares a form at every float of a stretch with the reference rounded to float.
namespace shadefit::bench {

/// Bit patterns of floats, [from, to): those of non-negative floats are in the order of the numbers.
struct Stretch {
  std::uint32_t from, to;
  std::uint64_t size() const { return to > from ? to - from : 0; }
  bool operator==(const Stretch&) const = default;
};

/// Every float in [0, 1]: 1 065 353 217 of them.
inline constexpr Stretch unit_floats{0, std::bit_cast<std::uint32_t>(1.0F) + 1};

/// How many floats lie between two, one of them included: 0 for equal ones, zeros of both signs too; 1 for
/// neighbours, across zero and powers of two as elsewhere. No NaN.
inline std::uint32_t float_steps(float a, float b) {
  // The patterns of negative floats are in reverse order; mirrored at zero, all are in the order of the
  // numbers.
  const auto place = [](float x) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    return bits < 0 ? std::int64_t{INT32_MIN} - bits : std::int64_t{bits};
  };
  const std::int64_t steps = place(a) - place(b);
  return static_cast<std::uint32_t>(steps < 0 ? -steps : steps);
}

/// The errors on a stretch. All members are counts or maxima, so the result does not depend on the pieces and
/// the order of the work. Of equal maxima the smallest input is kept.
struct FloatErrors {
  /// |form - reference|, rounded to float, so that the last bit of a library's pow does not matter.
  float max_abs_error = 0;
  std::uint32_t max_abs_error_at = UINT32_MAX;  ///< a bit pattern; UINT32_MAX: no input was tested
  std::uint32_t max_ulps = 0;                   ///< floats between the form and the truth rounded to float
  std::uint32_t max_ulps_at = UINT32_MAX;
  std::array<std::uint64_t, 33> ulps{};  ///< [0]: none; [i]: 2^(i-1) to 2^i - 1
  std::uint64_t nans = 0, above_one = 0, below_zero = 0;
  /// Results beyond the bound, and the smallest of their inputs in order. UINT32_MAX: no more.
  std::uint64_t beyond = 0;
  std::array<std::uint32_t, 8> beyond_at{UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX,
                                         UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX};
  bool operator==(const FloatErrors&) const = default;

  /// The number of tested inputs.
  std::uint64_t count() const;
};

/// Adds the errors on another stretch.
void include(FloatErrors& into, const FloatErrors& more);

/// The form and its reference. Both take `count` floats, a multiple of 64, in rising order, and are called by
/// several threads at once.
struct FloatSubject {
  std::function<void(const float* in, float* out, std::size_t count)> form;
  std::function<void(const float* in, double* out, std::size_t count)> truth;
  /// Where the form has to be: within `radius` of `middle`. Empty: anywhere.
  std::function<void(const float* in, double* middle, double* radius, std::size_t count)> bound = {};
  /// Called by one thread before `errors_on` looks at the floats of a stretch. Empty: nothing to prepare.
  std::function<void(const Stretch&)> prepare = {};
};

/// The errors on a stretch.
FloatErrors errors_on(const FloatSubject& subject, const Stretch& stretch);

/// The same on several threads, at least one. Rethrows an exception of a thread.
FloatErrors errors_on(const FloatSubject& subject, const Stretch& stretch, unsigned threads);

}  // namespace shadefit::bench
