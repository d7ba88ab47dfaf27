#include "approx/microfacet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "fit/claims/microfacet_integrals.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/support/root.hpp"

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
    return fmt::format("{} roughnesses from {:.6g} to {:.6g} (alpha from {:.6g} to {:.6g})", roughness.size(),
                       roughness.front(), roughness.back(), alpha(roughness.front()),
                       alpha(roughness.back()));
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

/// The finding on integrals that have to agree to the promised error.
template <class... More>
Finding told_integrals(const Claim& claim, const Furthest& worst, std::optional<Verdict> verdict,
                       const More&... more) {
  return told(claim, verdict, "none", Told{"integral", worst.integral}, Told{"widths", Widths(claim).words()},
              Told{"promised", promised}, Told{"apart", std::max(promised, worst.error)}, more...);
}

Furthest area_distance(const Distribution& distribution, const Claim& claim) {
  const Widths widths(claim);
  const auto expected = in_50_digits(parse_formula(claim.printed[0].value, {})).convert_to<double>();
  Furthest worst;
  for (const double r : widths.roughness) {
    const TwoWays area = integrate_projected_area(distribution, widths.alpha(r), microfacet_tolerance);
    consider(worst, {std::abs(area.value() / expected - 1), area.value(), r, 0, area.error() / area.value()});
  }
  return worst;
}

/// The id of the claim has the name of the distribution.
Finding normalised(const Claim& claim) {
  const Furthest worst = area_distance(distribution_of(claim.id.substr(4)), claim);
  return told_integrals(claim, worst, judged(worst));
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
  const Furthest area = area_distance(distribution_of("gtr1"), claim);
  const Decimal50 limit = in_50_digits(parse_formula(claim.printed[1].value, {}));
  const auto step = constant<Decimal50>(claim.inputs.at("distance from alpha = 1"));
  const double beside = std::max(distance_from_limit(1 - step, limit), distance_from_limit(1 + step, limit));
  // The law's next term is of the order of the step itself, relative to the first.
  const bool is_limit =
      distance_from_limit(1, limit) <= promised && beside <= 1.01 * step.convert_to<double>();
  const Decimal50 here = gtr1_distribution(MicrofacetNormal<Decimal50>{1, 0}, Decimal50(1));
  return told_integrals(claim, area, worst(std::array{judged(area), std::optional(verdict_of(is_limit))}),
                        Told{"at_one", here.convert_to<double>()}, Told{"beside", beside});
}

/// A distribution with the masking of a claim, at its roughnesses and views.
struct Masked {
  const Distribution& distribution;
  const Distribution& masking_by;
  Widths widths;
  std::vector<double> angles;

  Masked(std::string_view distribution_name, std::string_view masking_name, const Claim& claim)
      : distribution(distribution_of(distribution_name)),
        masking_by(masking_of(masking_name)),
        widths(claim),
        angles(parse_sweep(claim.inputs.at("view angles"))) {
    std::ranges::sort(angles);
  }
  /// G1 times the visible area over v.n, which should be 1.
  double ratio(const View& view, double alpha, double area) const {
    return masking(masking_by, view, alpha) * area / view.direction.cosine;
  }
};

/// G1 times the visible area over v.n at every roughness and view.
struct MaskingTable {
  std::vector<std::string> at_flattest_view = {};  ///< by roughness
  Furthest worst = {};                             ///< from 1
};

MaskingTable masking_table(const Masked& pair) {
  MaskingTable table;
  for (const double r : pair.widths.roughness) {
    const double alpha = pair.widths.alpha(r);
    double ratio = 0;
    for (const double degrees : pair.angles) {
      const View view(degrees);
      const TwoWays area = integrate_visible_area(pair.distribution, alpha, view, microfacet_tolerance);
      ratio = pair.ratio(view, alpha, area.value());
      consider(table.worst, {std::abs(ratio - 1), ratio, r, degrees, area.error() / area.value()});
    }
    table.at_flattest_view.push_back(decimal(ratio, 4));
  }
  return table;
}

