#include "approx/normalisation.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/errors/effect.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/integrals/normalisation_check.hpp"
#include "fit/integrals/reflectance.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/root.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// A constant as it is printed: a formula in a = alpha.
class PrintedConstant {
 public:
  explicit PrintedConstant(std::string_view text) : text_(text), formula_(parse_formula(text, names)) {}

  const std::string& text() const { return text_; }

  template <class T>
  T at(const T& alpha) const {
    return evaluate<T>(formula_, [&](const std::string&) { return alpha; });
  }

 private:
  static constexpr std::array<std::string_view, 1> names{"a"};
  std::string text_;
  Symbolic formula_;
};

const Normalisation& record_of(const Claim& claim) {
  const auto record = std::ranges::find(normalisations, claim.id, &Normalisation::id);
  if (record == normalisations.end()) throw std::logic_error(fmt::format("no normalisation {}", claim.id));
  return *record;
}

std::vector<double> exponents_of(const Claim& claim) {
  return record_of(claim).has_exponent ? parse_sweep(claim.inputs.at("exponents")) : std::vector<double>{};
}

/// "8 exponents from 0.1 to 1e+06".
std::string range_in_words(const std::vector<double>& values, std::string_view noun) {
  const auto [low, high] = std::ranges::minmax_element(values);
  return fmt::format("{} from {:.6g} to {:.6g}", counted(std::ssize(values), noun), *low, *high);
}

/// "v at a = 8", or "v" for a constant without an exponent.
std::string at_exponent(double value, std::optional<double> exponent) {
  return fmt::format("{:.10g}{}", value, exponent ? fmt::format(" at a = {:.6g}", *exponent) : "");
}

/// A printed constant and 1 over the integral of its lobe, times a unit. Throws std::domain_error if the
/// formula has no finite value.
Finding against_integrals(const Claim& claim, const PrintedConstant& printed,
                          std::string_view unit_text = {}) {
  const double unit = unit_text.empty() ? 1 : PrintedConstant(unit_text).at(1.0);
  const auto exponents = exponents_of(claim);
  const auto checks = check_normalisation(record_of(claim), exponents);
  double furthest = -1, error = 0;
  const NormalisationCheck* worst_check = nullptr;
  for (const NormalisationCheck& check : checks) {
    const double difference = std::abs(printed.at(check.exponent.value_or(1)) / (unit * check.integral) - 1);
    if (!std::isfinite(difference))
      throw std::domain_error(fmt::format("{} has no finite value", printed.text()));
    error = std::max(error, check.estimated_error);
    if (difference <= furthest) continue;
    furthest = difference;
    worst_check = &check;
  }
  Finding finding;
  finding.verdict = judge_normalisation(furthest, error);
  finding.computed = at_exponent(unit * checks.front().integral, checks.front().exponent);
  if (checks.size() > 1)
    finding.computed +=
        fmt::format(", {}", at_exponent(unit * checks.back().integral, checks.back().exponent));
  const double exact = unit * worst_check->integral;
  finding.evidence =
      fmt::format("{}1 over the integral of '{}'",
                  unit_text.empty() ? "" : fmt::format("{} times ", unit_text), record_of(claim).lobe);
  finding.evidence +=
      furthest <= normalisation_tolerance
          ? fmt::format(" is {} to better than {:.1g}", printed.text(), normalisation_tolerance)
          : fmt::format(" is {} and not the {:.10g} of {}", at_exponent(exact, worst_check->exponent),
                        printed.at(worst_check->exponent.value_or(1)), printed.text());
  if (checks.size() > 1)
    finding.evidence += fmt::format(", tested at {}", range_in_words(exponents, "exponent"));
  finding.evidence += fmt::format(" (by two quadrature rules that agree within {:.1g})",
                                  std::max(error, normalisation_tolerance));
  if (finding.verdict != Verdict::confirmed)
    finding.effect = effect_of_factor(
        printed.at(worst_check->exponent.value_or(1)), exact,
        worst_check->exponent ? fmt::format("at a = {:.6g} it", *worst_check->exponent) : "");
  return finding;
}

Finding constant_alone(const Claim& claim) {
  return against_integrals(claim, PrintedConstant(claim.printed[0].value));
}

/// The view along the normal, then every view angle of the claim.
std::vector<double> views_of(const Claim& claim) {
  std::vector<double> angles = parse_sweep(claim.inputs.at("view angles"));
  std::ranges::sort(angles);
  angles.insert(angles.begin(), 0);
  return angles;
}

