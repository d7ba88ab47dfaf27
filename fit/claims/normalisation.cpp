#include "approx/normalisation.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "fit/claims/normalisation_check.hpp"
#include "fit/claims/reflectance.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

/// A constant as it is printed: a formula in a = alpha.
class PrintedConstant {
 public:
  explicit PrintedConstant(std::string_view text)
      : formula_(parse_formula(text, std::array<std::string_view, 1>{"a"})) {}

  double at(double alpha) const {
    return evaluate<double>(formula_, [&](const std::string&) { return alpha; });
  }

 private:
  Symbolic formula_;
};

const Normalisation& record_of(const Claim& claim) {
  return *std::ranges::find(normalisations, claim.id, &Normalisation::id);
}

/// A printed constant against 1 over the integral of its lobe, times a unit. Throws std::domain_error if the
/// formula has no finite value.
struct AgainstIntegrals {
  double furthest = 0;  ///< the largest relative difference
  double error = 0;     ///< of the integrals
  double first, last;   ///< the right constant, at the first exponent and the last

  AgainstIntegrals(const Claim& claim, const PrintedConstant& printed, double unit = 1) {
    const Normalisation& record = record_of(claim);
    const auto checks = check_normalisation(
        record, record.has_exponent ? parse_sweep(claim.inputs.at("exponents")) : std::vector<double>{});
    for (const NormalisationCheck& check : checks) {
      const double difference =
          std::abs(printed.at(check.exponent.value_or(1)) / (unit * check.integral) - 1);
      if (!std::isfinite(difference)) throw std::domain_error("the constant has no finite value");
      furthest = std::max(furthest, difference);
      error = std::max(error, check.estimated_error);
    }
    first = unit * checks.front().integral;
    last = unit * checks.back().integral;
  }
  std::optional<Verdict> verdict() const { return judge_normalisation(furthest, error); }
};

template <class... More>
Finding told_constant(const Claim& claim, const AgainstIntegrals& found, std::optional<Verdict> verdict,
                      const More&... more) {
  return told(claim, verdict, "none", Told{"lobe", record_of(claim).lobe}, Told{"first", found.first},
              Told{"last", found.last}, Told{"tolerance", normalisation_tolerance},
              Told{"apart", std::max(found.error, normalisation_tolerance)}, more...);
}

