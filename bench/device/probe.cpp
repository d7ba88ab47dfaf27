#include "bench/device/probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "bench/device/evaluator.hpp"
#include "fit/input/parallel.hpp"
#include "fit/stress/numbers.hpp"

namespace shadefit::device {
namespace {

/// Bit patterns of floats, [from, to).
struct Patterns {
  std::uint32_t from, to;
};

constexpr std::uint32_t bits_of(float x) {
  return std::bit_cast<std::uint32_t>(x);
}
constexpr std::uint32_t infinite = bits_of(std::numeric_limits<float>::infinity());
constexpr std::uint32_t least_normal = bits_of(std::numeric_limits<float>::min());

void include(LargestError& into, const LargestError& more) {
  into.count += more.count;
  if (more.error > into.error) into = {more.error, more.at, into.count};
}

/// 1/ulp for floats near `truth`, which must be in the range of normal floats.
double per_ulp(double truth) {
  constexpr std::uint64_t exponent_bits = 0x7ff0000000000000, twice_the_bias = 0x7fe0000000000000;
  const std::uint64_t power = std::bit_cast<std::uint64_t>(truth) & exponent_bits;
  return std::bit_cast<double>(twice_the_bias - power) / float_ulp;
}

/// The unit of an error.
enum class Unit { ulp, one };

double error_of(float result, double truth, Unit unit) {
  const double off = std::abs(static_cast<double>(result) - truth);
  const double error = unit == Unit::ulp ? off * per_ulp(truth) : off;
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

/// The largest error of the results for bit patterns from `first` on.
template <class Truth>
LargestError largest_error(std::uint32_t first, std::span<const std::uint32_t> results, Unit unit,
                           const Truth& truth) {
  double most = -1;
  std::size_t place = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto x = static_cast<double>(std::bit_cast<float>(first + static_cast<std::uint32_t>(i)));
    const double error = error_of(std::bit_cast<float>(results[i]), truth(x), unit);
    if (error > most) {
      most = error;
      place = i;
    }
  }
  return {most, {std::bit_cast<float>(first + static_cast<std::uint32_t>(place))}, results.size()};
}

/// Measures functions on a device.
class Bench {
 public:
  Bench(VulkanDevice& device, const Checkpoint& checkpoint) : device_(device), checkpoint_(checkpoint) {}

  /// The largest error of a function of one argument over ranges of floats.
  template <class Truth>
  LargestError over(const Symbolic& function, std::span<const Patterns> stretches, Unit unit,
                    const Truth& truth) {
    Evaluator evaluator = on_device({"x"}, function, Arguments::patterns);
    LargestError found;
    for (const auto& [from, to] : stretches) {
      evaluator.over_patterns(from, to, [&](std::uint32_t first, std::span<const std::uint32_t> results) {
        checkpoint_();
        include(found, in_parallel(first, results, unit, truth));
      });
    }
    return found;
  }

  /// The largest error of a function of several arguments at these. Results that are not normal do not count.
  template <std::size_t N, class Truth>
  LargestError at(const Symbolic& function, const std::vector<std::array<float, N>>& arguments,
                  const Truth& truth) {
    const std::vector<float> results = values(function, arguments);
    LargestError found;
    for (std::size_t i = 0; i < results.size(); ++i) {
      std::array<double, N> x;
      std::copy(arguments[i].begin(), arguments[i].end(), x.begin());
      const double exact = std::apply(truth, x);
      if (!(least_normal_of<FloatFormat> <= exact && exact <= largest_of<FloatFormat>)) continue;
      include(found, {error_of(results[i], exact, Unit::ulp), {arguments[i].begin(), arguments[i].end()}, 1});
    }
    return found;
  }

  template <std::size_t N>
  std::vector<float> values(const Symbolic& function, const std::vector<std::array<float, N>>& arguments) {
    const std::array<std::string, 3> names{"x", "y", "z"};
    Evaluator evaluator = on_device({names.begin(), names.begin() + N}, function, Arguments::input);
    std::vector<float> flat, results;
    for (const auto& x : arguments) flat.insert(flat.end(), x.begin(), x.end());
    for (const std::uint32_t bits : evaluator.of_input(flat)) results.push_back(std::bit_cast<float>(bits));
    return results;
  }

 private:
  Evaluator on_device(const std::vector<std::string>& names, const Symbolic& function, Arguments arguments) {
    return {device_, compiler_, {"probed", names, function}, ShaderLanguage::glsl, arguments};
  }

  template <class Truth>
  static LargestError in_parallel(std::uint32_t first, std::span<const std::uint32_t> results, Unit unit,
                                  const Truth& truth) {
    constexpr std::size_t piece = 1U << 16;
    std::vector<LargestError> parts((results.size() + piece - 1) / piece);
    for_each_in_parallel(parts.size(), [&](std::size_t i, const Checkpoint&) {
      const auto some = results.subspan(i * piece, std::min(piece, results.size() - i * piece));
      parts[i] = largest_error(first + static_cast<std::uint32_t>(i * piece), some, unit, truth);
    });
    LargestError found;
    for (const LargestError& part : parts) include(found, part);
    return found;
  }

