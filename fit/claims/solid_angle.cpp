#include <cmath>
#include <cstdint>
#include <numbers>

#include "approx/environment_map.hpp"
#include "approx/lobe.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

/// The tolerance of every rule: two digits below the strictest tolerance of the claims.
constexpr double rule_tolerance = 1e-14;
constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double degree = std::numbers::pi / 180;

/// The widest half-angle at which the plain form, in half precision, has lost the whole cap.
Eigen::half widest_lost_cap() {
  Eigen::half widest(0.0F);
  for (std::uint16_t bits = 1;; ++bits) {
    const auto angle = Eigen::numext::bit_cast<Eigen::half>(bits);
    if (static_cast<float>(cap_solid_angle(angle)) != 0) return widest;
    widest = angle;
  }
}

/// The form in half precision, at every half-angle that is a half from 2^-6 (about a degree) to pi.
std::string effect_of_cap() {
  Effect effect;
  for (std::uint16_t bits = 9 << 10;; ++bits) {
    const auto angle = Eigen::numext::bit_cast<Eigen::half>(bits);
    if (widened(angle) > std::numbers::pi) break;
    effect.show(cap_solid_angle_near_axis(widened(angle)), widened(cap_solid_angle(angle)),
                {{"phi = ", widened(angle) / degree, " degrees"}});
  }
  return sentence(effect, "the solid angle in sr", "in half precision the form");
}

/// The lobe's integral over the cosine (scaled by the power, to resolve its peak) and over the angle. A sharp
/// lobe is cut where it has fallen to exp(-48), 1e-21.
void compare_lobe(double exponent, Agreement& agreement) {
  const auto lobe = [&](const auto& place) {
    return whole_turn * power_lobe_near_peak(place.cosine.one_minus_cos, exponent) * place.density;
  };
  const Substitution cosine({.measure = Measure::cosine}, {.concentration = exponent, .end_power = exponent});
  const Substitution angle({.measure = Measure::angle}, {.concentration = exponent});
  const auto over_angle = [&](double s) {
    const auto place = angle.at(s);
    const double y = place.cosine.one_minus_cos;
    return lobe(place) * std::sqrt(y * (2 - y));
  };
  agreement.compare(lobe_solid_angle(exponent),
                    gauss_kronrod([&](double s) { return lobe(cosine.at(s)); }, 0, 1, rule_tolerance),
                    tanh_sinh(over_angle, 0, 1, rule_tolerance));
}

/// The solid angle of a square on a face by a product of two Gauss-Kronrod rules.
Integral integrated_texel(double x, double y, double size) {
  double inner_error = 0;
  const auto column = [&](double u) {
    const Integral part =
        gauss_kronrod([&](double v) { return cube_face_density(u, v); }, y, y + size, rule_tolerance);
    inner_error = std::max(inner_error, part.error);
    return part.value;
  };
  const Integral whole = gauss_kronrod(column, x, x + size, rule_tolerance);
  return {whole.value, whole.error + inner_error * size};
}

/// The closed form and the rule.
double compare_texel(double x, double y, double size, Agreement& agreement) {
  const double closed_form = texel_solid_angle(x, y, size);
  const Integral rule = integrated_texel(x, y, size);
  agreement.compare(closed_form, rule, rule);
  return closed_form;
}

/// The effect on the power whose lobe covers a mean texel, if a texel covers `ratio` of the mean one.
std::string effect_of_texel(double mean, double ratio, const std::string& where) {
  const double wanted = power_of_solid_angle(mean);
  return effect_of_power(wanted, power_of_solid_angle(ratio * mean),
                         fmt::format("{} the power that fits the texel instead of {:.4g}", where, wanted));
}

/// The level at which a mean texel covers the lobe's solid angle, by bisection: the edge of a texel doubles
/// with each level.
double solved_level(double width, double exponent) {
  return last_by_halving(-64, 64, 60, [&](double level) {
    return mean_texel_solid_angle(width, level) < lobe_solid_angle(exponent);
  });
}

/// How closely both rules agree with the closed form.
Told told_agreement(const Claim& claim, double gap) {
  return {"agree", within(gap, claim.inputs.at("tolerance"))};
}