Finding constant_alone(const Claim& claim) {
  const AgainstIntegrals found(claim, PrintedConstant(claim.printed[0].value));
  return told_constant(claim, found, found.verdict());
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

/// The curve with the largest peak.
const ReflectanceCurve& curve_with_largest(const std::vector<ReflectanceCurve>& curves,
                                           ReflectancePeak ReflectanceCurve::*part) {
  return *std::ranges::max_element(curves, [&](const auto& a, const auto& b) {
    return (b.*part).value > (a.*part).value * (1 + equal_extrema);
  });
}

/// A constant that is stated for v = n, at every other view.
Finding constant_at_every_view(const Claim& claim) {
  const PrintedConstant printed(claim.printed[0].value);
  const AgainstIntegrals found(claim, printed);
  const auto curves = curves_of(claim, printed);
  const auto &plain = curve_with_largest(curves, &ReflectanceCurve::largest),
             &with_cosine = curve_with_largest(curves, &ReflectanceCurve::largest_with_cosine);
  const bool creates_energy =
      std::max(plain.largest.value, with_cosine.largest_with_cosine.value) > 1 + energy_tolerance;
  const double error = error_of(curves);
  auto verdict = found.verdict();
  if (verdict == Verdict::confirmed && creates_energy) verdict = Verdict::conditional;
  if (!(error <= reflectance_tolerance)) verdict.reset();
  // the lowest reflectance at the flattest view
  const auto at_end = [](const ReflectanceCurve& curve) { return curve.points.back().reflectance; };
  const auto lowest = std::ranges::min_element(curves, {}, at_end);
  const auto words = [](const ReflectanceCurve& curve, const ReflectancePeak& peak) {
    return fmt::format("{:.6g} (a = {:.6g}, seen from {:.4g} degrees)", peak.value, curve.exponent,
                       peak.view_angle);
  };
  return told_constant(claim, found, verdict, Told{"views", views_of(claim).size()},
                       Told{"most", words(plain, plain.largest)},
                       Told{"most_with_cosine", words(with_cosine, with_cosine.largest_with_cosine)},
                       Told{"creates", creates_energy ? "it creates energy" : "it creates no energy"},
                       Told{"least", at_end(*lowest)}, Told{"least_exponent", lowest->exponent},
                       Told{"least_view", lowest->points.back().view_angle},
                       Told{"two_ways", std::max(error, reflectance_tolerance)});
}

/// The distance of a stand-in from the exact constant, relative, as a function of log2(alpha).
using DistanceAt = std::function<double(double log2_alpha)>;

constexpr double grid_first = -10, grid_last = 20, grid_step = 0.125;

constexpr unsigned root_bits = 45;

/// The place where the stand-in is furthest from the exact constant: the worst of a grid, refined between its
/// neighbours to half of the digits of a double.
double furthest_place(const DistanceAt& distance) {
  double place = grid_first;
  for (double x = grid_first; x <= grid_last; x += grid_step) {
    if (distance(x) > distance(place)) place = x;
  }
  if (place == grid_first || place == grid_last) return place;
  return boost::math::tools::brent_find_minima([&](double x) { return -distance(x); }, place - grid_step,
                                               place + grid_step, 27)
      .first;
}

/// Returns the range of powers in which it is further away than `allowed`. Where no power is, both ends
/// are 0.
Range powers_beyond(const DistanceAt& distance, double allowed) {
  std::vector<double> places;
  for (double x = grid_first; x <= grid_last; x += grid_step) places.push_back(x);
  const auto beyond = where_positive([&](double x) { return distance(x) - allowed; }, places, root_bits);
  if (beyond.empty()) return {0, 0};
  return {std::exp2(beyond.front().from), std::exp2(beyond.back().to)};
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
Verdict closest_at_low_powers(const DistanceAt& distance, double furthest) {
  for (double x = grid_first; x + grid_step <= furthest; x += grid_step) {
    if (distance(x) > distance(x + grid_step)) return Verdict::refuted;
  }
  return verdict_of(furthest >= grid_last, furthest > grid_first);
}

Finding cheap_constant(const Claim& claim) {
  const PrintedConstant printed(claim.printed[0].value);
  const double close = given(claim, "close");
  double error = 0;
  for (const auto& check :
       check_normalisation(BlinnPhongBrdfLobe::record, parse_sweep(claim.inputs.at("exponents"))))
    error = std::max({error, check.estimated_error, check.relative_difference});
  const auto curves = curves_of(claim, printed);
  error = std::max(error, error_of(curves));
  const auto ratio = [&](double log2_alpha) {
    const double alpha = exp2(log2_alpha);
    return printed.at(alpha) / BlinnPhongBrdfLobe::constant(alpha);
  };
  const DistanceAt distance = [&](double log2_alpha) { return std::abs(ratio(log2_alpha) - 1); };
  const double place = furthest_place(distance), code = change_of_one_code();
  const Range beyond_code = powers_beyond(distance, code);
  const Verdict verdict =
      worst(std::array{verdict_of(distance(place) <= close), closest_at_low_powers(distance, place)});
  return told(claim, error <= reflectance_tolerance ? std::optional(verdict) : std::nullopt,
              effect_of_factor(ratio(place), 1, fmt::format("at a = {:.3g} it", std::exp2(place))),
              Told{"exact", BlinnPhongBrdfLobe::record.printed}, Told{"ratio", ratio(place)},
              Told{"place", std::exp2(place)}, Told{"furthest", distance(place)},
              Told{"is_within", distance(place) <= close ? "within" : "not within"}, Told{"one_code", code},
              Told{"code_up_to", beyond_code.from}, Told{"code_from", beyond_code.to},
              Told{"closer_from", powers_beyond(distance, distance(std::log2(given(claim, "low power")))).to},
              Told{"views", views_of(claim).size()}, Told{"energy", energy_in_words(curves)});
}

/// The quarter of the distribution's constant, and the same in a game's light unit.
Finding microfacet_constant(const Claim& claim) {
  const AgainstIntegrals plain(claim, PrintedConstant(claim.printed[0].value));
  const AgainstIntegrals in_unit(claim, PrintedConstant(claim.printed[1].value),
                                 PrintedConstant(claim.inputs.at("light unit")).at(1));
  return told_constant(claim, plain, worst(std::array{plain.verdict(), in_unit.verdict()}),
                       Told{"unit_first", in_unit.first}, Told{"unit_last", in_unit.last});
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
          {"norm-microfacet", microfacet_constant}};
}

}  // namespace shadefit
