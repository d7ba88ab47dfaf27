#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "approx/full_range.hpp"
#include "approx/phase.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/von_mises_fisher.hpp"
#include "fit/stress/forms.hpp"
#include "reports/rows/stress_tables.hpp"

namespace shadefit {
namespace {

// The first numbers of the published generator for these seeds, and numbers that stay in their range.
TEST(Sequence, IsSplitMix64) {
  Sequence zero(0), other(1234567);
  EXPECT_EQ(zero.next(), 0xE220A8397B1DCDAFu);
  EXPECT_EQ(other.next(), 6457827717110365317u);
  EXPECT_EQ(other.next(), 3203168211198807973u);
  for (int i = 0; i < 1000; ++i) {
    const double x = other.between(2, 3), y = log_uniform(other, 1e-3, 1e9);
    EXPECT_TRUE(2 <= x && x < 3 && 1e-3 <= y && y <= 1e9);
  }
}

TEST(Numbers, AreOfTheirFormatWithTheirNeighbours) {
  EXPECT_EQ(with_neighbours(half_format, {1}, 0, 2), (std::vector{1 - 0x1p-11, 1.0, 1 + 0x1p-10}));
  EXPECT_EQ(with_neighbours(float_format, {0}, -1, 1), (std::vector{-0x1p-149, 0.0, 0x1p-149}));
  EXPECT_EQ(with_neighbours(double_format, {0x1p-1022}, 0, 1),
            (std::vector{0x1p-1022 - 0x1p-1074, 0x1p-1022, 0x1p-1022 + 0x1p-1074}));
  EXPECT_EQ(largest(half_format), 65504);
  EXPECT_EQ(below_one(double_format), std::nextafter(1.0, 0));
  for (const BinaryFormat& format : stress_formats) {
    const auto all = exponents(format);
    EXPECT_EQ(all.back(), std::min(1e9, largest(format)));
    EXPECT_TRUE(std::all_of(all.begin(), all.end(), [&](double k) { return round_to(format, k) == k; }));
  }
}

// Each form of the full range is the printed formula, in 50 digits.
TEST(FullRange, FormsAreThePrintedOnes) {
  const auto same = [](const Decimal50& form, const Decimal50& printed) {
    return Decimal50(abs(form - printed)) <= abs(printed) * Decimal50("1e-44");
  };
  for (const char* c_text : {"0", "0.001", "0.3", "0.5", "0.9", "0.999", "1"}) {
    const Decimal50 c(c_text), y = 1 - c;
    for (const char* k_text : {"0.001", "0.5", "1", "5", "37.5", "1000"}) {
      const Decimal50 k(k_text);
      EXPECT_TRUE(same(power_lobe_of_dot(c, k), power_lobe(c, k)));
      EXPECT_TRUE(same(half_angle_power(y, k), power_lobe(Decimal50(1 - y / 2), Decimal50(k / 2))));
      EXPECT_TRUE(same(power_by_exp2_of_dot(c, k), c > 0 ? power_by_exp2(c, k) : Decimal50(0)));
      EXPECT_TRUE(same(gaussian_lobe_base_two_of_dot(c, k), gaussian_lobe_base_two(c, k)));
      EXPECT_TRUE(same(von_mises_fisher_of_any_concentration(y, k), von_mises_fisher(c, k)));
      EXPECT_TRUE(same(von_mises_fisher_of_any_concentration(Decimal50(2 - y), k),
                       von_mises_fisher(Decimal50(-c), k)));
      EXPECT_TRUE(same(blinn_phong_brdf_constant_by_parts(k), BlinnPhongBrdfLobe::constant(k)));
    }
    for (const char* g_text : {"-0.99", "-0.5", "0", "0.001", "0.76", "0.999"}) {
      const Decimal50 g(g_text);
      EXPECT_TRUE(same(henyey_greenstein_from_both_sides(y, g), henyey_greenstein(c, g)));
      EXPECT_TRUE(
          same(henyey_greenstein_from_both_sides(Decimal50(2 - y), g), henyey_greenstein(Decimal50(-c), g)));
    }
    EXPECT_TRUE(same(schlick_weight_of_dot(c), schlick_weight(c)));
    EXPECT_TRUE(same(decode_clamped_gloss(c, Decimal50(10), Decimal50(1)),
                     decode_gloss(c, Decimal50(10), Decimal50(1))));
  }
  EXPECT_EQ(unit_cosine(-0.25), 0);
  EXPECT_EQ(unit_cosine(1.25), 1);
  EXPECT_TRUE(
      same(von_mises_fisher_of_any_concentration(Decimal50(1), Decimal50(0)), 1 / (4 * pi<Decimal50>())));
}

/// A form that states its bound, tested at pairs of numbers against itself in 50 digits.
struct Bounded {
  const char* name;
  InFormats evaluate;
  Decimal50 (*truth)(const Decimal50&, const Decimal50&);
  Roundings bound;
  double (*folds)(double, double);
  std::vector<double> first, second;
};

using Numbers = std::vector<double>;
using Folds = double (*)(double, double);
const Numbers cosines{-0.5, -0x1p-30, -0.0, 1e-30, 1e-7, 0.3, 0.5, 0.999, 1 - 0x1p-11, 1, 1.004};
const Numbers from_peak{0, 1e-30, 1e-9, 1e-4, 0.01, 0.3, 1, 1.5, 2 - 0x1p-10, 2};
const Numbers powers{0x1p-14, 1e-3, 0.5, 5, 11.09, 37.5, 88.72, 89.4, 710, 1e3, 6e4, 1e9};
const Numbers concentrations{0, 1e-7, 1e-3, 1, 11.09, 88.72, 89.4, 709.7, 710.5, 711, 6e4, 1e9};

template <class Formula>
Bounded bounded(
    const char* name, Formula formula, Roundings bound, const Numbers& first, const Numbers& second = {0},
    Folds folds = [](double, double) { return 0.0; }) {
  const auto truth = [](const Decimal50& a, const Decimal50& b) { return Decimal50(Formula{}(a, b)); };
  return {name, in_formats(formula), truth, bound, folds, first, second};
}

/// The forms for the full range that no table has.
std::vector<Bounded> bounded_forms() {
  const auto gloss = [](auto g, auto) {
    using T = decltype(g);
    return decode_clamped_gloss(g, integer<T>(10), integer<T>(1));
  };
  return {
      bounded(
          "half angle", [](auto y, auto k) { return half_angle_power(y, k); },
          {.functions = 1, .operations_per_fold = 1, .functions_per_fold = 1},
          {0, 1e-4, 0.01, 0.3, 1, 1.5, 2}, powers,
          [](double y, double k) { return k / 2 * std::log1p(-y / 2); }),
      bounded(
          "gaussian", [](auto c, auto a) { return gaussian_lobe_base_two_of_dot(c, a); },
          {.functions = 1, .operations_per_fold = 2}, cosines, powers,
          [](double c, double a) { return a * (std::clamp(c, 0.0, 1.0) - 1) * std::log(2.0); }),
      bounded("gloss", gloss, {.operations = 1, .functions = 2, .operations_per_fold = 1}, cosines, {0},
              [](double g, double) { return 10 * std::clamp(g, 0.0, 1.0) * std::log(2.0); }),
      // expm1 and two exp; their two products, the quotients by it and by 2 pi, and pi itself. In the
      // exponent k y is rounded
      bounded(
          "von Mises-Fisher", [](auto y, auto k) { return von_mises_fisher_of_any_concentration(y, k); },
          {.operations = 5, .functions = 3, .operations_per_fold = 1}, from_peak, concentrations,
          [](double y, double k) { return k * y; }),
      // (1 + |g|)/(4 pi): 3 with pi's own. rest/b': 1, 4 and 1, as b' sums a square, 2 x 1 + 1, and a
      // product, 2. 64/sqrt(b'): 4/2 + 1 and 1. And two products
      bounded("Henyey-Greenstein", [](auto y, auto g) { return henyey_greenstein_from_both_sides(y, g); },
              {.operations = 15}, from_peak,
              {-1 + 0x1p-11, -0.9999, -0.76, -1e-3, 0, 0.25, 0.97, 0.9999, 1 - 0x1p-11}),
      // a + 2, the sum, the quotient; a + 4, pi, the quotient; the product; and exp2
      bounded(
          "normalisation", [](auto a, auto) { return blinn_phong_brdf_constant_by_parts(a); },
          {.operations = 7, .functions = 1}, concentrations),
      // a + 2, the difference, pi, the product, the quotient; and exp2, at most as large as the difference
      bounded(
          "norm-blinn-phong", [](auto a, auto) { return BlinnPhongLobe::constant(a); },
          {.operations = 5, .functions = 1}, concentrations),
      // By the series up to |x| = 1/2: r = x/(2 + x) has 2, its square 5, the sum 1 and little more, the
      // product with it 9 at most, of which the difference, 3/5 of x and more, keeps 2/3, 6, and its own;
      // then the product with r: 10. Beyond, log1p is at most 4.3 times the difference, so its 2 count as
      // 8.6, and the difference: 10. One for the rest.
      bounded("remainder", [](auto x, auto) { return log1p_remainder(x); }, {.operations = 11},
              {-1 + 0x1p-11, -0.9, -0.5, -0.3, -1e-3, -1e-7, 0, 1e-4, 0.4, 0.5, 0.6, 1, 2, 10, 1000, 6e4})};
}

TEST(FullRange, BoundsAreKept) {
  for (const Bounded& form : bounded_forms()) {
    for (std::size_t f = 0; f < stress_formats.size(); ++f) {
      const BinaryFormat& format = stress_formats[f];
      for (const double a : with_neighbours(format, form.first, form.first.front(), form.first.back())) {
        for (const double b : with_neighbours(format, form.second, form.second.front(), form.second.back())) {
          if (std::string_view(form.name) == "half angle" && 0 < a && a < 2 * least_normal(format)) continue;
          const double folds = std::min(std::abs(form.folds(a, b)), 1500.0);
          EXPECT_LE(ulps_off(form.evaluate[f](a, b), form.truth(Decimal50(a), Decimal50(b)), format),
                    bound_ulps(form.bound, format, folds))
              << form.name << " in " << format.name << " of " << a << ", " << b;
        }
      }
    }
  }
}

/// The regime that has the form.
Regime regime_with(std::string_view form) {
  for (const Regime& regime : stress_regimes()) {
    for (const StressedForm& f : regime.forms) {
      if (f.name == form) return regime;
    }
  }
  throw std::logic_error("no such form");
}

/// What a form makes of these inputs in a format.
FormTrial at(Regime regime, std::string_view form, const BinaryFormat& format,
             const std::vector<Input>& inputs) {
  regime.inputs = [&](const BinaryFormat&, std::size_t) { return inputs; };
  for (const FormTrial& trial : try_forms(regime, 0)) {
    if (trial.form == form && trial.format.name == format.name) return trial;
  }
  throw std::logic_error("no such trial");
}

TEST(Stress, ZeroToThePowerOfZero) {
  EXPECT_EQ(power_lobe(0.0, 0.0), 1);
  EXPECT_TRUE(std::isnan(power_by_exp2(0.0, 0.0)));
  EXPECT_EQ(power_by_exp2_of_dot(0.0, 0.0), 1);
  EXPECT_EQ(power_by_exp2_of_dot(0.0, 5.0), 0);
  EXPECT_EQ(power_by_exp2_of_dot(-0.5, 5.0), 0);
  EXPECT_EQ(power_by_exp2_of_dot(1.5, 5.0), 1);
  const Regime regime = regime_with("power_by_exp2");
  const std::vector<Input> inputs{{0, 1}, {0, 0}, {-0.5, 1}, {1.0009765625, 1000}};
  for (const BinaryFormat& format : stress_formats) {
    const FormTrial naive = at(regime, "power_by_exp2", format, inputs);
    EXPECT_EQ(naive.nan, 2) << "0^0 and a negative cosine";
    EXPECT_EQ(naive.above, 1);
    EXPECT_EQ(naive.first_bad, "c = 0x0p+0, k = 0x0p+0");
    EXPECT_TRUE(at(regime, "power_by_exp2_of_dot", format, inputs).is_kept());
  }
  const FormTrial weight = at(regime_with("schlick_weight"), "schlick_weight", float_format,
                              {{1.0009765625, 0}, {0.5, 0}, {-0.5, 0}});
  EXPECT_EQ(weight.negative, 1);
  EXPECT_EQ(weight.above, 1);
  EXPECT_EQ(at(regime, "power_lobe", half_format, {{1.25, 1000}}).infinite, 1);
}

// Every stated bound is kept; each form breaks one of a hundredth of an ulp, which is reported; and the
// formula before it, in its place, breaks its bound.
TEST(Stress, EveryStatedBoundIsKeptAndCanFail) {
  int kept = 0;
  for (const Regime& regime : stress_regimes()) {
    for (std::size_t i = 0; i < regime.forms.size(); ++i) {
      if (!regime.forms[i].bound) continue;
      Regime alone = regime;
      alone.forms = {regime.forms[i]};
      for (const FormTrial& trial : try_forms(alone, 64)) {
        EXPECT_TRUE(trial.is_kept()) << trial.form << " in " << trial.format.name << " at "
                                     << trial.first_broken << trial.first_bad;
        ++kept;
      }
      alone.forms[0].bound = Roundings{.operations = 0.01};
      const auto strict = try_forms(alone, 16);
      EXPECT_TRUE(std::ranges::none_of(strict, &FormTrial::is_kept)) << regime.forms[i].name;
      EXPECT_EQ(std::ranges::count(broken_lines(strict), '\n'), 3);
      alone.forms = {StressedForm{"mutant", "", regime.forms[i - 1].evaluate, regime.forms[i].bound}};
      EXPECT_FALSE(std::ranges::all_of(try_forms(alone, 256), &FormTrial::is_kept)) << regime.forms[i].name;
    }
  }
  EXPECT_EQ(kept, 15);
}

TEST(Stress, BoundsAreCountsOfRoundings) {
  const Roundings roundings{
      .operations = 1, .functions = 1, .operations_per_fold = 1, .functions_per_fold = 1};
  EXPECT_EQ(bound_text(roundings, half_format), "2 + 2 L");
  EXPECT_EQ(bound_text(roundings, double_format), "3 + 3 L");
  EXPECT_EQ(bound_text({.operations = 4}, float_format), "4");
  EXPECT_NEAR(bound_ulps(roundings, double_format, 10), 33, 1e-9);
  EXPECT_GT(bound_ulps(roundings, half_format, 100), 202) << "many roundings multiply";
}

TEST(Stress, ATableSaysWhatWasBroken) {
  FormTrial trial;
  trial.form = "form";
  trial.bound = Roundings{.operations = 1};
  const auto cell = [&](std::size_t column) {
    return text(forms_stress_table({trial}).rows[0][column], Precision::report);
  };
  EXPECT_EQ(cell(10), "yes");
  EXPECT_EQ(broken_lines({trial}), "");
  trial.first_broken = "c = 0x1p+0";
  EXPECT_EQ(cell(10), "no");
  EXPECT_EQ(broken_lines({trial}),
            "shadefit: form in double breaks its bound of 1 ulps or has no usable value at c = 0x1p+0\n");
  // For a naive form the table has a power of two, and nothing if rounding decides.
  trial.bound.reset();
  for (const auto& [ulps, told] : {std::pair{5.0, ""}, {17.0, "2^5"}, {32.0, "2^5"}}) {
    trial.worst_ulps = ulps;
    EXPECT_EQ(cell(7), told);
  }
}

}  // namespace
}  // namespace shadefit
