#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/better/results.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/verdicts/family_file.hpp"
#include "fit/verdicts/fresnel_chain.hpp"
#include "reports/code/shader_code.hpp"

/// The forms of the catalogue against each other.
namespace shadefit {
namespace {

TargetComparison compare(std::string_view id, const Surface& surface, const std::string& exponent = "",
                         bool is_proven = true) {
  const Family& family = *find_family(id);
  StudyFile file = family_file(family, nullptr, surface);
  take_rivals(file, family, nullptr, surface);
  if (family.has_exponent()) file.given.front().second = {exponent};
  StudyComparison comparison =
      compare_study(file, combinations(file.study, file.given).front(), keep_going, keep_going, Judged::no);
  if (is_proven) prove_contenders(comparison);
  return {"", std::move(file), std::move(comparison)};
}

const StudyComparison& schlick_forms() {
  static const TargetComparison target = compare("fresnel-quadratic", {});
  return target.comparison;
}

const StudyComparison& glass_forms() {
  static const TargetComparison target = compare("fresnel-quadratic", exact_surface(1.5));
  return target.comparison;
}

/// A published curve by its printed number or source, a fit by its form and objective.
const StudyContender& find(const StudyComparison& comparison, std::string_view form, std::string_view which) {
  for (const StudyContender& contender : comparison.contenders) {
    if (contender.form != form) continue;
    const bool is_printed =
        std::ranges::find(contender.printed, std::string(which)) != contender.printed.end();
    if (is_printed || (contender.published == nullptr && contender.origin.unescaped() == which) ||
        (form == "schlick"))
      return contender;
  }
  throw std::logic_error("no curve " + std::string(form) + " " + std::string(which));
}

// For every published Fresnel constant there is a form with a smaller proven error at no more operations.
TEST(Rivals, EveryPublishedFresnelConstantIsBeatenAtItsCost) {
  int published = 0;
  for (const StudyContender& contender : schlick_forms().contenders) {
    if (contender.published == nullptr) continue;
    ++published;
    const StudyContender* best = better_at_the_same_cost(schlick_forms(), contender);
    ASSERT_TRUE(best != nullptr && best->proof && contender.proof) << contender.formula;
    EXPECT_LT(best->proof->upper, contender.proof->lower);
    EXPECT_LE(best->operations.total(), contender.operations.total());
  }
  EXPECT_EQ(published, 3);
  EXPECT_EQ(schlick_forms().contenders.size(), 3U + 2 * 7) << "and two fits of each form";
  EXPECT_TRUE(schlick_forms().left_out.empty());
}

// The published digits are the ones that are compared.
TEST(Rivals, HoldsUpTheNumbersAsPrinted) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(find(schlick_forms(), "fresnel-one-term", "8.656170").values, std::vector<double>{8.656170});
  EXPECT_EQ(find(schlick_forms(), "fresnel-quadratic", "-5.55473").printed, (Texts{"-5.55473", "-6.98316"}));
}

// At an exponent a shader computes what `emit` writes: (k + x)/ln 2 is a number, and so is x k/2.
TEST(Rivals, CountsWhatIsEmitted) {
  const auto operations = [](const StudyComparison& comparison, std::string_view form,
                             std::string_view which) {
    return to_text(find(comparison, form, which).operations);
  };
  EXPECT_EQ(operations(schlick_forms(), "fresnel-one-term", "8.35"), "MUL, EXP2");
  EXPECT_EQ(operations(schlick_forms(), "fresnel-quadratic", "-5.55473"), "MAD, MUL, EXP2");
  EXPECT_EQ(operations(schlick_forms(), "fresnel-cubic", "minimax"), "2 MAD, MUL, EXP2");
  EXPECT_EQ(operations(glass_forms(), "schlick", ""), "ADD, 3 MUL");
  for (const char* exponent : {"5", "37.5"}) {
    const TargetComparison lobe = compare("sg-offset", {}, exponent);
    for (const StudyContender& contender : lobe.comparison.contenders) {
      const Symbolic emitted = as_generated(contender.code, ShaderPrecision::float32);
      EXPECT_EQ(contender.operations, count_operations(emitted)) << to_text(emitted);
    }
    EXPECT_EQ(operations(lobe.comparison, "sg-offset", "0.775"), "ADD, MUL, EXP2");
    EXPECT_EQ(operations(lobe.comparison, "sg-scaled", "minimax"), "ADD, 2 MUL, EXP2");
    EXPECT_EQ(operations(lobe.comparison, "phong-blinn", "4.2"), "ADD, 2 MUL, LOG2, EXP2");
  }
}

// |error| in 50 digits at places that nothing chose is never above the largest error, which is reached at the
// place that is named.
TEST(Rivals, NoPlaceIsAboveTheLargestError) {
  for (const StudyContender& contender : schlick_forms().contenders) {
    const auto error = [&](const Decimal50& c) {
      const Decimal50 target = pow(1 - c, 5);
      const auto p = [&](std::size_t i) {
        return contender.published != nullptr ? Decimal50(contender.printed[i])
                                              : Decimal50(contender.values[i]);
      };
      if (contender.form == "fresnel-one-term") return Decimal50(exp(-p(0) * c * log(Decimal50(2))) - target);
      if (contender.form == "fresnel-fourth") return Decimal50(p(0) * pow(1 - c, 4) - target);
      if (contender.form == "fresnel-square")
        return Decimal50(pow(1 - c, 2) * (1 + (p(0) * c + p(1)) * c) - target);
      if (contender.form == "fresnel-rational") return Decimal50(pow(1 - c, 4) / (1 + p(0) * c) - target);
      Decimal50 exponent = 0;  // Horner's scheme, whatever the degree
      for (std::size_t i = 0; i < contender.values.size(); ++i) exponent = (exponent + p(i)) * c;
      return Decimal50(exp(exponent * log(Decimal50(2))) - target);
    };
    const std::string what = contender.formula + " " + contender.origin.unescaped();
    const double largest = contender.max_error.magnitude;
    const double bound = contender.proof ? contender.proof->upper : largest * (1 + 1e-9);
    for (int i = 0; i <= 1000; ++i) EXPECT_LE(abs(error(Decimal50(i) / 1000)), bound) << what << " at " << i;
    EXPECT_NEAR(abs(error(contender.max_error.at.front())).convert_to<double>() / largest, 1, 1e-9) << what;
  }
}

// On glass the truth is the target and Schlick's formula one of the published curves: off by 0.0357, as the
// chain of the report says by a search.
TEST(Rivals, SchlickIsAContenderOnASurface) {
  const StudyContender& schlick = find(glass_forms(), "schlick", "");
  const ReflectanceError sampled = reflectance_error(exact_surface(1.5), "schlick_weight(c)");
  EXPECT_NEAR(schlick.max_error.magnitude / sampled.absolute.magnitude, 1, 1e-9);
  ASSERT_TRUE(schlick.proof.has_value());
  EXPECT_NEAR(schlick.proof->upper, 0.0357, 1e-4);
  const StudyContender& one_term = find(glass_forms(), "fresnel-one-term", "8.35");
  const auto place = static_cast<std::size_t>(&schlick - glass_forms().contenders.data());
  EXPECT_NE(std::ranges::find(one_term.beats, place), one_term.beats.end());
}

// The rms of Schlick's formula by midpoints: their error falls as 1/n^2.
TEST(Rivals, TheRmsOfSchlickIsThatOfASum) {
  for (const Surface& surface : {exact_surface(1.5), exact_surface(0.43, 2.455), exact_surface(0.75)}) {
    constexpr int n = 200000;
    const double f0 = normal_reflectance(surface);
    const auto error_at = [&](double c) {
      return schlick_reflectance(f0, schlick_weight(c)) - schlick_reflectance(f0, target_weight(surface, c));
    };
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += std::pow(error_at((i + 0.5) / n), 2);
    const TargetComparison target = compare("fresnel-one-term", surface);
    const StudyContender& schlick = find(target.comparison, "schlick", "");
    EXPECT_NEAR(schlick.rms_error / std::sqrt(sum / n), 1, 1e-6) << surface.ior;
    EXPECT_TRUE(schlick.proof) << surface.ior << ", from inside with a kink";
    EXPECT_NEAR(schlick.max_error.magnitude / std::abs(error_at(schlick.max_error.at.front())), 1, 1e-9);
  }
}

TEST(Rivals, ALobeMeetsEveryFormOfIt) {
  const TargetComparison lobe = compare("sg-offset", {}, "5");
  for (const auto& [form, printed] :
       {std::pair{"sg-offset", "0.775"}, {"sg-offset", "0.75"}, {"phong-blinn", "4"}, {"phong-blinn", "4.2"}})
    EXPECT_NE(find(lobe.comparison, form, printed).published, nullptr);
  // c -> 1 - c makes the lobe of exponent 5 Schlick's weight, and a Gaussian of it exp2(-A c).
  const double gaussian = find(lobe.comparison, "sg-offset", "minimax").max_error.magnitude,
               one_term = find(schlick_forms(), "fresnel-one-term", "minimax").max_error.magnitude;
  EXPECT_NEAR(gaussian / one_term, 1, 1e-9);
}

// A sharp lobe is compared where it is: c^k is 0 but for the last 1e-6 of the cosines.
TEST(Rivals, ASharpLobeIsSeen) {
  const TargetComparison lobe = compare("sg-offset", {}, "1e6", false);
  for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
    const Fit fit = find_family("sg-offset")->fit(1e6, {.norm = norm});
    const StudyContender& contender =
        find(lobe.comparison, "sg-offset", norm == Norm::minimax ? "minimax" : "least squares");
    EXPECT_NEAR(contender.max_error.magnitude / fit.max_abs_error.magnitude, 1, 1e-9);
    EXPECT_NEAR(contender.max_error.at.front(), fit.max_abs_error.at.cos_theta, 1e-12);
    EXPECT_NEAR(contender.effect.absolute.magnitude / fit.max_abs_error.magnitude, 1, 1e-9);
    EXPECT_EQ(to_text(contender.properties),
              "exact at c = 0, exact at c = 1, rises, not negative, at most 1");
  }
}

}  // namespace
}  // namespace shadefit
