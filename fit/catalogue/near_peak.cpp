#include "fit/catalogue/near_peak.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/catalogue/fit_study.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

double exponent_of(const Study& study) {
  return number_in(study, {"--given", "k"}, "k");
}

/// The density over c as one over t = k (c - 1). That of the angle is 1/sqrt((1 - c) (1 + c)).
std::string density_in_t(const StudyRange& range, const std::string& k) {
  if (range.density == "1") return "1";
  if (range.density == density_of("angle", range.variable)) return "1/(sqrt(-t) sqrt(2 + t/" + k + "))";
  const Symbolic cosine = Symbolic::number("1") + Symbolic::variable("t") / Symbolic::number(k);
  const std::array<std::string_view, 1> variables{range.variable};
  return to_text(evaluate<Symbolic>(parse_formula(range.density, variables),
                                    [&](const std::string&) { return cosine; }));
}

/// Parts in which a lobe and the density of the angle are smooth enough for a rule.
std::vector<double> cuts_of_lobe(double lower) {
  std::vector<double> cuts{-3, -9, -24, -64};
  while (cuts.back() > lower) cuts.push_back(8 * cuts.back());
  return cuts;
}

/// 1 - c at the lower end of the range. That of the end of a visible lobe has all its digits.
double one_minus_lower(double cosine, double exponent) {
  const auto visible_end = where_lobe_is_visible(exponent);
  const bool is_visible_end = visible_end && std::abs(visible_end->cos_theta - cosine) <=
                                                 4 * std::numeric_limits<double>::epsilon() * cosine;
  return is_visible_end ? visible_end->one_minus_cos : 1 - cosine;
}

void take_sharp_lobe(Study& study, double exponent) {
  const StudyRange& range = study.over.front();
  const StudyPart part{"--over", range.variable};
  const double lower = one_minus_lower(number_in(study, part, range.lower), exponent),
               upper = 1 - number_in(study, part, range.upper);
  const auto end = [&](double one_minus_cos) { return hex_text(-exponent * one_minus_cos); };
  study.given["k"] = hex_text(exponent);  // the same number as in the range
  study.target = study.near_peak.target;
  study.form = study.near_peak.form;
  study.over = {{"t", end(lower), end(upper), density_in_t(range, hex_text(exponent))}};
  study.definitions = {{"y", {}, "-t/k"}, {"c", {}, "1 + t/k"}};
  study.cuts = cuts_of_lobe(-exponent);
}

/// The singularity of a blunt lobe at c = 0 draws the nodes there. A relative error is steep next to it.
void take_blunt_lobe(Study& study) {
  study.form = study.near_peak.form;
  study.cuts.emplace();
  if (study.error == Error::relative)
    for (int power = -64; power < 0; power += 4) study.cuts->push_back(std::ldexp(1.0, power));
}

}  // namespace

std::optional<Cosine<double>> where_lobe_is_visible(double exponent) {
  const double log_end = -std::log(255.0) / exponent;
  if (std::exp(log_end) < std::numeric_limits<double>::min()) return std::nullopt;
  return Cosine<double>{std::exp(log_end), -std::expm1(log_end)};
}

bool has_peak(const Study& study) {
  return !study.near_peak.target.empty();
}

Study near_peak(Study study) {
  if (!has_peak(study)) return study;
  const PeakVariable variable = peak_variable(study);
  if (variable.exponent > 0) {
    take_sharp_lobe(study, variable.exponent);
  } else {
    take_blunt_lobe(study);
  }
  study.near_peak = {};
  return study.weight == "1" ? study : with_cuts(std::move(study));
}

Cosine<double> PeakVariable::cosine_at(double value) const {
  if (exponent == 0) return {value, 1 - value};
  const double one_minus_cos = -value / exponent;
  return {1 - one_minus_cos, one_minus_cos};
}

double PeakVariable::value_at(const Cosine<double>& cosine) const {
  return exponent == 0 ? cosine.cos_theta : -exponent * cosine.one_minus_cos;
}

PeakVariable peak_variable(const Study& study) {
  if (!has_peak(study)) return {};
  const double exponent = exponent_of(study);
  return {exponent < 2 ? 0 : exponent};
}

std::string in_cosines(const PeakVariable& variable, std::string sentence) {
  constexpr std::string_view before = " at t = ";
  const auto place = sentence.find(before);
  if (place == std::string::npos) return sentence;
  const std::optional<double> t = parse_number(sentence.substr(place + before.size()));
  return t ? sentence.substr(0, place) + " at c = " + to_text(variable.cosine_at(*t).cos_theta) : sentence;
}

}  // namespace shadefit
