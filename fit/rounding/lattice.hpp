#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "approx/scalar.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "fit/support/decimal.hpp"

/// The finite numbers of a format as a lattice: neighbouring numbers have neighbouring indices.
namespace shadefit {

/// The number format that constants are rounded to.
struct NumberFormat {
  enum class Kind { half, bfloat16, single, decimal };
  Kind kind = Kind::half;
  int digits = 0;  ///< significant digits of a decimal, 1 to 17

  bool operator==(const NumberFormat&) const = default;

  /// Whether [0, 1] holds so few numbers that a form is evaluated at every one of them.
  bool is_narrow() const { return kind == Kind::half || kind == Kind::bfloat16; }
};

/// "half", "bfloat16", "float", "decimal:5".
std::string to_text(const NumberFormat& format);

/// The format that the text of an option names. Throws UserError with one line for any other text.
NumberFormat parse_number_format(const std::string& option, const std::string& text);

/// The same for a format in which a form is evaluated, half or float.
NumberFormat parse_evaluated_format(const std::string& option, const std::string& text);

/// The numbers of a binary format by their bits: index i >= 0 is the i-th number from zero up, -i its
/// negative; both zeros are 0. Scaled so that the least normal number is that of double, the leading bits of
/// a number are its index.
template <class Format>
struct BinaryLattice {
  static constexpr int scale = -1022 - Format::least_exponent, dropped_bits = 53 - Format::digits;

  std::int64_t last() const { return index_of(largest_of<Format>); }
  double value(std::int64_t index) const {
    const double magnitude = std::ldexp(std::bit_cast<double>(std::abs(index) << dropped_bits), -scale);
    return index < 0 ? -magnitude : magnitude;
  }
  /// The index of the number nearest to x; beyond `last()` if x overflows.
  std::int64_t nearest(double x) const {
    const double rounded = static_cast<double>(NarrowResult<Format>::rounded(std::abs(x)));
    const std::int64_t index = rounded <= largest_of<Format> ? index_of(rounded) : last() + 1;
    return x < 0 ? -index : index;
  }

 private:
  static std::int64_t index_of(double magnitude) {
    return std::bit_cast<std::int64_t>(std::ldexp(magnitude, scale)) >> dropped_bits;
  }
};

/// The decimals of N significant digits from 10^-20 to below 10^21, zero and their negatives. A value is the
/// double nearest to the decimal, as a compiler reads it.
struct DecimalLattice {
  int digits;

  static constexpr int least_power = -20;
  static constexpr int largest_power = 20;

  std::int64_t fractions() const {
    std::int64_t tens = 1;
    for (int i = 1; i < digits; ++i) tens *= 10;
    return 9 * tens;
  }
  std::int64_t last() const { return fractions() * (largest_power - least_power + 1); }

  double value(std::int64_t index) const;
  std::int64_t nearest(double x) const;
  /// "-5.5547", "1.2e-07": the decimal itself.
  std::string text(std::int64_t index) const;
};

/// The least decimal digits that read back as a number of the lattice.
template <class Lattice>
std::string shortest(const Lattice& lattice, std::int64_t index) {
  const double value = lattice.value(index);
  constexpr int enough = 17;
  for (int digits = 1; digits < enough; ++digits) {
    const std::string text = decimal(value, digits);
    if (lattice.nearest(constant<double>(text)) == index) return text;
  }
  return decimal(value, enough);
}
inline std::string shortest(const DecimalLattice& lattice, std::int64_t index) {
  return lattice.text(index);
}

/// The largest number of a lattice, as text.
template <class Format>
std::string largest_text(const BinaryLattice<Format>&) {
  return decimal(largest_of<Format>, 6);
}
inline std::string largest_text(const DecimalLattice&) {
  return "1e" + std::to_string(DecimalLattice::largest_power + 1);
}

}  // namespace shadefit