Finding masked_by_its_own(const Claim& claim) {
  const Furthest worst =
      masking_table({claim.inputs.at("distribution"), claim.inputs.at("masking"), claim}).worst;
  return told_integrals(claim, worst, judged(worst));
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
std::string range_in_words(const Masked& pair, double allowed) {
  const auto& roughnesses = pair.widths.roughness;
  // |ratio - 1| by one rule
  const auto error_at = [&](double r, double degrees) {
    if (degrees == 0) return -allowed;  // along the normal nothing is masked
    const double alpha = pair.widths.alpha(r);
    const View view(degrees);
    const double area =
        integrate_visible_area_by_slope(pair.distribution, alpha, view, place_tolerance).value;
    return std::abs(pair.ratio(view, alpha, area) - 1) - allowed;
  };
  const auto at_roughness = [&](double r) {
    double most = -allowed;
    for (const double degrees : pair.angles) most = std::max(most, error_at(r, degrees));
    return most;
  };
  const auto at_view = [&](double degrees) {
    double most = -allowed;
    for (const double r : roughnesses) most = std::max(most, error_at(r, degrees));
    return most;
  };
  std::vector<double> views{0};
  views.insert(views.end(), pair.angles.begin(), pair.angles.end());
  const std::string by_view = fmt::format("up to {:.4g} degrees for all of these roughnesses",
                                          *holds_up_to(at_view, views));  // 0 at least
  const auto roughness = holds_up_to(at_roughness, roughnesses);
  return roughness
             ? fmt::format("within {:.4g} of 1 up to roughness {:.4g} for all of these views, and {}",
                           allowed, *roughness, by_view)
             : fmt::format(
                   "within {:.4g} of 1 {}; for some of these views it is not, already at roughness {:.4g}",
                   allowed, by_view, roughnesses.front());
}

/// One borrowed masking: its verdict, its largest error and the range in which it is good enough.
Finding loan(std::string_view distribution, const Claim& claim) {
  const std::string_view lender = claim.inputs.at(distribution);
  const Masked pair(distribution, lender, claim);
  const MaskingTable table = masking_table(pair);
  const Furthest& worst = table.worst;
  const double accurate = given(claim, "accurate");
  const Verdict verdict = worst.relative <= accurate ? Verdict::confirmed : Verdict::conditional;
  const std::string ratio = decimal(worst.integral, 4);
  return {
      worst.error <= promised ? std::optional(verdict) : std::nullopt,
      fmt::format("{} v.n ({})", ratio, distribution),
      fmt::format(
          "{} with the G1 of {} gives {} times v.n at these roughnesses, seen from {:.6g} degrees. The worst "
          "is {}, at roughness {:.6g} and {:.6g} degrees. The ratio is {}. For one 8-bit sRGB code as the limit, "
          "the ratio is {}",
          distribution, lender, enumerated(table.at_flattest_view), pair.angles.back(), ratio,
          worst.roughness, worst.view_angle, range_in_words(pair, accurate),
          range_in_words(pair, change_of_one_code())),
      effect_of_factor(
          worst.integral, 1,
          fmt::format("{} with F = 1, with masking but no shadowing, at roughness {:.6g} and {:.6g} degrees,",
                      distribution, worst.roughness, worst.view_angle))};
}

Finding masked_by_another(const Claim& claim) {
  const Finding blinn_phong = loan("blinn-phong", claim), gtr1 = loan("gtr1", claim);
  return told(claim, worst(std::array{blinn_phong.verdict, gtr1.verdict}),
              sentences({blinn_phong.effect, gtr1.effect}), Told{"widths", Widths(claim).words()},
              Told{"worst_of_blinn_phong", blinn_phong.computed}, Told{"worst_of_gtr1", gtr1.computed},
              Told{"of_blinn_phong", blinn_phong.evidence}, Told{"of_gtr1", gtr1.evidence});
}

}  // namespace

std::vector<Evaluator> microfacet_evaluators() {
  return {{"ndf-blinn-phong", normalised},
          {"ndf-beckmann", normalised},
          {"ndf-ggx", normalised},
          {"ndf-gtr1", gtr1_normalised},
          {"smith-beckmann", masked_by_its_own},
          {"smith-ggx", masked_by_its_own},
          {"smith-borrowed", masked_by_another}};
}

}  // namespace shadefit
