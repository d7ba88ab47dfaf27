#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "bench/forms/catalogue.hpp"

/// Compares a form at every float of a stretch with the reference rounded to float.
namespace shadefit::bench {

/// Bit patterns of floats, [from, to): those of non-negative floats are in the order of the numbers.
struct Stretch {
  std::uint32_t from, to;
  std::uint64_t size() const { return to > from ? to - from : 0; }
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

/// The errors on a stretch; places are the bit patterns of floats. Of equal maxima the smallest place is
/// kept.
struct FloatErrors {
  /// |form - reference|, rounded to float, so that the last bit of a library's pow does not matter.
  float max_abs_error = 0;
  std::uint32_t max_abs_error_at = 0;
  std::uint32_t max_ulps = 0;  ///< floats between the form and the truth rounded to float
  std::uint32_t max_ulps_at = 0;
  std::array<std::uint64_t, 33> ulps{};  ///< [0]: none; [i]: 2^(i-1) to 2^i - 1
  std::uint64_t nans = 0, above_one = 0, below_zero = 0;
  std::uint64_t beyond = 0;                ///< results beyond the bound of a device
  std::vector<std::uint32_t> beyond_at{};  ///< the places of the first of them, at most `most_places`
  static constexpr std::size_t most_places = 8;
  bool operator==(const FloatErrors&) const = default;

  /// The number of tested inputs.
  std::uint64_t count() const;
};

/// The form and its reference. Both take `count` floats in rising order, and are called by several threads at
/// once.
struct FloatSubject {
  std::function<void(const float* in, float* out, std::size_t count)> form;
  std::function<void(const float* in, double* out, std::size_t count)> truth;
  /// Where the form has to be: within `radius` of `middle`. Empty: anywhere.
  std::function<void(const float* in, double* middle, double* radius, std::size_t count)> bound = {};
  /// Called by one thread before the floats of a stretch are looked at. Empty: nothing to prepare.
  std::function<void(const Stretch&)> prepare = {};
};

/// A form of the catalogue with a set of its constants, and the target that it is compared with.
struct SweptForm {
  const forms::FormEntry* form;
  const forms::Target* target;
  const forms::Constants* constants;
};

/// The form in float, and as the reference the target's formula in double, by the library. The reference's
/// error is a few last bits of a double: less than one for pow of the C library (as documented), half of one
/// for 1 - c of a float, multiplied by a power of some tens. One ulp of a float is 2^29 ulps of a double, so
/// the reference rounds to the right float, except within a millionth of the middle between two floats.
FloatSubject subject_of(const SweptForm& swept);

/// The errors on a stretch, on all cores. `between` gets the finished share, and may end the work by
/// throwing.
FloatErrors errors_on(
    const FloatSubject& subject, const Stretch& stretch,
    const std::function<void(double share)>& between = [](double) {});

}  // namespace shadefit::bench
