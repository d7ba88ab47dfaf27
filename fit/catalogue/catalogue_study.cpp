#include "fit/catalogue/catalogue_study.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/catalogue/fit_study.hpp"
#include "fit/squares/prepared_study.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// Whether the variable of a family is t = k (c - 1): nearly all of the lobe is next to its peak.
bool is_sharp_lobe(const Family& family, const Setting& setting) {
  return family.has_exponent() && setting.exponent >= 2;
}

/// The smallest cosine with c^k >= 1/255: exp(-log(255)/k). Empty below k = 0.0078, where that is less than
/// any double.
std::optional<Cosine<double>> where_lobe_is_visible(double exponent) {
  const double log_end = -std::log(255.0) / exponent;
  if (std::exp(log_end) < std::numeric_limits<double>::min()) return std::nullopt;
  return Cosine<double>{std::exp(log_end), -std::expm1(log_end)};
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

void take_sharp_lobe(Study& study, const Family& family, double exponent, const Metric& metric,
                     const CosineRange& ends) {
  study.target = family.target_near_peak;
  study.form = family.form_near_peak;
  study.over = {{"t", hex_text(-exponent * ends.second.one_minus_cos),
                 hex_text(-exponent * ends.first.one_minus_cos), density_in_t(metric.measure, exponent)}};
  study.definitions = {{"y", {}, "-t/k"}, {"c", {}, "1 + t/k"}};
  study.cuts = cuts_of_lobe(-exponent);
}

StudyRange over_cosine(const Metric& metric, const CosineRange& ends) {
  return {"c", hex_text(ends.second.cos_theta), hex_text(ends.first.cos_theta),
          density_of(std::string(name(metric.measure)), "c")};
}

/// The singularity of a blunt lobe at c = 0 draws the nodes there. A relative error is steep next to it.
void take_blunt_lobe(Study& study, const Family& family, const Metric& metric, const CosineRange& ends) {
  study.target = family.target_text;
  study.form = family.form_near_peak;
  study.over = {over_cosine(metric, ends)};
  study.definitions = {{"y", {}, "1 - c"}};
  study.cuts.emplace();
  if (metric.error == Error::relative)
    for (int power = -64; power < 0; power += 4) study.cuts->push_back(std::ldexp(1.0, power));
}

Study fresnel_form(const Family& family, const Surface& surface, const Metric& metric,
                   const CosineRange& ends) {
  Study study = fresnel_study(surface, metric.error);
  study.form = family.form_text;
  study.over = {over_cosine(metric, ends)};
  study.cuts.emplace();
  if (const auto cut = end_of_fall(surface)) study.cuts->push_back(*cut);
  return study;
}

Study lobe_form(const Family& family, const Setting& setting, const Metric& metric, const CosineRange& ends) {
  Study study;
  study.residual = family.error_text;
  study.given["k"] = hex_text(setting.exponent);
  study.error = metric.error;
  if (is_sharp_lobe(family, setting)) {
    take_sharp_lobe(study, family, setting.exponent, metric, ends);
  } else {
    take_blunt_lobe(study, family, metric, ends);
  }
  return study;
}

}  // namespace

std::optional<CosineRange> ends_of(const Family& family, const Setting& setting, const Domain& domain,
                                   Error error) {
  const Cosine<double> top{domain.upper, 1 - domain.upper};
  Cosine<double> bottom{domain.lower, 1 - domain.lower};
  if (error == Error::absolute || family.is_fresnel) return CosineRange{top, bottom};
  const auto visible_end = where_lobe_is_visible(setting.exponent);
  if (!visible_end) return std::nullopt;
  if (visible_end->cos_theta >= domain.lower) bottom = *visible_end;
  if (bottom.one_minus_cos <= top.one_minus_cos) return std::nullopt;
  return CosineRange{top, bottom};
}

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

Study study_of(const Family& family, const Setting& setting, const Metric& metric, const CosineRange& ends) {
  Study study = family.is_fresnel ? fresnel_form(family, setting.surface, metric, ends)
                                  : lobe_form(family, setting, metric, ends);
  study.held = metric.constraints.held;
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
  const ReadStudy read = read_study(study);
  return [prepared = std::make_shared<PreparedStudy>(study), scale, read,
          has_poles = !moving_poles(read).empty()](std::span<const double> parameters) {
    const std::vector<double> values(parameters.begin(), parameters.end());
    return has_poles && pole_of(read, values) ? HUGE_VAL : prepared->rms_error(values) / scale;
  };
}

Cosine<double> cosine_at(const Family& family, const Setting& setting, double variable) {
  if (!is_sharp_lobe(family, setting)) return {variable, 1 - variable};
  const double one_minus_cos = -variable / setting.exponent;
  return {1 - one_minus_cos, one_minus_cos};
}

double variable_at(const Family& family, const Setting& setting, const Cosine<double>& cosine) {
  return is_sharp_lobe(family, setting) ? -setting.exponent * cosine.one_minus_cos : cosine.cos_theta;
}

std::string in_cosines(const Family& family, const Setting& setting, std::string sentence) {
  constexpr std::string_view before = " at t = ";
  const auto place = sentence.find(before);
  if (place == std::string::npos) return sentence;
  const std::optional<double> t = parse_number(sentence.substr(place + before.size()));
  return t ? sentence.substr(0, place) + " at c = " + to_text(cosine_at(family, setting, *t).cos_theta)
           : sentence;
}

}  // namespace shadefit
