#include "approx/microfacet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "fit/errors/effect.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/integrals/microfacet_integrals.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/root.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// The tolerance of the integrals, and the promised error, two digits larger because the estimates of the
/// rules are cautious. Searches, whose places are printed to four digits, need less.
constexpr double microfacet_tolerance = 1e-13;
constexpr double promised = 1e-11;
constexpr double place_tolerance = 1e-9;

/// The roughnesses of a claim and their widths alpha, in rising order of the roughness.
struct Widths {
  std::vector<double> roughness;
  std::function<double(double)> alpha;

  explicit Widths(const Claim& claim) : roughness(parse_sweep(claim.inputs.at("roughness"))) {
    constexpr std::array<std::string_view, 1> variables{"r"};
    alpha = [formula = parse_formula(claim.inputs.at("alpha"), variables)](double r) {
      return evaluate<double>(formula, [r](const std::string&) { return r; });
    };
    std::ranges::sort(roughness);
  }

  std::string words() const {
    return fmt::format("{}{} from {:.6g} to {:.6g} (alpha from {:.6g} to {:.6g})", roughness.size(),
                       roughness.size() == 1 ? " roughness" : " roughnesses", roughness.front(),
                       roughness.back(), alpha(roughness.front()), alpha(roughness.back()));
  }
};

/// The largest difference of integrals from their expected value.
struct Furthest {
  double relative = 0;  ///< the largest |integral / expected - 1|
  double integral = 0;  ///< there
  double roughness = 0;
  double view_angle = 0;  ///< in degrees
  double error = 0;       ///< of any of them, relative: both rules' estimates and their difference
};

void consider(Furthest& worst, const Furthest& one) {
  const double error = std::max(worst.error, one.error);
  if (one.relative >= worst.relative) worst = one;
  worst.error = error;
}

/// `confirmed` if all integrals agree to the promised error, empty if they are not that accurate.
std::optional<Verdict> judged(const Furthest& distance) {
  if (!(distance.error <= promised)) return std::nullopt;
  return verdict_of(distance.relative <= promised);
}

Furthest area_distance(Distribution distribution, const Widths& widths, double printed) {
  Furthest worst;
  for (const double r : widths.roughness) {
    const TwoWays area = integrate_projected_area(distribution, widths.alpha(r), microfacet_tolerance);
    consider(worst, {std::abs(area.value() / printed - 1), area.value(), r, 0, area.error() / area.value()});
  }
  return worst;
}

std::string area_evidence(const Furthest& worst, const Widths& widths, std::string_view printed) {
  const std::string result =
      worst.relative <= promised
          ? fmt::format("is {} to better than {:.1g}", printed, promised)
          : fmt::format("is {:.10g} at roughness {:.6g}, not {},", worst.integral, worst.roughness, printed);
  return fmt::format(
      "the integral of D(m) (n.m) over the sphere of normals, with D = 0 for n.m <= 0, {} at {}. Two rules "
      "agree within {:.1g}",
      result, widths.words(), std::max(promised, worst.error));
}

template <Distribution distribution>
Finding normalised(const Claim& claim) {
  const Widths widths(claim);
  const std::string_view printed = claim.printed[0].value;
  const auto expected = in_50_digits(parse_formula(printed, {})).convert_to<double>();
  const Furthest worst = area_distance(distribution, widths, expected);
  return {judged(worst), decimal(worst.integral, 10), area_evidence(worst, widths, printed),
          judged(worst) == Verdict::confirmed
              ? "none"
              : effect_of_factor(expected, worst.integral,
                                 fmt::format("at roughness {:.6g} it", worst.roughness))};
}

/// The largest relative distance of GTR1 at that alpha from `limit`, over normals from n to the horizon.
double distance_from_limit(const Decimal50& alpha, const Decimal50& limit) {
  Decimal50 largest = 0;
  for (const int sixteenths : {0, 4, 8, 12, 16}) {
    const Decimal50 cos2 = Decimal50(sixteenths) / 16;
    const Decimal50 d = gtr1_distribution(MicrofacetNormal<Decimal50>{cos2, 1 - cos2}, alpha);
    largest = max(largest, Decimal50(abs(d / limit - 1)));
  }
  return largest.convert_to<double>();
}

