#include <cmath>

#include "approx/arithmetic.hpp"
#include "approx/fresnel.hpp"
#include "approx/full_range.hpp"
#include "approx/lobe.hpp"
#include "fit/stress/forms.hpp"

namespace shadefit {
namespace {

/// c^k from y = 1 - c, which has more digits than c near the peak.
Regime near_peak() {
  return {.topic = "lobe",
          .domain = "y = 1 - c in [0, 1], k in [0.001, 1e9]",
          .names = {"y", "k"},
          .forms = {{"power_lobe", "pow(1 - y, k)",
                     in_formats([](auto y, auto k) { return power_lobe(integer<decltype(y)>(1) - y, k); })},
                    // exp; its argument, k times log1p, counts per e-fold
                    {"power_lobe_near_peak", "exp(k log1p(-y))",
                     in_formats([](auto y, auto k) { return power_lobe_near_peak(y, k); }),
                     Roundings{.functions = 1, .operations_per_fold = 1, .functions_per_fold = 1}}},
          .truth = [](const Decimal50& y, const Decimal50& k) { return power_lobe(Decimal50(1 - y), k); },
          .folds = [](double y, double k) { return k * std::log1p(-y); },
          .inputs = [](const BinaryFormat& format,
                       std::size_t random) { return near_peak_inputs(format, random, 1); }};
}

/// A c - A against A (c - 1), A = k/ln 2.
Regime base_two() {
  const auto inputs = [](const BinaryFormat& format, std::size_t random) {
    std::vector<Input> all;
    for (const Input& i : near_peak_inputs(format, random, 3)) {
      const double base_two = round_to(format, i[1] / std::log(2.0));
      if (base_two > largest(format)) continue;
      all.push_back({round_to(format, 1 - i[0]), base_two});
      if (i[0] < 0x1p-8) all.push_back({i[0], base_two});
    }
    return all;
  };
  return {.topic = "gaussian",
          .domain = "c in [0, 1], A = k/ln 2 for k in [0.001, 1e9], as far as A is finite",
          .names = {"c", "A"},
          .forms = {{"gaussian_lobe_base_two", "exp2(A c - A)",
                     in_formats([](auto c, auto a) { return gaussian_lobe_base_two(c, a); })},
                    // exp2; the difference and the product count per e-fold
                    {"gaussian_lobe_base_two_of_difference", "exp2(A (c - 1))",
                     in_formats([](auto c, auto a) { return gaussian_lobe_base_two_of_difference(c, a); }),
                     Roundings{.functions = 1, .operations_per_fold = 2}}},
          .truth = [](const Decimal50& c,
                      const Decimal50& a) { return gaussian_lobe_base_two_of_difference(c, a); },
          .folds = [](double c, double a) { return a * (c - 1) * std::log(2.0); },
          .inputs = inputs};
}

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
  std::vector<double> all = edges(format);
  const double ulp = 1 - below_one(format), tiny = least_subnormal(format);
  for (const double c : {-0.0, -tiny, -least_normal(format), -ulp, -0.5, -1.0, 1 + 2 * ulp, 1 + 4 * ulp,
                         1 + 8 * ulp, 1.001, 1.01})
    all.push_back(round_to(format, c));
  Sequence sequence(seed);
  for (std::size_t i = 0; i < random; ++i)
    all.push_back(dot_of_normalised(format, sequence, static_cast<int>(i % 3)));
  std::erase_if(all, [](double c) { return std::isnan(c); });
  return all;
}

/// c^k of a dot product, by exp2 and log2, and by pow.
Regime of_dot_product() {
  const auto inputs = [](const BinaryFormat& format, std::size_t random) {
    std::vector<Input> all;
    const auto cosines = dot_products(format, random / 8, 4);
    for (const double k : {0.0, 0.001, 0.5, 1.0, 5.0, 100.0, 1000.0, 1e6, 1e9}) {
      if (round_to(format, k) > largest(format)) continue;
      for (const double c : cosines) all.push_back({c, round_to(format, k)});
    }
    return all;
  };
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
          .inputs = inputs};
}

Regime schlick_of_dot_product() {
  const auto inputs = [](const BinaryFormat& format, std::size_t random) {
    std::vector<Input> all;
    for (const double c : dot_products(format, random, 5)) all.push_back({c, 0});
    return all;
  };
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
      .folds = nullptr,
      .inputs = inputs};
}

}  // namespace

std::vector<Regime> stress_regimes() {
  return {near_peak(), base_two(), of_dot_product(), schlick_of_dot_product()};
}

}  // namespace shadefit