Finding evaluate_cap(const Claim& claim) {
  Agreement agreement;
  for (const double phi : parse_sweep(claim.inputs.at("degrees"))) {
    const auto ring = [](double theta) { return whole_turn * std::sin(theta); };
    agreement.compare(cap_solid_angle(phi * degree), gauss_kronrod(ring, 0, phi * degree, rule_tolerance),
                      tanh_sinh(ring, 0, phi * degree, rule_tolerance));
  }
  const Eigen::half lost = widest_lost_cap();
  return told(claim, agreement.verdict(given(claim, "tolerance")), effect_of_cap(),
              told_agreement(claim, agreement.gap), Told{"lost", widened(lost) / degree},
              Told{"lost_cap", widened(cap_solid_angle_near_axis(lost))});
}

Finding evaluate_lobe(const Claim& claim) {
  Agreement agreement;
  for (const double exponent : parse_sweep(claim.inputs.at("powers"))) compare_lobe(exponent, agreement);
  return told(claim, agreement.verdict(given(claim, "tolerance")), "none",
              told_agreement(claim, agreement.gap));
}

Finding evaluate_texel(const Claim& claim) {
  const double tolerance = given(claim, "tolerance"), width = given(claim, "width");
  const double edge = texels_along_edge(width, given(claim, "level")), size = 2 / edge;
  const double mean = mean_texel_solid_angle(width, given(claim, "level"));
  Agreement agreement, of_face;
  const double corner = compare_texel(1 - size, 1 - size, size, agreement) / mean;
  // A texel at the centre; if the face is one texel, that texel.
  const double centre = compare_texel(edge < 2 ? -1 : 0, edge < 2 ? -1 : 0, size, agreement) / mean;
  const Integral face = integrated_texel(-1, -1, 2);
  of_face.compare(mean * edge * edge, face, {texel_solid_angle(-1.0, -1.0, 2.0), face.error});
  // The limit of a texel over the mean: the density at its place times the face's area over its solid angle.
  const double limit = 4 / texel_solid_angle(-1.0, -1.0, 2.0);
  const bool is_ordered = corner < 1 - tolerance && centre > 1 + tolerance;
  const std::optional<Verdict> parts[] = {of_face.verdict(tolerance), agreement.verdict(tolerance),
                                          is_ordered ? Verdict::confirmed : Verdict::conditional};
  return told(claim, worst(parts),
              sentences({effect_of_texel(mean, centre, "at the centre of a face"),
                         effect_of_texel(mean, corner, "in its corner")}),
              Told{"face", face.value}, Told{"edge", edge}, told_agreement(claim, of_face.gap),
              Told{"corner", corner}, Told{"centre", centre},
              Told{"corner_limit", limit * cube_face_density(1.0, 1.0)},
              Told{"centre_limit", limit * cube_face_density(0.0, 0.0)});
}

Finding evaluate_mip_level(const Claim& claim) {
  const std::vector<double> widths = parse_sweep(claim.inputs.at("widths"));
  const std::vector<double> exponents = parse_sweep(claim.inputs.at("powers"));
  const double root = number_of(claim.printed[0].value), factor = number_of(claim.printed[1].value);
  double gap = 0, formula_gap = 0, solved_root = 0, solved_factor = 0;
  for (const double width : widths) {
    const double first = exponents.front(), first_level = solved_level(width, first);
    for (const double s : exponents) {
      const double level = solved_level(width, s), edge = texels_along_edge(width, level);
      formula_gap = std::max(formula_gap, std::abs(mip_level_of_power(width, s) - level));
      solved_root = (s + 1) / (edge * edge);
      gap = std::max(gap, std::abs(solved_root - root));
      if (s == first) continue;
      solved_factor = (first_level - level) / std::log2((s + 1) / (first + 1));
      gap = std::max(gap, std::abs(solved_factor - factor));
    }
  }
  return told(claim, verdict_of(std::max(gap, formula_gap) <= given(claim, "tolerance")), "none",
              Told{"root", solved_root}, Told{"factor", solved_factor}, told_agreement(claim, gap),
              Told{"formula_agrees", within(formula_gap, claim.inputs.at("tolerance"))},
              Told{"w", widths[widths.size() / 2]});
}

}  // namespace

/// The claims on solid angles of caps, lobes and texels, and the mip level that follows from them.
std::vector<Evaluator> solid_angle_evaluators() {
  return {{"cap-solid-angle", evaluate_cap},
          {"lobe-solid-angle", evaluate_lobe},
          {"texel-solid-angle", evaluate_texel},
          {"mip-level", evaluate_mip_level}};
}

}  // namespace shadefit
