#include "fit/stress/numbers.hpp"

#include <algorithm>
#include <cmath>

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"
#include "fit/ledger/formats.hpp"

namespace shadefit {
namespace {

/// The next number of the format above (`up`) or below a finite one; a subnormal step at 0.
double neighbour(const BinaryFormat& format, double x, bool up) {
  int exponent = format.least_exponent;
  if (x != 0) exponent = std::max(std::ilogb(x), format.least_exponent);
  const double step = std::ldexp(1.0, exponent - format.digits + 1);
  // Below a power of two the spacing is half.
  const bool shrinks =
      up == std::signbit(x) && std::abs(x) == std::ldexp(1.0, exponent) && exponent > format.least_exponent;
  const double by = shrinks ? step / 2 : step;
  return up ? x + by : x - by;
}

}  // namespace

double round_to(const BinaryFormat& format, double x) {
  return in_format(format.name, [&]<class T>() { return widened(rounded_to<T>(x)); });
}

double least_subnormal(const BinaryFormat& format) {
  return std::ldexp(1.0, format.least_exponent - format.digits + 1);
}

double least_normal(const BinaryFormat& format) {
  return std::ldexp(1.0, format.least_exponent);
}

double largest(const BinaryFormat& format) {
  return std::ldexp(2 - std::ldexp(1.0, 1 - format.digits), format.greatest_exponent);
}

double below_one(const BinaryFormat& format) {
  return 1 - std::ldexp(1.0, -format.digits);
}

std::vector<double> with_neighbours(const BinaryFormat& format, const std::vector<double>& numbers,
                                    double low, double high, int reach) {
  std::vector<double> found;
  const auto add = [&](double x) {
    if (low <= x && x <= high) found.push_back(x == 0 ? 0 : x);
  };
  for (const double number : numbers) {
    double below = round_to(format, number), above = below;
    add(below);
    for (int i = 0; i < reach; ++i) {
      add(below = neighbour(format, below, false));
      add(above = neighbour(format, above, true));
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

double log_uniform(Sequence& sequence, double low, double high) {
  const int first = std::ilogb(low), last = std::ilogb(high);
  for (;;) {
    const auto span = static_cast<std::uint64_t>(last - first + 1);
    const int exponent = first + static_cast<int>(sequence.next() % span);
    const double x = std::ldexp(1 + sequence.unit(), exponent);
    if (low <= x && x <= high) return x;
  }
}

std::vector<double> exponents(const BinaryFormat& format) {
  std::vector<double> all;
  for (double decade = 1e-3; decade <= 1e9; decade *= 10) {
    for (const double times : {1.0, 5.0}) all.push_back(decade * times);
  }
  const auto offset = constant<double>(sg_offset_published[0].printed);
  for (const double more : {offset, 3.7, 15.0, 1024.0, 2048.0, 65504.0, 1e9}) all.push_back(more);
  return with_neighbours(format, all, 1e-3, std::min(1e9, largest(format)), 0);
}

std::vector<Input> near_peak_inputs(const BinaryFormat& format, double high, std::size_t random,
                                    std::uint64_t seed) {
  std::vector<Input> inputs;
  const double folds = -std::log(least_subnormal(format));
  const auto slope = [&](double t, double k) { return std::min(round_to(format, t / k), high); };
  const auto all_edges = edges(format, high);
  for (const double k : exponents(format)) {
    for (const double y : all_edges) inputs.push_back({y, k});
    for (double t = 0x1p-6; t < 1.25 * folds; t *= 1.375) inputs.push_back({slope(t, k), k});
  }
  Sequence sequence(seed);
  for (std::size_t i = 0; i < random; ++i) {
    const double k = round_to(format, log_uniform(sequence, 1e-3, std::min(1e9, largest(format))));
    const double y = i % 2 == 0 ? slope(sequence.between(0, folds), k)
                                : round_to(format, high * log_uniform(sequence, least_normal(format), 1));
    inputs.push_back({y, k});
  }
  return inputs;
}

std::vector<Input> single_inputs(const BinaryFormat& format, const std::vector<double>& numbers) {
  std::vector<Input> all;
  for (const double x : numbers) all.push_back({round_to(format, x), 0});
  return all;
}

std::vector<double> edges(const BinaryFormat& format, double high) {
  std::vector<double> all{0, least_subnormal(format), 3 * least_subnormal(format), least_normal(format),
                          high};
  for (int e = format.least_exponent; e <= 1; e = e < -60 ? e / 2 : e < -12 ? e + 4 : e + 1)
    all.push_back(std::ldexp(1.0, e));
  for (const double decimal : {0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.1, 1.5, 1.9, 0.99, 0.999})
    all.push_back(decimal);
  return with_neighbours(format, all, 0, high, 1);
}

}  // namespace shadefit