  VulkanDevice& device_;
  ShaderCompiler compiler_;
  const Checkpoint& checkpoint_;
};

Symbolic variable(const char* name) {
  return Symbolic::variable(name);
}

/// The floats of these ranges: all of them, or about 1 % from each.
std::vector<Patterns> chosen_of(std::span<const Patterns> ranges, ProbeExtent extent) {
  if (extent == ProbeExtent::all) return {ranges.begin(), ranges.end()};
  constexpr std::uint32_t share = 100, size = 1U << 17;
  std::vector<Patterns> some;
  for (const auto& [first, end] : ranges) {
    for (std::uint64_t from = first; from < end; from += share * size)
      some.push_back({static_cast<std::uint32_t>(from),
                      static_cast<std::uint32_t>(std::min<std::uint64_t>(from + size, end))});
  }
  return some;
}

double exact_exp2(double a) {
  // 2^a = 1 + a ln 2 + .., the rest below 2^-54.
  return std::abs(a) < 0x1p-26 ? 1 + a * Scalar<double>::ln2() : std::exp2(a);
}

std::vector<std::array<float, 2>> pairs(std::uint64_t seed, std::array<double, 2> first,
                                        std::array<double, 2> second) {
  constexpr std::size_t count = 1U << 20;
  Sequence sequence(seed);
  std::vector<std::array<float, 2>> drawn(count);
  for (auto& pair : drawn)
    pair = {static_cast<float>(log_uniform(sequence, first[0], first[1])),
            static_cast<float>(log_uniform(sequence, second[0], second[1]))};
  return drawn;
}

LargestError exp2_on(Bench& bench, ProbeExtent extent) {
  const std::array normal{Patterns{0, bits_of(128.0F)}, Patterns{bits_of(-0.0F), bits_of(-126.0F) + 1}};
  return bench.over(Symbolic::function("exp2", {variable("x")}), chosen_of(normal, extent), Unit::ulp,
                    exact_exp2);
}

/// The errors outside of [1/2, 2] and inside.
std::pair<LargestError, LargestError> log2_on(Bench& bench, ProbeExtent extent) {
  const auto log2 = [](double a) { return std::log2(a); };
  const Symbolic function = Symbolic::function("log2", {variable("x")});
  const std::array far{Patterns{least_normal, bits_of(0.5F)}, Patterns{bits_of(2.0F) + 1, infinite}};
  const std::array near{Patterns{bits_of(0.5F), bits_of(2.0F) + 1}};
  return {bench.over(function, chosen_of(far, extent), Unit::ulp, log2),
          bench.over(function, chosen_of(near, extent), Unit::one, log2)};
}

/// The result for one set of arguments.
template <std::size_t N>
float value(Bench& bench, const Symbolic& function, const std::array<float, N>& arguments) {
  return bench.values(function, std::vector{arguments}).front();
}

}  // namespace

Probe probe(VulkanDevice& device, ProbeExtent extent, const Checkpoint& checkpoint) {
  Bench bench(device, checkpoint);
  const Symbolic x = variable("x"), y = variable("y"), z = variable("z");
  Probe found;
  const std::array normal{Patterns{least_normal, infinite}},
      with_normal_reciprocal{Patterns{least_normal, bits_of(0x1p126F) + 1}};
  found.exp2 = exp2_on(bench, extent);
  std::tie(found.log2, found.log2_near_one) = log2_on(bench, extent);
  found.root = bench.over(Symbolic::function("sqrt", {x}), chosen_of(normal, extent), Unit::ulp,
                          [](double a) { return std::sqrt(a); });
  found.reciprocal = bench.over(Symbolic::number("1") / x, chosen_of(with_normal_reciprocal, extent),
                                Unit::ulp, [](double a) { return 1 / a; });
  found.quotient = bench.at(x / y, pairs(1, {0x1p-60, 0x1p60}, {0x1p-60, 0x1p60}),
                            [](double a, double b) { return a / b; });
  found.power = bench.at(power(x, y), pairs(2, {0x1p-8, 1}, {1, 64}),
                         [](double a, double b) { return std::pow(a, b); });

  const float a = 1 + 0x1p-12F;  // its square is 1 + 2^-11 + 2^-24, which is not a float
  found.fuses = value(bench, x * y + z, std::array{a, a, -(1 + 0x1p-11F)}) == 0x1p-24F;
  found.keeps_small_operands = value(bench, x * y, std::array{0x1p-130F, 0x1p20F}) == 0x1p-110F;
  found.keeps_small_results = value(bench, x * y, std::array{0x1p-110F, 0x1p-20F}) == 0x1p-130F;
  return found;
}

std::string against_usual(const Probe& found) {
  const bool has_usual_exp2 = found.exp2.error <= usual_gpu.exp2_ulps;
  const bool has_usual_log2 =
      found.log2.error <= usual_gpu.log2_ulps && found.log2_near_one.error <= usual_gpu.log2_near_one;
  const auto verdict = [](bool is_usual) { return is_usual ? "as exact as" : "coarser than"; };
  return fmt::format(
      "exp2 is {} shadefit assumes of a GPU ({} ulp), log2 {} it assumes ({} ulp; {:.4g} for 1/2 .. 2)\n",
      verdict(has_usual_exp2), usual_gpu.exp2_ulps, verdict(has_usual_log2), usual_gpu.log2_ulps,
      usual_gpu.log2_near_one);
}

GpuModel model_for(forms::Function function, VulkanDevice& device, const Checkpoint& checkpoint) {
  Bench bench(device, checkpoint);
  GpuModel model = usual_gpu;
  if (function != forms::Function::none) model.exp2_ulps = exp2_on(bench, ProbeExtent::all).error;
  if (function == forms::Function::pow) {
    const auto [far, near] = log2_on(bench, ProbeExtent::all);
    model.log2_ulps = far.error;
    model.log2_near_one = near.error;
  }
  return model;
}

}  // namespace shadefit::device
