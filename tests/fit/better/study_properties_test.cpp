#include "fit/better/study_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "approx/scalar.hpp"
#include "fit/better/better_study.hpp"
#include "fit/better/prove_contenders.hpp"

namespace shadefit {
namespace {

/// x^2 by a + b x on [0, 1], or by another form. Its largest error is about 1/4.
std::string properties_for(const std::vector<std::string>& printed, const std::string& form = "a + b x") {
  const ReadStudy study = read_study({.target = "x^2", .form = form, .over = {{"x", "0", "1"}}});
  std::vector<double> values;
  for (const std::string& text : printed) values.push_back(constant<double>(text));
  return to_text(properties_of(study, sample_curve(study, values), printed));
}

TEST(StudyProperties, AnEndMayBeExactToItsDigits) {
  EXPECT_EQ(properties_for({"0", "1"}), "exact at x = 0, exact at x = 1, rises, not negative, at most 1");
  // At x = 1 the sum is 0.9997; half units of its two constants allow 0.0005 + 0.00005.
  EXPECT_EQ(properties_for({"0.0007", "0.999"}),
            "exact at x = 1 to its digits, rises, not negative, at most 1");
  EXPECT_EQ(properties_for({"0.0007", "0.9990"}), "rises, not negative, at most 1") << "a digit more";
  EXPECT_EQ(properties_for({"0.0007", "0.998"}), "rises, not negative, at most 1") << "beyond the digits";
  // Half a unit allows 0.05 at x = 0, but an error of 0.04 of 0.29 is there by chance.
  EXPECT_EQ(properties_for({"-0.04", "1.0"}), "rises, at most 1");
  EXPECT_EQ(properties_for({"-0.002", "1.0"}), "exact at x = 1 to its digits, rises, at most 1");
}

/// Constants that do not move the form at an end do not make it exact there.
TEST(StudyProperties, OnlyDigitsThatMoveTheEndCount) {
  EXPECT_EQ(properties_for({"1.0"}, "a x + 0.002 (1 - x)"), "exact at x = 1, rises, not negative, at most 1");
}

TEST(StudyProperties, AnEdgeMayBeExactToItsDigits) {
  const ReadStudy study = read_study(
      {.target = "x + y - x^2 y^2", .form = "a x + y - b x y", .over = {{"x", "0", "1"}, {"y", "0", "1"}}});
  const std::vector<std::string> printed{"1.0001", "0.300"};
  EXPECT_EQ(to_text(properties_of(study, sample_curve(study, {1.0001, 0.3}), printed)),
            "exact at x = 0, not negative")
      << "1.0001 has one more digit than half a unit allows";
  EXPECT_EQ(to_text(properties_of(study, sample_curve(study, {1.0001, 0.3}), {"1.000", "0.300"})),
            "exact at x = 0, exact at y = 0 to its digits, not negative");
}

TEST(StudyProperties, SeveralVariablesRiseOrFallInEach) {
  const ReadStudy study = read_study(
      {.target = "x - y^2", .form = "a x - b y + 0.1", .over = {{"x", "0", "1"}, {"y", "0", "1"}}});
  SampledCurve curve = sample_curve(study, {0.8, 1.2});
  EXPECT_EQ(to_text(properties_of(study, curve)), "rises in x, falls in y, at most 1");
  // A value that leaves its line in x rises or falls in neither.
  for (std::size_t i = 0; i < curve.places.size(); ++i)
    if (curve.places[i] == SampledPlace{0.5, 0.5}) curve.form[i] += 0.02;
  EXPECT_EQ(to_text(properties_of(study, curve)), "falls in y, at most 1");
  // Scattered places are on no lines. Those of the edges stay.
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    const auto place = std::span(curve.places[i]).first(2);
    if (std::any_of(place.begin(), place.end(), [](double x) { return x == 0 || x == 1; })) continue;
    for (double& x : place) x += 1e-6 * static_cast<double>(i + 1);
  }
  EXPECT_EQ(to_text(properties_of(study, curve)), "at most 1");
}

/// A better set is exact where the published one is exact to its digits, and both are proven.
TEST(StudyProperties, ABetterSetIsExactWhereThePublishedOneIsToItsDigits) {
  StudyFile file;
  file.id = "arc";
  file.study = {.target = "atan(x)", .form = "", .over = {{"x", "0", "1"}}};
  file.forms = {{"free", "x (s + (a + b x x) x x)"}};
  file.published = {{.form = "free",
                     .values = {{"s", "1.0000"}, {"a", "-0.301895"}, {"b", "0.0872929"}},
                     .source = OthersText("Doe 2020")},
                    {.form = "free",
                     .values = {{"s", "1.0"}, {"a", "-0.30"}, {"b", "0.08"}},
                     .source = OthersText("Roe 2021")}};
  StudyComparison comparison = compare_study(file, file.study);
  const StudyContender& published = *first_published(comparison);
  EXPECT_EQ(
      text_with_proofs(published.properties),
      "exact at x = 0 (proven), exact at x = 1 to its digits (proven), rises (proven), not negative (proven), "
      "at most 1 (proven)");
  const StudyContender* best = better_at_the_same_cost(comparison, published);
  ASSERT_NE(best, nullptr);
  EXPECT_EQ(best->origin, "minimax, exact at x = 0, exact at x = 1, form rises");
  EXPECT_TRUE(lost_properties(published.properties, best->properties).empty());
  const StudyContender* least = least_error_at_the_same_cost(comparison, published);
  EXPECT_EQ(to_text(lost_properties(published.properties, least->properties)),
            "exact at x = 1 to its digits");
  // Each published set is proven, and what is better than each.
  prove_contenders(comparison);
  for (const StudyContender& contender : comparison.contenders) {
    const bool is_wanted = contender.published != nullptr || &contender == best || &contender == least;
    EXPECT_EQ(contender.proof.has_value(), is_wanted) << contender.origin.unescaped();
  }
}

/// A form may have properties of the target that the published set lacks.
TEST(StudyProperties, ABetterSetMayHaveAllOfTheTarget) {
  StudyFile file;
  file.id = "quarter-wave";
  file.study = {.target = "sin(pi x/2)", .form = "", .over = {{"x", "0", "1"}}};
  file.forms = {{"free", "a + x (b + d x)"}, {"ends", "x (a + (1 - a) x)"}};
  file.published = {{.form = "free",
                     .values = {{"a", "-0.05"}, {"b", "1.7"}, {"d", "-0.7"}},
                     .source = OthersText("Doe 2020")}};
  const StudyComparison comparison = compare_study(file, file.study);
  const StudyContender& published = *first_published(comparison);
  EXPECT_EQ(to_text(comparison.properties), "exact at x = 0, exact at x = 1, rises, not negative, at most 1");
  EXPECT_EQ(better_at_the_same_cost(comparison, published)->form, "free");
  const StudyContender* all = better_with_all_properties(comparison, published);
  ASSERT_NE(all, nullptr);
  EXPECT_EQ(all->form, "ends");
  EXPECT_TRUE(lost_properties(comparison.properties, all->properties).empty());
  file.forms.pop_back();
  const StudyComparison without = compare_study(file, file.study);
  EXPECT_EQ(better_with_all_properties(without, *first_published(without)), nullptr);
}

}  // namespace
}  // namespace shadefit
