#include "fit/catalogue/catalogue_study.hpp"

#include <optional>
#include <string>
#include <utility>

#include "approx/cosine.hpp"
#include "fit/catalogue/fit_study.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {

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
  study.cuts.emplace();
  if (const auto cut = end_of_fall(surface)) study.cuts->push_back(*cut);
  return study;
}

std::optional<Study> study_of(const Family& family, const Setting& setting, const Metric& metric) {
  const auto [lower, upper] = metric.domain;
  Cosine<double> bottom{lower, 1 - lower};
  if (metric.error == Error::relative && !family.is_fresnel) {
    const auto visible_end = where_lobe_is_visible(setting.exponent);
    if (!visible_end) return std::nullopt;
    if (visible_end->cos_theta >= lower) bottom = *visible_end;
    if (bottom.one_minus_cos <= 1 - upper) return std::nullopt;
  }
  Study study = family.study;
  if (family.is_fresnel) {
    study = fresnel_study(setting.surface, metric.error);
    study.form = family.study.form;
  } else {
    study.given["k"] = hex_text(setting.exponent);
    study.error = metric.error;
  }
  study.over = {
      {"c", hex_text(bottom.cos_theta), hex_text(upper), density_of(std::string(name(metric.measure)), "c")}};
  study.held = metric.constraints.held;
  study.known_starts = family.starts_of(setting);
  if (metric.weight.empty()) return study;
  multiply_weight(study, metric.weight);
  return family.is_fresnel ? with_cuts(std::move(study)) : study;
}

void multiply_weight(Study& study, const std::string& weight) {
  if (weight.empty()) return;
  study.weight = study.weight == "1" ? weight : "(" + weight + ") (" + study.weight + ")";
}

}  // namespace shadefit