/// The curves of a printed constant over the view angles, one for each exponent of the claim.
std::vector<ReflectanceCurve> curves_of(const Claim& claim, const PrintedConstant& printed) {
  const auto constant = std::ranges::find(
      reflected_constants, claim.id, [](const ReflectedConstant& reflected) { return reflected.record->id; });
  if (constant == reflected_constants.end()) throw std::logic_error("no reflectance of that constant");
  const auto angles = views_of(claim);
  std::vector<ReflectanceCurve> curves;
  for (const double alpha : parse_sweep(claim.inputs.at("exponents at other views")))
    curves.push_back(reflectance_curve(*constant, alpha, printed.at(alpha), angles));
  return curves;
}

double error_of(const std::vector<ReflectanceCurve>& curves) {
  double error = 0;
  for (const ReflectanceCurve& curve : curves) {
    for (const Reflectance& point : curve.points) error = std::max(error, point.estimated_error);
  }
  return error;
}

/// The largest of all curves, and "1 (a = 64, seen from 0 degrees)".
struct Largest {
  double value;
  std::string words;
};

Largest largest_of(const std::vector<ReflectanceCurve>& curves, ReflectancePeak ReflectanceCurve::*part) {
  const auto peak = std::ranges::max_element(curves, [&](const auto& a, const auto& b) {
    return (b.*part).value > (a.*part).value * (1 + equal_extrema);
  });
  const ReflectancePeak& top = (*peak).*part;
  return {top.value, fmt::format("{:.6g} (a = {:.6g}, seen from {:.4g} degrees)", top.value, peak->exponent,
                                 top.view_angle)};
}

/// The lowest reflectance at the flattest view.
Largest lowest_of(const std::vector<ReflectanceCurve>& curves) {
  const auto at_end = [](const ReflectanceCurve& curve) { return curve.points.back().reflectance; };
  const auto curve = std::ranges::min_element(curves, {}, at_end);
  return {at_end(*curve), fmt::format("{:.4g} (a = {:.6g}, {:.6g} degrees)", at_end(*curve), curve->exponent,
                                      curve->points.back().view_angle)};
}

/// A constant that is stated for v = n, at every other view.
Finding constant_at_every_view(const Claim& claim) {
  const PrintedConstant printed(claim.printed[0].value);
  Finding finding = against_integrals(claim, printed);
  const auto curves = curves_of(claim, printed);
  const Largest plain = largest_of(curves, &ReflectanceCurve::largest);
  const Largest with_cosine = largest_of(curves, &ReflectanceCurve::largest_with_cosine);
  const bool creates_energy = std::max(plain.value, with_cosine.value) > 1 + energy_tolerance;
  const double error = error_of(curves);
  if (!(error <= reflectance_tolerance)) finding.verdict.reset();
  if (finding.verdict == Verdict::confirmed && creates_energy) finding.verdict = Verdict::conditional;
  std::vector<double> exponents;
  for (const ReflectanceCurve& curve : curves) exponents.push_back(curve.exponent);
  const auto angles = views_of(claim);
  finding.evidence +=
      fmt::format(". Over {} degrees, at {}, its reflectance is at most {}",
                  range_in_words(angles, "view angle"), range_in_words(exponents, "exponent"), plain.words);
  if (plain.value != with_cosine.value)
    finding.evidence += fmt::format(", with n.l at most {}", with_cosine.words);
  finding.evidence += fmt::format("{}. Its smallest reflectance is {} (two ways that agree within {:.1g})",
                                  creates_energy ? ": it creates energy" : ": it creates no energy",
                                  lowest_of(curves).words, std::max(error, reflectance_tolerance));
  return finding;
}

/// (stand-in / exact constant) - 1, as a function of log2(alpha).
class CheapRatio {
 public:
  explicit CheapRatio(const PrintedConstant& printed) : printed_(printed) {}

  double operator()(double log2_alpha) const {
    const double alpha = exp2(log2_alpha);
    return printed_.at(alpha) / BlinnPhongBrdfLobe::constant(alpha) - 1;
  }
  double distance(double log2_alpha) const { return std::abs((*this)(log2_alpha)); }

 private:
  const PrintedConstant& printed_;
};

constexpr double grid_first = -10, grid_last = 20, grid_step = 0.125;

constexpr unsigned root_bits = 45;