/// GTR1 has a second number: its limit at alpha = 1.
Finding gtr1_normalised(const Claim& claim) {
  Finding finding = normalised<Distribution::gtr1>(claim);
  const std::string_view printed = claim.printed[1].value;
  const std::string_view step_text = claim.inputs.at("distance from alpha = 1");
  const Decimal50 limit = in_50_digits(parse_formula(printed, {}));
  const auto step = constant<Decimal50>(step_text);
  const double at_one = distance_from_limit(1, limit);
  const double beside = std::max(distance_from_limit(1 - step, limit), distance_from_limit(1 + step, limit));
  // The law's next term is of the order of the step itself, relative to the first.
  const double allowed = number_of(step_text) * 1.01;
  const bool is_limit = at_one <= promised && beside <= allowed;
  finding.verdict = worst(std::array{finding.verdict, std::optional(verdict_of(is_limit))});
  const Decimal50 here = gtr1_distribution(MicrofacetNormal<Decimal50>{1, 0}, Decimal50(1));
  finding.computed += fmt::format(", {:.10g}", here.convert_to<double>());
  finding.evidence += fmt::format(
      ". At alpha = 1 D is {:.10g}{}{}, for every m. At alpha = 1 - h and 1 + h, h = {}, it is within "
      "{:.2g} of that value, relative, in 50 digits",
      here.convert_to<double>(), is_limit ? " = " : ", not ", printed, step_text, beside);
  return finding;
}

/// A distribution with the masking of a claim.
struct Pair {
  Distribution distribution;
  Masking masking;
};

std::vector<double> angles_of(const Claim& claim) {
  std::vector<double> angles = parse_sweep(claim.inputs.at("view angles"));
  std::ranges::sort(angles);
  return angles;
}

/// G1 times the visible area over v.n at every roughness and view.
struct MaskingTable {
  std::vector<std::string> at_flattest_view = {};  ///< by roughness
  Furthest worst = {};                             ///< from 1
};

MaskingTable masking_table(const Pair& pair, const Widths& widths, const std::vector<double>& angles) {
  MaskingTable table;
  for (const double r : widths.roughness) {
    const double alpha = widths.alpha(r);
    double ratio = 0;
    for (const double degrees : angles) {
      const View view(degrees);
      const TwoWays area = integrate_visible_area(pair.distribution, alpha, view, microfacet_tolerance);
      ratio = masking(pair.masking, view, alpha) * area.value() / view.direction.cosine;
      consider(table.worst, {std::abs(ratio - 1), ratio, r, degrees, area.error() / area.value()});
    }
    table.at_flattest_view.push_back(decimal(ratio, 4));
  }
  return table;
}

std::string views_in_words(const std::vector<double>& angles) {
  return fmt::format("{} from {:.6g} to {:.6g} degrees", counted(std::ssize(angles), "view angle"),
                     angles.front(), angles.back());
}

/// The effect of a masking on a surface with F = 1, which should reflect all of the light.
std::string effect_of_masking(const Furthest& worst, std::string_view distribution) {
  return effect_of_factor(
      worst.integral, 1,
      fmt::format("{} with F = 1, with masking but no shadowing, at roughness {:.6g} and {:.6g} degrees,",
                  distribution, worst.roughness, worst.view_angle));
}

Finding masked_by_its_own(const Claim& claim) {
  const Widths widths(claim);
  const auto angles = angles_of(claim);
  const Pair pair{distribution_of(claim.inputs.at("distribution")), masking_of(claim.inputs.at("masking"))};
  const Furthest worst = masking_table(pair, widths, angles).worst;
  const bool holds = worst.relative <= promised;
  const std::string most = holds ? fmt::format("less than {:.1g}", promised)
                                 : fmt::format("up to {:.4g} (at roughness {:.6g}, {:.6g} degrees)",
                                               worst.relative, worst.roughness, worst.view_angle);
  return {judged(worst), holds ? "identity" : fmt::format("{:.4g} v.n", worst.integral),
          fmt::format(
              "the integral of G1 D(m) max(v.m, 0) differs from v.n by {}, relative, at {} and {}. Two rules "
              "agree within {:.1g}",
              most, widths.words(), views_in_words(angles), std::max(promised, worst.error)),
          holds ? "none" : effect_of_masking(worst, claim.inputs.at("distribution"))};
}

/// The end of the range in which f is at most 0: the last place if it is so at all places, else a root of f
/// between the two where the sign changes; nothing if f is above 0 at the first.
std::optional<double> holds_up_to(const std::function<double(double)>& f, const std::vector<double>& places) {
  const auto above = std::ranges::find_if(places, [&](double place) { return f(place) > 0; });
  if (above == places.end()) return places.back();
  if (above == places.begin()) return std::nullopt;
  return root_between(f, *(above - 1), *above, 30);
}

