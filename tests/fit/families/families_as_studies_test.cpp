#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "approx/records/optical_constants.hpp"
#include "fit/fit.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "tests/accuracy.hpp"

// The same fits by the engine of families and by that of studies, from formulas of approx/ by their names.
namespace shadefit {
namespace {

using testing::is_close;

/// A family in the language. A lobe has the variable t = k (c - 1), in which all lobes are equally wide, with
/// y = 1 - c = -t/k; its residual does not cancel.
struct InWords {
  const char* family;
  const char* form;
  const char* residual = "";
};

const std::vector<InWords> lobes{
    {"sg-offset", "gaussian_lobe_near_peak(y, k, x)",
     "lobe_error(gaussian_lobe_near_peak(y, k, 0), -(x y), expm1(lobe_log_ratio(c, y, k)))"},
    {"sg-scaled", "A gaussian_lobe_near_peak(y, k, x)",
     "scaled_lobe_error(gaussian_lobe_near_peak(y, k, 0), A, -(x y), expm1(lobe_log_ratio(c, y, k)))"},
    {"phong-blinn", "blinn_lobe(y, k, x)",
     "lobe_error(half_angle_power(y, 4 k), (x - 4) k log_half_cosine(y, log1p_remainder(-(y/2))), "
     "expm1(phong_blinn_log_ratio(lobe_log_ratio(c, y, k), log1p_remainder(-(y/2)), k)))"}};

const std::vector<InWords> fresnel_forms{{"fresnel-one-term", "fresnel_one_term(c, A)"},
                                         {"fresnel-quadratic", "fresnel_quadratic(c, a, b)"},
                                         {"fresnel-cubic", "fresnel_cubic(c, a, b, d)"},
                                         {"fresnel-fourth", "fresnel_fourth(c, s)"},
                                         {"fresnel-square", "fresnel_square(c, a, b)"}};

std::string density_in_t(Measure measure) {
  if (measure == Measure::angle) return "1/sqrt(-t (2 + t/k))";
  return measure == Measure::cosine ? "1" : "1 + t/k";
}

/// Parts in which a lobe and the density of the angle are smooth enough for a rule.
std::vector<double> cuts_of_lobe(double lower) {
  std::vector<double> cuts{-4, -16, -64};
  while (cuts.back() > lower) cuts.push_back(8 * cuts.back());
  return cuts;
}

StudyFit fit_of_lobe(const InWords& words, double exponent, const Metric& metric) {
  const std::string k = hex_text(exponent);
  std::string density = density_in_t(metric.measure);
  if (const auto place = density.find('k'); place != std::string::npos) density.replace(place, 1, k);
  const double visible =
      metric.error == Error::relative ? -exponent * -std::expm1(-std::log(255.0) / exponent) : -exponent;
  const Study study{.target = "power_lobe_near_peak(y, k)",
                    .form = words.form,
                    .over = {{"t", hex_text(visible), "0", density}},
                    .definitions = {{"y", {}, "-t/k"}, {"c", {}, "1 + t/k"}},
                    .given = {{"k", k}},
                    .residual = words.residual,
                    .error = metric.error,
                    .cuts = cuts_of_lobe(-exponent)};
  return fit_study({.study = study, .norm = metric.norm});
}

StudyFit fit_of_form(const InWords& words, const Surface& surface, const Metric& metric) {
  const bool is_metal = surface.extinction > 0;
  const std::string f0 = !surface.is_named() ? "0.04"
                         : is_metal          ? "conductor_reflectance_at_normal(n, k)"
                                             : "reflectance_at_normal(n)";
  const std::string target = !surface.is_exact() ? "schlick_weight(c)"
                             : is_metal          ? "weight_of_reflectance(conductor_reflectance(c, n, k), f0)"
                                                 : "weight_of_reflectance(dielectric_reflectance(c, n), f0)";
  const Study study{.target = target,
                    .form = words.form,
                    .over = {{"c", "0", "1", density_of(std::string(name(metric.measure)), "c")}},
                    .definitions = {{"f0", {}, f0}},
                    .given = {{"n", hex_text(surface.ior)}, {"k", hex_text(surface.extinction)}},
                    .weight = metric.error == Error::relative
                                  ? "(1 - f0)/schlick_reflectance(f0, " + target + ")"
                                  : "1 - f0"};
  return fit_study({.study = study, .norm = metric.norm});
}

void expect_same(const Fit& family, const StudyFit& study) {
  const std::string what = std::string(family.family->id) + " " + to_text(family.exponent.value_or(0)) + " " +
                           to_text(family.surface.ior) + " " + describe(family.metric) + ": " + study.why;
  ASSERT_EQ(family.status, Status::converged) << what;
  ASSERT_EQ(study.status, Status::converged) << what;
  // Both promise 14 digits of each parameter; a minimax fit 13.
  const double promised = family.metric.norm == Norm::minimax ? 1e-13 : 2e-14;
  for (std::size_t i = 0; i < study.parameters.size(); ++i)
    EXPECT_TRUE(is_close(what, Decimal50(family.parameters[i]), study.parameters[i], promised));
  EXPECT_NEAR(study.rms_error / family.rms_error, 1, 1e-9) << what;
}

TEST(FamiliesAsStudies, LobesHaveTheSameDigits) {
  for (const InWords& words : lobes) {
    const FittableFamily& family = *find_family(words.family);
    for (const double exponent : {1e-6, 1e-3, 0.5, 2.0, 5.0, 9.0, 37.5, 1000.0, 1e4, 1e6, 3e7, 1e9}) {
      for (const Measure measure : measures) {
        const Metric metric{.measure = measure};
        expect_same(family.fit(exponent, metric), fit_of_lobe(words, exponent, metric));
      }
      for (const Error error : {Error::absolute, Error::relative}) {
        const Metric metric{.norm = Norm::minimax, .error = error};
        if (exponent < 1e6) expect_same(family.fit(exponent, metric), fit_of_lobe(words, exponent, metric));
      }
    }
  }
}

TEST(FamiliesAsStudies, FresnelFormsHaveTheSameDigits) {
  const Surface gold_surface = exact_surface(constant<double>(gold.ior), constant<double>(gold.extinction));
  for (const InWords& words : fresnel_forms) {
    const FittableFamily& family = *find_family(words.family);
    for (const Surface& surface : {Surface{}, exact_surface(1.5), gold_surface}) {
      // The best cubic of gold is that of another basin for the family.
      if (surface == gold_surface && family.parameters.size() > 2) continue;
      for (const Metric& metric :
           {Metric{}, Metric{.measure = Measure::angle}, Metric{.error = Error::relative},
            Metric{.norm = Norm::minimax}, Metric{.norm = Norm::minimax, .error = Error::relative}}) {
        if (surface == gold_surface && metric.norm == Norm::minimax) continue;
        expect_same(family.fit({0, surface}, metric), fit_of_form(words, surface, metric));
      }
    }
  }
}

// A residual is held against form - target when it is read.
TEST(Residual, MustBeTheDifference) {
  Study study{.target = "x^2", .form = "a x", .over = {{"x", "0", "1"}}, .residual = "x (a - x)"};
  EXPECT_EQ(fit_study({.study = study}).parameters,
            fit_study({.study = {.target = "x^2", .form = "a x", .over = {{"x", "0", "1"}}}}).parameters);
  study.residual = "x (a - x^2)";
  try {
    read_study(study);
    FAIL() << "it is not form - target";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("but form - target is"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace shadefit
