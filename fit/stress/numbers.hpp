#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fit/errors/ulps.hpp"
#include "fit/stress/sequence.hpp"

/// The numbers of a format that forms are tried at. Numbers of half and float are held as doubles, exactly.
namespace shadefit {

/// One or two numbers of a format; the second is 0 where a form has one argument.
using Input = std::array<double, 2>;

/// A double rounded to the format, once.
double round_to(const BinaryFormat& format, double x);

/// The least positive subnormal, the least normal and the largest finite number.
double least_subnormal(const BinaryFormat& format);
double least_normal(const BinaryFormat& format);
double largest(const BinaryFormat& format);
/// The largest number below 1.
double below_one(const BinaryFormat& format);

/// Of a list: what lies in [low, high] once rounded to the format, each with its `reach` neighbours on either
/// side that lie there too; sorted, each once.
std::vector<double> with_neighbours(const BinaryFormat& format, const std::vector<double>& numbers,
                                    double low, double high, int reach = 2);

/// A positive number between two others whose exponent is uniform: as many per binade in each.
double log_uniform(Sequence& sequence, double low, double high);

/// Powers that a renderer meets and more: 1e-3 .. 1e9 by decades, with 5 and what the format ends at, as
/// far as the format has them.
std::vector<double> exponents(const BinaryFormat& format);

/// Pairs (y, k) of a lobe: every exponent with the edges of y in [0, high] and with y = t/k, t up to where
/// the format underflows, where the lobe has its slope; and random ones of both kinds.
std::vector<Input> near_peak_inputs(const BinaryFormat& format, double high, std::size_t random,
                                    std::uint64_t seed);

/// Where numbers in [0, high] have their edges: 0, subnormals, powers of two, decimals, the ends.
std::vector<double> edges(const BinaryFormat& format, double high);

}  // namespace shadefit