/// The range in which a borrowed masking is within `allowed`: up to a roughness for every view, and up to a
/// view for every roughness.
struct LoanRange {
  std::optional<double> roughness;
  std::optional<double> view_angle;
};

LoanRange range_of(const Pair& pair, const Widths& widths, const std::vector<double>& angles,
                   double allowed) {
  // |G1 times the visible area over v.n, less 1|, by one rule
  const auto error_at = [&](double r, double degrees) {
    if (degrees == 0) return -allowed;  // along the normal nothing is masked
    const double alpha = widths.alpha(r);
    const View view(degrees);
    const double area =
        integrate_visible_area_by_slope(pair.distribution, alpha, view, place_tolerance).value;
    return std::abs(masking(pair.masking, view, alpha) * area / view.direction.cosine - 1) - allowed;
  };
  const auto at_roughness = [&](double r) {
    double most = -allowed;
    for (const double degrees : angles) most = std::max(most, error_at(r, degrees));
    return most;
  };
  const auto at_view = [&](double degrees) {
    double most = -allowed;
    for (const double r : widths.roughness) most = std::max(most, error_at(r, degrees));
    return most;
  };
  std::vector<double> views{0};
  views.insert(views.end(), angles.begin(), angles.end());
  return {holds_up_to(at_roughness, widths.roughness), holds_up_to(at_view, views)};
}

std::string words(const LoanRange& range, const Widths& widths, double allowed) {
  const std::string by_view =
      range.view_angle ? fmt::format("up to {:.4g} degrees for all of these roughnesses", *range.view_angle)
                       : "at no view for all of these roughnesses";
  return range.roughness
             ? fmt::format("within {:.4g} of 1 up to roughness {:.4g} for all of these views, and {}",
                           allowed, *range.roughness, by_view)
             : fmt::format(
                   "within {:.4g} of 1 {}; for some of these views it is not, already at roughness {:.4g}",
                   allowed, by_view, widths.roughness.front());
}

/// One borrowed masking: its verdict, its largest error and the range in which it is good enough.
Finding loan(std::string_view distribution, const Claim& claim) {
  const Widths widths(claim);
  const auto angles = angles_of(claim);
  const std::string lender(claim.inputs.at(distribution));
  const Pair pair{distribution_of(distribution), masking_of(lender)};
  const MaskingTable table = masking_table(pair, widths, angles);
  const Furthest& worst = table.worst;
  const double accurate = given(claim, "accurate"), code = change_of_one_code();
  const LoanRange range = range_of(pair, widths, angles, accurate);
  const Verdict verdict = worst.relative <= accurate            ? Verdict::confirmed
                          : range.roughness || range.view_angle ? Verdict::conditional
                                                                : Verdict::refuted;
  const std::string ratio = decimal(worst.integral, 4);
  return {
      worst.error <= promised ? std::optional(verdict) : std::nullopt,
      fmt::format("{} v.n ({})", ratio, distribution),
      fmt::format(
          "{} with the G1 of {} gives {} times v.n at these roughnesses, seen from {:.6g} degrees. The worst "
          "is {}, at roughness {:.6g} and {:.6g} degrees. The ratio is {}. For one 8-bit sRGB code as the limit, "
          "the ratio is {}",
          distribution, lender, enumerated(table.at_flattest_view), angles.back(), ratio, worst.roughness,
          worst.view_angle, words(range, widths, accurate),
          words(range_of(pair, widths, angles, code), widths, code)),
      effect_of_masking(worst, distribution)};
}

Finding masked_by_another(const Claim& claim) {
  const Finding blinn_phong = loan("blinn-phong", claim), gtr1 = loan("gtr1", claim);
  const Widths widths(claim);
  return {worst(std::array{blinn_phong.verdict, gtr1.verdict}),
          fmt::format("at worst {}, {}", blinn_phong.computed, gtr1.computed),
          fmt::format("at {} and {}: {}. {}", widths.words(), views_in_words(angles_of(claim)),
                      blinn_phong.evidence, gtr1.evidence),
          sentences({blinn_phong.effect, gtr1.effect})};
}

}  // namespace

std::vector<Evaluator> microfacet_evaluators() {
  return {{"ndf-blinn-phong", normalised<Distribution::blinn_phong>},
          {"ndf-beckmann", normalised<Distribution::beckmann>},
          {"ndf-ggx", normalised<Distribution::ggx>},
          {"ndf-gtr1", gtr1_normalised},
          {"smith-beckmann", masked_by_its_own},
          {"smith-ggx", masked_by_its_own},
          {"smith-borrowed", masked_by_another}};
}

}  // namespace shadefit
