#include "fit/catalogue_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fit/fit_study.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/study_squares/prepared_study.hpp"
#include "fit/study_squares/rules.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// A form in the language of studies. The residual of a lobe does not cancel; y is 1 - c.
struct InWords {
  std::string_view family, form, residual = "";
};

constexpr std::array in_words{
    InWords{"sg-offset", "gaussian_lobe_near_peak(y, k, x)",
            "lobe_error(gaussian_lobe_near_peak(y, k, 0), -(x y), expm1(lobe_log_ratio(c, y, k)))"},
    InWords{"sg-scaled", "A gaussian_lobe_near_peak(y, k, x)",
            "scaled_lobe_error(gaussian_lobe_near_peak(y, k, 0), A, -(x y), expm1(lobe_log_ratio(c, y, k)))"},
    InWords{"phong-blinn", "blinn_lobe(y, k, x)",
            "lobe_error(half_angle_power(y, 4 k), (x - 4) k log_half_cosine(y, log1p_remainder(-(y/2))), "
            "expm1(phong_blinn_log_ratio(lobe_log_ratio(c, y, k), log1p_remainder(-(y/2)), k)))"},
    InWords{"fresnel-one-term", "fresnel_one_term(c, A)"},
    InWords{"fresnel-quadratic", "fresnel_quadratic(c, a, b)"},
    InWords{"fresnel-cubic", "fresnel_cubic(c, a, b, d)"},
    InWords{"fresnel-quartic", "fresnel_quartic(c, a, b, d, g)"},
    InWords{"fresnel-fourth", "fresnel_fourth(c, s)"},
    InWords{"fresnel-square", "fresnel_square(c, a, b)"},
    InWords{"fresnel-rational", "fresnel_rational(c, a)"}};

const InWords& words_of(std::string_view family) {
  const auto* found = std::ranges::find(in_words, family, &InWords::family);
  if (found == in_words.end()) throw std::logic_error("no family '" + std::string(family) + "'");
  return *found;
}

/// Whether the variable of a family is t = k (c - 1): nearly all of the lobe is next to its peak.
bool is_sharp_lobe(const InWords& words, double exponent) {
  return !words.residual.empty() && exponent >= 2;
}

/// The density of a measure over t = k (c - 1).
std::string density_in_t(Measure measure, double exponent) {
  const std::string k = hex_text(exponent);
  if (measure == Measure::angle) return "1/(sqrt(-t) sqrt(2 + t/" + k + "))";
  return measure == Measure::cosine ? "1" : "1 + t/" + k;
}

/// Parts in which a lobe and the density of the angle are smooth enough for a rule.
std::vector<double> cuts_of_lobe(double lower) {
  std::vector<double> cuts{-3, -9, -24, -64};
  while (cuts.back() > lower) cuts.push_back(8 * cuts.back());
  return cuts;
}

Study sharp_lobe(double exponent, const Metric& metric, const Cosine<double>& top,
                 const Cosine<double>& bottom) {
  Study study;
  study.target = "power_lobe_near_peak(y, k)";
  study.over = {{"t", hex_text(-exponent * bottom.one_minus_cos), hex_text(-exponent * top.one_minus_cos),
                 density_in_t(metric.measure, exponent)}};
  study.definitions = {{"y", {}, "-t/k"}, {"c", {}, "1 + t/k"}};
  study.cuts = cuts_of_lobe(-exponent);
  return study;
}

/// The singularity of a blunt lobe at c = 0 draws the nodes there. A relative error is steep next to it.
Study blunt_lobe(const Metric& metric, const Cosine<double>& top, const Cosine<double>& bottom) {
  Study study;
  study.target = "power_lobe(c, k)";
  study.over = {{"c", hex_text(bottom.cos_theta), hex_text(top.cos_theta),
                 density_of(std::string(name(metric.measure)), "c")}};
  study.definitions = {{"y", {}, "1 - c"}};
  study.cuts.emplace();
  if (metric.error == Error::relative)
    for (int power = -64; power < 0; power += 4) study.cuts->push_back(std::ldexp(1.0, power));
  return study;
}

