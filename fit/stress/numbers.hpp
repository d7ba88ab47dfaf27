#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fit/errors/binary_format.hpp"

/// The inputs of a stress test, numbers of a format. Numbers of half and float are stored exactly as doubles.
namespace shadefit {

/// Random numbers that are the same on every machine: SplitMix64. Source: Steele, Lea, Flood 2014, "Fast
/// Splittable Pseudorandom Number Generators". The distributions of the standard library differ between
/// libraries; here a number is made from the bits directly.
class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1): a multiple of 2^-53.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// Uniform in [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t state_;
};

/// One or two numbers of a format; the second is 0 if a form has one argument.
using Input = std::array<double, 2>;

/// A double rounded to the format, once.
double round_to(const BinaryFormat& format, double x);

/// The least positive subnormal, the least normal and the largest finite number.
double least_subnormal(const BinaryFormat& format);
double least_normal(const BinaryFormat& format);
double largest(const BinaryFormat& format);
/// The largest number below 1.
double below_one(const BinaryFormat& format);

/// A list rounded to the format: the numbers in [low, high], each with its neighbours inside that range;
/// sorted, without duplicates.
std::vector<double> with_neighbours(const BinaryFormat& format, const std::vector<double>& numbers,
                                    double low, double high);

/// A positive random number between two others with a uniform exponent: equally many per binade.
double log_uniform(Sequence& sequence, double low, double high);

/// The powers of renderers and beyond: 1e-3 .. 1e9 by decades, 5, and the largest of the format, as far as
/// the format has them.
std::vector<double> exponents(const BinaryFormat& format);

/// Pairs (y, k) of a lobe: every exponent with the edges of y in [0, 1], and with y = t/k, where the lobe
/// has its slope, for t up to the underflow of the format; and random pairs of both kinds.
std::vector<Input> near_peak_inputs(const BinaryFormat& format, std::size_t random, std::uint64_t seed);

/// The edge cases in [0, 1]: 0, subnormals, powers of two, decimals, the ends.
std::vector<double> edges(const BinaryFormat& format);

}  // namespace shadefit
