#include "fit/stress/numbers.hpp"

#include <algorithm>
#include <cmath>

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"
#include "fit/catalogue/published.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit {
namespace {

/// The next number of the format above (`up`) or below one that is not negative; a subnormal step at 0.
double neighbour(const BinaryFormat& format, double x, bool up) {
  const int exponent = x == 0 ? format.least_exponent : std::max(std::ilogb(x), format.least_exponent);
  const double step = std::ldexp(1.0, exponent - format.digits + 1);
  if (up) return x + step;
  // Below a power of two the spacing is half.
  const bool shrinks = x == std::ldexp(1.0, exponent) && exponent > format.least_exponent;
  return x - (shrinks ? step / 2 : step);
}

/// The numbers in [low, high] of a list, sorted, without duplicates.
std::vector<double> each_once(std::vector<double> numbers, double low, double high) {
  std::erase_if(numbers, [&](double x) { return !(low <= x && x <= high); });
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

double round_to(const BinaryFormat& format, double x) {
  if (format.name == half_format.name) return widened(rounded_to<Eigen::half>(x));
  return format.name == float_format.name ? widened(rounded_to<float>(x)) : x;
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
                                    double low, double high) {
  std::vector<double> found;
  for (const double number : numbers) {
    const double x = round_to(format, number);
    for (const double near : {x, neighbour(format, x, false), neighbour(format, x, true)})
      found.push_back(near);
  }
  return each_once(found, low, high);
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
  const auto add = [&](double k) { all.push_back(round_to(format, k)); };
  for (double decade = 1e-3; decade <= 1e9; decade *= 10) {
    for (const double times : {1.0, 5.0}) add(decade * times);
  }
  add(constant<double>(find_published("sg-offset-mean")->printed));
  for (const double more : {3.7, 15.0, 1024.0, 2048.0, 65504.0, 1e9}) add(more);
  return each_once(all, 1e-3, std::min(1e9, largest(format)));
}

std::vector<Input> near_peak_inputs(const BinaryFormat& format, std::size_t random, std::uint64_t seed) {
  std::vector<Input> inputs;
  const double folds = -std::log(least_subnormal(format));
  const auto slope = [&](double t, double k) { return std::min(round_to(format, t / k), 1.0); };
  const auto all_edges = edges(format);
  for (const double k : exponents(format)) {
    for (const double y : all_edges) inputs.push_back({y, k});
    for (double t = 0x1p-6; t < 1.25 * folds; t *= 1.375) inputs.push_back({slope(t, k), k});
  }
  Sequence sequence(seed);
  for (std::size_t i = 0; i < random; ++i) {
    const double k = round_to(format, log_uniform(sequence, 1e-3, std::min(1e9, largest(format))));
    const double y = i % 2 == 0 ? slope(sequence.between(0, folds), k)
                                : round_to(format, log_uniform(sequence, least_normal(format), 1));
    inputs.push_back({y, k});
  }
  return inputs;
}

std::vector<double> edges(const BinaryFormat& format) {
  std::vector<double> all{0, least_subnormal(format), 3 * least_subnormal(format), least_normal(format), 1};

  for (int e = format.least_exponent; e <= 1; e = e < -60 ? e / 2 : e < -12 ? e + 4 : e + 1)
    all.push_back(std::ldexp(1.0, e));
  for (const double decimal : {0.1, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.1, 1.5, 1.9, 0.99, 0.999})
    all.push_back(decimal);
  return with_neighbours(format, all, 0, 1);
}

}  // namespace shadefit