Study fresnel_form(const Surface& surface, const Metric& metric, const Cosine<double>& top,
                   const Cosine<double>& bottom) {
  Study study = fresnel_study(surface, metric.error);
  study.over = {{"c", hex_text(bottom.cos_theta), hex_text(top.cos_theta),
                 density_of(std::string(name(metric.measure)), "c")}};
  study.cuts.emplace();
  const auto joint = joint_of(surface);
  if (joint && !joint->is_kink) study.cuts->push_back(joint->cosine);
  return study;
}

}  // namespace

Study fresnel_study(const Surface& surface, Error error) {
  const bool is_metal = surface.extinction > 0;
  Study study;
  study.target = !surface.is_exact() ? "(1 - c)^5"
                 : is_metal          ? "weight_of_reflectance(conductor_reflectance(c, n, k), f0)"
                                     : "weight_of_reflectance(dielectric_reflectance(c, n), f0)";
  if (surface.is_named() || error == Error::relative) {
    const std::string given = surface.f0 ? to_text(*surface.f0) : std::string(reference_f0);
    study.definitions = {{"f0",
                          {},
                          !surface.is_named() ? given
                          : is_metal          ? "conductor_reflectance_at_normal(n, k)"
                                              : "reflectance_at_normal(n)"}};
    study.weight =
        error == Error::relative ? "(1 - f0)/schlick_reflectance(f0, " + study.target + ")" : "1 - f0";
  }
  if (surface.is_named()) study.given["n"] = to_text(surface.ior);
  if (is_metal) study.given["k"] = to_text(surface.extinction);
  return study;
}

Study study_of(std::string_view family, const Setting& setting, const Metric& metric,
               const Cosine<double>& top, const Cosine<double>& bottom) {
  const InWords& words = words_of(family);
  const double k = setting.exponent;
  const bool is_lobe = !words.residual.empty();
  Study study = !is_lobe                  ? fresnel_form(setting.surface, metric, top, bottom)
                : is_sharp_lobe(words, k) ? sharp_lobe(k, metric, top, bottom)
                                          : blunt_lobe(metric, top, bottom);
  study.form = words.form;
  study.residual = words.residual;
  study.held = metric.constraints.held;
  if (is_lobe) {
    study.given["k"] = hex_text(k);
    study.error = metric.error;
  }
  if (metric.weight.empty()) return study;
  study.weight = study.weight == "1" ? metric.weight : "(" + metric.weight + ") " + study.weight;
  return with_cuts(std::move(study));
}

double scale_of_weight(const Study& study, const std::string& weight) {
  if (weight.empty()) return 1;
  Study square = study;
  square.target = "0 " + study.over.front().variable;  // a target has a variable
  square.form = weight;
  square.weight = "1";
  square.residual.clear();
  square.held.clear();
  square.error = Error::absolute;
  const ReadStudy read = read_formulas(square);
  return rms_error(read, StudyError(read), {});
}

Objective objective_of(const Study& study, const Metric& metric) {
  if (metric.norm == Norm::minimax)
    return [read = read_study(study)](std::span<const double> parameters) {
      return largest_weighted_error(read, {parameters.begin(), parameters.end()}).magnitude;
    };
  const double scale = scale_of_weight(study, metric.weight);
  return [prepared = std::make_shared<PreparedStudy>(study), scale](std::span<const double> parameters) {
    return prepared->rms_error({parameters.begin(), parameters.end()}) / scale;
  };
}

Cosine<double> cosine_at(std::string_view family, const Setting& setting, double variable) {
  if (!is_sharp_lobe(words_of(family), setting.exponent)) return {variable, 1 - variable};
  const double one_minus_cos = -variable / setting.exponent;
  return {1 - one_minus_cos, one_minus_cos};
}

std::string in_cosines(std::string_view family, const Setting& setting, std::string sentence) {
  constexpr std::string_view before = " at t = ";
  const auto place = sentence.find(before);
  if (place == std::string::npos) return sentence;
  const std::optional<double> t = parse_number(sentence.substr(place + before.size()));
  return t ? sentence.substr(0, place) + " at c = " + to_text(cosine_at(family, setting, *t).cos_theta)
           : sentence;
}

double variable_at(std::string_view family, const Setting& setting, double cos_theta) {
  return is_sharp_lobe(words_of(family), setting.exponent) ? -setting.exponent * (1 - cos_theta) : cos_theta;
}

}  // namespace shadefit
