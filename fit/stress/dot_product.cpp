#include <cmath>

#include "approx/arithmetic.hpp"
#include "approx/fresnel.hpp"
#include "approx/full_range.hpp"
#include "approx/lobe.hpp"
#include "fit/stress/regime.hpp"

namespace shadefit {
namespace {

/// A shader's cosine: the dot product of two vectors, each normalised in the format. Here they are nearly
/// parallel, nearly orthogonal, or random.
double dot_of_normalised(const BinaryFormat& format, Sequence& sequence, int kind) {
  const auto round = [&](double x) { return round_to(format, x); };
  std::array<double, 3> a{}, b{};
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = round(sequence.between(-1, 1));
    const double other = sequence.between(-1, 1);
    b[i] = round(kind == 0 ? a[i] : kind == 1 ? a[i] + other * 0x1p-6 : other);
  }
  const auto dot = [&](const auto& p, const auto& q) {
    return round(round(round(p[0] * q[0]) + round(p[1] * q[1])) + round(p[2] * q[2]));
  };
  const auto normalise = [&](auto& v) {
    const double length = round(std::sqrt(dot(v, v)));
    for (double& x : v) x = round(x / length);
  };
  normalise(a);
  normalise(b);
  return dot(a, b);
}

/// The ends of [0, 1] from both sides, subnormals, and dot products.
std::vector<double> dot_products(const BinaryFormat& format, std::size_t random, std::uint64_t seed) {
  std::vector<double> all = edges(format, 1);
  const double ulp = 1 - below_one(format), tiny = least_subnormal(format);
  for (const double c : {-0.0, -tiny, -least_normal(format), -ulp, -0.5, -1.0, 1 + 2 * ulp, 1 + 4 * ulp,
                         1 + 8 * ulp, 1.001, 1.01})
    all.push_back(round_to(format, c));
  Sequence sequence(seed);
  for (std::size_t i = 0; i < random / 8; ++i)
    all.push_back(dot_of_normalised(format, sequence, static_cast<int>(i % 3)));
  std::erase_if(all, [](double c) { return std::isnan(c); });
  return all;
}

/// With every power, including 0.
std::vector<Input> with_powers(const BinaryFormat& format, std::size_t random, bool has_zero, double factor) {
  std::vector<Input> inputs;
  const auto cosines = dot_products(format, random, 4);
  for (const double k : {0.0, 0.001, 0.5, 1.0, 5.0, 100.0, 1000.0, 1e6, 1e9}) {
    const double power = round_to(format, k * factor);
    if (power > largest(format) || (k == 0 && !has_zero)) continue;
    for (const double c : cosines) inputs.push_back({c, power});
  }
  return inputs;
}

/// c^k by exp2 and log2, and by pow.
Regime power_regime() {
  return {.topic = "dot product",
          .domain = "any c in [-1, 1.01], k = 0 and in [0.001, 1e9]",
          .names = {"c", "k"},
          .forms = {{"power_by_exp2", "exp2(k log2(c))",
                     in_formats([](auto c, auto k) { return power_by_exp2(c, k); })},
                    // exp2; log2 and the product count per e-fold
                    {"power_by_exp2_of_dot", "exp2(k log2(c)), c clamped, 0^0 = 1",
                     in_formats([](auto c, auto k) { return power_by_exp2_of_dot(c, k); }),
                     Roundings{.functions = 1, .operations_per_fold = 1, .functions_per_fold = 1}},
                    {"power_lobe", "pow(c, k)", in_formats([](auto c, auto k) { return power_lobe(c, k); })},
                    // pow is one function of the library
                    {"power_lobe_of_dot", "pow(c, k), c clamped",
                     in_formats([](auto c, auto k) { return power_lobe_of_dot(c, k); }),
                     Roundings{.functions = 1}}},
          .truth = [](const Decimal50& dot,
                      const Decimal50& k) { return k == 0 ? Decimal50(1) : power_lobe(unit_cosine(dot), k); },
          .folds = [](double c, double k) { return c <= 0 || c >= 1 ? 0 : k * std::log(c); },
          .at_most = 1,
          .inputs = [](const BinaryFormat& format,
                       std::size_t random) { return with_powers(format, random, true, 1); }};
}

Regime gaussian_regime() {
  return {
      .topic = "dot product",
      .domain = "any c in [-1, 1.01], A = k/ln 2 for k in [0.001, 1e9], as far as A is finite",
      .names = {"c", "A"},
      .forms = {{"gaussian_lobe_base_two", "exp2(A c - A)",
                 in_formats([](auto c, auto a) { return gaussian_lobe_base_two(c, a); })},
                {"gaussian_lobe_base_two_of_dot", "exp2(A (c - 1)), c clamped",
                 in_formats([](auto c, auto a) { return gaussian_lobe_base_two_of_dot(c, a); }),
                 Roundings{.functions = 1, .operations_per_fold = 2}}},
      .truth = [](const Decimal50& dot,
                  const Decimal50& a) { return gaussian_lobe_base_two_of_difference(unit_cosine(dot), a); },
      .folds =
          [](double c, double a) {
            return a * (c < 0 ? -1 : c > 1 ? 0 : c - 1) * std::log(2.0);
          },
      .at_most = 1,
      .inputs = [](const BinaryFormat& format,
                   std::size_t random) { return with_powers(format, random, false, 1 / std::log(2.0)); }};
}

Regime schlick_regime() {
  return {
      .topic = "dot product",
      .domain = "any c in [-1, 1.01]",
      .names = {"c", ""},
      .forms = {{"schlick_weight", "(1 - c)^5", in_formats([](auto c, auto) { return schlick_weight(c); })},
                // 1 - c, taken five times, and the four products: x^2, its square (twice x^2), times x
                {"schlick_weight_of_dot", "(1 - c)^5, c clamped",
                 in_formats([](auto c, auto) { return schlick_weight_of_dot(c); }),
                 Roundings{.operations = 9}}},
      .truth = [](const Decimal50& dot, const Decimal50&) { return schlick_weight(unit_cosine(dot)); },
      .at_most = 1,
      .inputs =
          [](const BinaryFormat& format, std::size_t random) {
            return single_inputs(format, dot_products(format, 8 * random, 5));
          }};
}

}  // namespace

std::vector<Regime> dot_product_regimes() {
  return {power_regime(), gaussian_regime(), schlick_regime()};
}

}  // namespace shadefit
