#include "approx/lobe.hpp"

#include <cmath>

#include "approx/arithmetic.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/stress/regime.hpp"

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
          .at_most = 1,
          .inputs = [](const BinaryFormat& format,
                       std::size_t random) { return near_peak_inputs(format, 1, random, 1); }};
}

/// cos^k(theta/2) from y = 1 - cos(theta). y/2 must be a number of the format, because k multiplies its
/// rounding.
Regime half_angle() {
  const auto inputs = [](const BinaryFormat& format, std::size_t random) {
    auto all = near_peak_inputs(format, 2, random, 2);
    std::erase_if(all, [&](const Input& i) { return 0 < i[0] && i[0] < 2 * least_normal(format); });
    return all;
  };
  return {.topic = "half angle",
          .domain = "y = 1 - cos(theta) in [0, 2], 0 or y/2 normal; k in [0.001, 1e9]",
          .names = {"y", "k"},
          .forms = {{"blinn_lobe_of_cosine", "pow((1 + c)/2, k/2), c = 1 - y", in_formats([](auto y, auto k) {
                       const auto one = integer<decltype(y)>(1);
                       return blinn_lobe_of_cosine(decltype(y)(one - y), k, one);
                     })},
                    // as power_lobe_near_peak: halving is exact
                    {"half_angle_power", "exp(k/2 log1p(-y/2))",
                     in_formats([](auto y, auto k) { return half_angle_power(y, k); }),
                     Roundings{.functions = 1, .operations_per_fold = 1, .functions_per_fold = 1}}},
          .truth = [](const Decimal50& y,
                      const Decimal50& k) { return power_lobe(Decimal50(1 - y / 2), Decimal50(k / 2)); },
          .folds = [](double y, double k) { return k / 2 * std::log1p(-y / 2); },
          .at_most = 1,
          .inputs = inputs};
}

/// A c - A against A (c - 1), A = k/ln 2.
Regime base_two() {
  const auto inputs = [](const BinaryFormat& format, std::size_t random) {
    std::vector<Input> all;
    for (const Input& i : near_peak_inputs(format, 1, random, 3)) {
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
          .at_most = 1,
          .inputs = inputs};
}

}  // namespace

std::vector<Regime> lobe_regimes() {
  return {near_peak(), half_angle(), base_two()};
}

}  // namespace shadefit
