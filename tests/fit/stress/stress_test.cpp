#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "approx/full_range.hpp"
#include "fit/stress/regime.hpp"
#include "fit/stress/starts.hpp"
#include "reports/rows/stress_tables.hpp"

namespace shadefit {
namespace {

// The first numbers of the published generator for these seeds.
TEST(Sequence, IsSplitMix64) {
  Sequence zero(0), other(1234567);
  EXPECT_EQ(zero.next(), 0xE220A8397B1DCDAFu);
  EXPECT_EQ(other.next(), 6457827717110365317u);
  EXPECT_EQ(other.next(), 3203168211198807973u);
}

TEST(Sequence, StaysInItsRange) {
  Sequence sequence(5);
  for (int i = 0; i < 1000; ++i) {
    const double x = sequence.between(2, 3), y = log_uniform(sequence, 1e-3, 1e9);
    EXPECT_TRUE(2 <= x && x < 3);
    EXPECT_TRUE(1e-3 <= y && y <= 1e9);
  }
}

TEST(Numbers, AreOfTheirFormatWithTheirNeighbours) {
  EXPECT_EQ(with_neighbours(half_format, {1}, 0, 2, 1), (std::vector{1 - 0x1p-11, 1.0, 1 + 0x1p-10}));
  EXPECT_EQ(with_neighbours(float_format, {0}, -1, 1, 1), (std::vector{-0x1p-149, 0.0, 0x1p-149}));
  EXPECT_EQ(with_neighbours(double_format, {0x1p-1022}, 0, 1, 1),
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

/// The one regime of that topic that has the form.
Regime regime_with(const std::vector<Regime>& regimes, std::string_view form) {
  for (const Regime& regime : regimes) {
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

TEST(Stress, SinhOverflowsAt710) {
  const Regime regime = regime_with(von_mises_fisher_regimes(), "von_mises_fisher");
  const std::vector<Input> inputs{{0, 709}, {0, 710}, {0, 711}};
  const FormTrial naive = at(regime, "von_mises_fisher", double_format, inputs);
  EXPECT_EQ(naive.nan + naive.infinite, 2);
  EXPECT_EQ(naive.first_bad, "y = 0x0p+0, k = 0x1.63p+9");
  const FormTrial robust = at(regime, "von_mises_fisher_of_any_concentration", double_format, inputs);
  EXPECT_EQ(robust.nan + robust.infinite, 0);
  EXPECT_TRUE(robust.is_kept());
}

TEST(Stress, ZeroToThePowerOfZero) {
  EXPECT_EQ(power_lobe(0.0, 0.0), 1);
  EXPECT_TRUE(std::isnan(power_by_exp2(0.0, 0.0)));
  EXPECT_EQ(power_by_exp2_of_dot(0.0, 0.0), 1);
  EXPECT_EQ(power_by_exp2_of_dot(0.0, 5.0), 0);
  EXPECT_EQ(power_by_exp2_of_dot(-0.5, 5.0), 0);
  EXPECT_EQ(power_by_exp2_of_dot(1.5, 5.0), 1);
  const Regime regime = regime_with(dot_product_regimes(), "power_by_exp2");
  const std::vector<Input> inputs{{0, 1}, {0, 0}, {-0.5, 1}, {1.0009765625, 1000}};
  for (const BinaryFormat& format : stress_formats) {
    const FormTrial naive = at(regime, "power_by_exp2", format, inputs);
    EXPECT_EQ(naive.nan, 2) << "0^0 and a negative cosine";
    EXPECT_EQ(naive.above, 1);
    EXPECT_EQ(naive.first_bad, "c = 0x0p+0, k = 0x0p+0");
    EXPECT_TRUE(at(regime, "power_by_exp2_of_dot", format, inputs).is_kept());
  }
}

TEST(Stress, NegativeAndInfiniteResultsAreCounted) {
  const Regime schlick = regime_with(dot_product_regimes(), "schlick_weight");
  const FormTrial weight =
      at(schlick, "schlick_weight", float_format, {{1.0009765625, 0}, {0.5, 0}, {-0.5, 0}});
  EXPECT_EQ(weight.negative, 1);
  EXPECT_EQ(weight.above, 1);
  const Regime constant = regime_with(normalisation_regimes(), "norm-blinn-phong-brdf");
  const FormTrial printed = at(constant, "norm-blinn-phong-brdf", half_format, {{2048, 0}, {8, 0}});
  EXPECT_EQ(printed.nan + printed.infinite, 1) << "(a+2)(a+4) overflows in half";
}

/// Every form that states a bound, with its regime.
template <class Visit>
void visit_robust(const Visit& visit) {
  for (const auto regimes : {lobe_regimes, dot_product_regimes, von_mises_fisher_regimes, phase_regimes,
                             normalisation_regimes, gloss_regimes, remainder_regimes}) {
    for (const Regime& regime : regimes()) {
      for (std::size_t i = 0; i < regime.forms.size(); ++i) {
        if (regime.forms[i].bound) visit(regime, i);
      }
    }
  }
}

TEST(Stress, EveryStatedBoundIsKept) {
  int kept = 0;
  visit_robust([&](Regime regime, std::size_t i) {
    regime.forms = {regime.forms[i]};
    for (const FormTrial& trial : try_forms(regime, 64)) {
      EXPECT_TRUE(trial.is_kept()) << trial.form << " in " << trial.format.name << " at "
                                   << trial.first_broken << trial.first_bad;
      ++kept;
    }
  });
  EXPECT_EQ(kept, 39);
}

// Each form in each format breaks a bound of a hundredth of an ulp, and this is reported.
TEST(Stress, EveryStatedBoundCanFail) {
  visit_robust([](Regime regime, std::size_t i) {
    regime.forms = {regime.forms[i]};
    regime.forms[0].bound = Roundings{.operations = 0.01};
    const auto trials = try_forms(regime, 16);
    for (const FormTrial& trial : trials) {
      EXPECT_FALSE(trial.is_kept()) << trial.form << " in " << trial.format.name;
      EXPECT_FALSE(trial.first_broken.empty());
    }
    EXPECT_EQ(std::ranges::count(broken_lines(trials, {}), '\n'), 3);
  });
}

// Each formula instead of its robust form: the earlier one breaks the bound of its successor.
TEST(Stress, TheNaiveFormBreaksTheBoundOfTheRobustOne) {
  visit_robust([](Regime regime, std::size_t i) {
    if (i == 0) return;  // the printed formula is the robust one
    regime.forms = {StressedForm{"mutant", "", regime.forms[i - 1].evaluate, regime.forms[i].bound}};
    const auto trials = try_forms(regime, 256);
    EXPECT_TRUE(std::any_of(trials.begin(), trials.end(), [](const FormTrial& t) { return !t.is_kept(); }))
        << regime.topic << " " << i;
  });
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
  trial.topic = "lobe";
  trial.form = "form";
  trial.bound = Roundings{.operations = 1};
  trial.inputs = 3;
  trial.worst_ulps = 5;
  const auto kept = [&] { return std::get<std::string>(forms_stress_table({trial}).rows[0][10]); };
  EXPECT_EQ(kept(), "yes");
  EXPECT_EQ(broken_lines({trial}, {}), "");
  trial.first_broken = "c = 0x1p+0";
  trial.worst_share = 5;
  EXPECT_EQ(kept(), "no");
  EXPECT_EQ(broken_lines({trial}, {}),
            "shadefit: form in double breaks its bound of 1 ulps at c = 0x1p+0: up to 5 times the bound\n");
  // For a naive form the table has a power of two, and nothing if rounding decides.
  trial.bound.reset();
  EXPECT_EQ(text(forms_stress_table({trial}).rows[0][7], Precision::report), "");
  trial.worst_ulps = 17;
  EXPECT_EQ(text(forms_stress_table({trial}).rows[0][7], Precision::report), "2^5");
  trial.worst_ulps = 32;
  EXPECT_EQ(text(forms_stress_table({trial}).rows[0][7], Precision::report), "2^5");
}

TEST(Stress, AFitThatIsWrongIsSaid) {
  StartsTrial trial;
  trial.family = "sg-offset";
  trial.status = Status::converged;
  trial.starts = 30;
  trial.fits = trial.reached = 10;
  trial.claimed = trial.digits = 14;
  EXPECT_TRUE(trial.is_right());
  StartsTrial elsewhere = trial, returned = trial, worse = trial;
  elsewhere.elsewhere = 1;
  returned.returned = 1;
  worse.digits = 13;
  for (const auto& wrong : {elsewhere, returned, worse}) {
    EXPECT_FALSE(wrong.is_right());
    EXPECT_NE(broken_lines({}, {trial, wrong}), "");
  }
}

TEST(Stress, FitsReachOneOptimumOrSayThatTheyFailed) {
  const auto trials = try_starts(66);
  std::set<std::string_view> families;
  for (const StartsTrial& trial : trials) {
    families.insert(trial.family);
    EXPECT_TRUE(trial.is_right()) << trial.family << " " << trial.exponent.value_or(0) << " "
                                  << to_text(trial.domain);
    EXPECT_EQ(trial.fits, trial.reached + trial.failed);
  }
  EXPECT_GE(families.size(), 5U);
}

}  // namespace
}  // namespace shadefit