/// The place where the stand-in is furthest from the exact constant: the worst of a grid, refined between its
/// neighbours to half of the digits of a double.
double furthest_place(const CheapRatio& ratio) {
  double place = grid_first;
  for (double x = grid_first; x <= grid_last; x += grid_step) {
    if (ratio.distance(x) > ratio.distance(place)) place = x;
  }
  if (place == grid_first || place == grid_last) return place;
  return boost::math::tools::brent_find_minima([&](double x) { return -ratio.distance(x); },
                                               place - grid_step, place + grid_step, 27)
      .first;
}

/// The place up to which it stays within `allowed` on the way from one end of the grid to the place `to`.
/// Empty if it does not cross `allowed` on the way.
std::optional<double> close_up_to(const CheapRatio& ratio, double from, double to, double allowed) {
  const auto excess = [&](double x) { return ratio.distance(x) - allowed; };
  const double step = std::copysign(grid_step, to - from);
  for (double x = from; (to - x) * step > 0 && excess(x) <= 0; x += step) {
    const double next = std::clamp(x + step, std::min(from, to), std::max(from, to));
    if (excess(next) > 0) return root_between(excess, std::min(x, next), std::max(x, next), root_bits);
  }
  return std::nullopt;
}

std::string within_one_code(const CheapRatio& ratio, double place) {
  const double code = change_of_one_code();
  const auto up_to = close_up_to(ratio, grid_first, place, code),
             from = close_up_to(ratio, grid_last, place, code);
  std::vector<std::string> ranges;
  if (up_to) ranges.push_back(fmt::format("up to a = {:.4g}", std::exp2(*up_to)));
  if (from) ranges.push_back(fmt::format("from a = {:.4g} on", std::exp2(*from)));
  return fmt::format("It is within one 8-bit sRGB code ({:.4g}) {}", code,
                     ranges.empty() ? std::string("nowhere") : enumerated(ranges));
}

/// The views at which it creates energy: "7.5 % seen along the normal .."
std::string energy_in_words(const std::vector<ReflectanceCurve>& curves) {
  std::vector<std::string> parts;
  for (const ReflectanceCurve& curve : curves) {
    parts.push_back(fmt::format(
        "a = {:.6g}{}", curve.exponent,
        curve.conserves_from
            ? fmt::format(" up to {:.3g} % at {:.4g} degrees, none from {:.4g} degrees on",
                          (curve.largest.value - 1) * 100, curve.largest.view_angle, *curve.conserves_from)
            : std::string(" none")));
  }
  return fmt::format("{}", fmt::join(parts, "; at "));
}

/// Whether it is closer for lower powers: everywhere, up to its worst place, or not at all.
Verdict closest_at_low_powers(const CheapRatio& ratio, double furthest) {
  for (double x = grid_first; x + grid_step <= furthest; x += grid_step) {
    if (ratio.distance(x) > ratio.distance(x + grid_step)) return Verdict::refuted;
  }
  return furthest <= grid_first  ? Verdict::refuted
         : furthest >= grid_last ? Verdict::confirmed
                                 : Verdict::conditional;
}

std::string closest_in_words(const CheapRatio& ratio, double furthest, double low) {
  const Verdict verdict = closest_at_low_powers(ratio, furthest);
  if (verdict == Verdict::confirmed) return "The lower the power, the closer it is";
  if (verdict == Verdict::refuted) return "It does not get closer with each lower power";
  const auto from = close_up_to(ratio, grid_last, furthest, ratio.distance(std::log2(low)));
  return fmt::format(
      "Below that a, a lower power has a ratio closer to 1. Above it this fails: {}{:.4g}",
      from ? fmt::format("from a = {:.4g} on the ratio is closer to 1 than at a = ", std::exp2(*from))
           : std::string("but nowhere there the ratio stays closer to 1 than at a = "),
      low);
}

Finding cheap_constant(const Claim& claim) {
  const PrintedConstant printed(claim.printed[0].value);
  const double close = given(claim, "close"), low = given(claim, "low power");
  const auto exponents = exponents_of(claim);
  double error = 0;
  for (const auto& check : check_normalisation(BlinnPhongBrdfLobe::record, exponents))
    error = std::max({error, check.estimated_error, check.relative_difference});
  const auto curves = curves_of(claim, printed);
  error = std::max(error, error_of(curves));
  const CheapRatio ratio(printed);
  const double place = furthest_place(ratio), furthest = ratio.distance(place);
  const Verdict verdict =
      worst(std::array{verdict_of(furthest <= close), closest_at_low_powers(ratio, place)});
  return {
      error <= reflectance_tolerance ? std::optional(verdict) : std::nullopt,
      fmt::format("up to {:.10g} times the exact constant", 1 + ratio(place)),
      told(claim, Told{"exact", BlinnPhongBrdfLobe::record.printed},
           Told{"exponents_tried", range_in_words(exponents, "exponent")}, Told{"place", std::exp2(place)},
           Told{"furthest", furthest}, Told{"is_within", furthest <= close ? "within " : "not within "},
           Told{"one_code", within_one_code(ratio, place)},
           Told{"closest", closest_in_words(ratio, place, low)},
           Told{"views", range_in_words(views_of(claim), "view angle")},
           Told{"energy", energy_in_words(curves)}),
      effect_of_factor(1 + ratio(place), 1, fmt::format("at a = {:.3g} it", std::exp2(place)))};
}

/// The quarter of the distribution's constant, and the same in a game's light unit.
Finding microfacet_constant(const Claim& claim) {
  const Finding plain = constant_alone(claim);
  const Finding in_unit =
      against_integrals(claim, PrintedConstant(claim.printed[1].value), claim.inputs.at("light unit"));
  return {worst(std::array{plain.verdict, in_unit.verdict}),
          fmt::format("{}; {}", plain.computed, in_unit.computed),
          sentences({plain.evidence, in_unit.evidence}),
          plain.effect == "none" ? in_unit.effect : plain.effect};
}

/// The effect of a detour in half precision, or "none".
std::string effect_in_half(const Symbolic& left, const Symbolic& right) {
  const auto value = [](const Symbolic& formula, Eigen::half colour) {
    return widened(evaluate<Eigen::half>(formula, [&](const std::string&) { return colour; }));
  };
  int moved = 0;
  Effect effect;
  for (int i = 1; i <= 255; ++i) {
    const Eigen::half grey = round_to_half(i / 255.0);
    const double a = value(left, grey), b = value(right, grey);
    moved += a != b;
    effect.show(b, a, {{"grey ", static_cast<double>(i), "/255"}});
  }
  return sentence(effect, fmt::format("{} of 255 linear greys", moved), "in half precision the detour");
}

/// An identity in c_diff, in 50 digits.
Finding light_unit(const Claim& claim) {
  constexpr std::array<std::string_view, 1> names{"c_diff"};
  const std::string_view left_text = claim.inputs.at("with pi"), right_text = claim.inputs.at("without");
  const Symbolic left = parse_formula(left_text, names), right = parse_formula(right_text, names);
  const auto value = [](const Symbolic& formula, const Decimal50& colour) {
    return in_50_digits(formula, [&](const std::string&) { return colour; });
  };
  Decimal50 furthest = 0;
  for (int i = 1; i <= 255; ++i) {
    const Decimal50 colour = Decimal50(i) / 255;
    furthest = max(furthest, Decimal50(abs(value(left, colour) / value(right, colour) - 1)));
  }
  constexpr double tolerance = 1e-45;  // of 50 digits, after three roundings
  const bool holds = furthest <= tolerance;
  const auto at_white = value(left, Decimal50(1)).convert_to<double>();
  return {
      verdict_of(holds), holds ? "identity" : fmt::format("{:.10g} at c_diff = 1", at_white),
      fmt::format("{} and {} differ by {}, relative, at 255 grey levels in 50 digits", left_text, right_text,
                  holds ? fmt::format("less than {:.1g}", tolerance)
                        : fmt::format("up to {:.4g}", furthest.convert_to<double>())),
      holds ? effect_in_half(left, right)
            : effect_of_factor(at_white, value(right, Decimal50(1)).convert_to<double>())};
}

}  // namespace

std::vector<Evaluator> normalisation_evaluators() {
  return {{"norm-lambert", constant_alone},
          {"norm-phong", constant_at_every_view},
          {"norm-phong-brdf", constant_at_every_view},
          {"norm-blinn-phong", constant_at_every_view},
          {"norm-blinn-phong-brdf", constant_at_every_view},
          {"norm-blinn-phong-cheap", cheap_constant},
          {"norm-ndf", constant_alone},
          {"norm-microfacet", microfacet_constant},
          {"norm-game-light-unit", light_unit}};
}

}  // namespace shadefit
