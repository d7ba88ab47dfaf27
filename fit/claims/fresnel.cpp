#include "approx/fresnel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fit/catalogue/family.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit {
namespace {

/// The unrounded optimum of a Fresnel family under the cosine measure.
std::vector<double> optimum(std::string_view family) {
  return find_family(family)->fit({}, {}).parameters;
}

auto one_term(double sharpness) {
  return [=]<class T>(const T& c) { return fresnel_one_term(c, lift<T>(sharpness)); };
}

/// (F of a form - F of (1-c)^5) / (F of (1-c)^5).
template <class Form>
auto relative_error(const Form& form, double f0) {
  return [=]<class T>(const T& c) {
    const T target = schlick_reflectance(lift<T>(f0), schlick_weight(c));
    return T((schlick_reflectance(lift<T>(f0), T(form(c))) - target) / target);
  };
}

template <class F>
Extremum largest_over_cosine(const F& f) {
  return largest_magnitude([&](const auto& c) { return f(c.cos_theta); }, Substitution({}, {}));
}

/// "from c = 0.5 to 1": where one error exceeds another.
template <class F>
std::string where_closer(const F& excess) {
  std::vector<double> places = search_points();
  places.insert(places.begin(), 0);
  places.push_back(1);
  return ranges_in_words(where_positive(excess, places, 50), 4);
}

/// The largest difference of F from that of (1-c)^5, in 8-bit sRGB codes.
template <class Form>
double largest_code_shift(const Form& form, double f0) {
  return largest_sampled([&](double c) {
    return std::abs(srgb_code(schlick_reflectance(f0, form(c))) -
                    srgb_code(schlick_reflectance(f0, schlick_weight(c))));
  });
}

/// The effect of a form instead of (1-c)^5 on F.
template <class Form>
Effect effect_on_reflectance(const Form& form, double f0) {
  const auto reflectance = [f0](const auto& weight) {
    return [f0, &weight]<class T>(const Cosine<T>& c) {
      return T(schlick_reflectance(lift<T>(f0), T(weight(c.cos_theta))));
    };
  };
  const auto exact = []<class T>(const T& c) { return schlick_weight(c); };
  return effect_between(reflectance(exact), reflectance(form), Substitution({}, {}));
}

/// The effect of a weight at normal incidence, where it should be 0.
std::string effect_at_normal(double weight, double f0) {
  return effect_of_value(f0, schlick_reflectance(f0, weight), at_cosine({1, 0}),
                         fmt::format("F of f0 = {:.3g}", f0), "at normal incidence it");
}

/// The closed form; the fit is judged beside it.
Finding sharpness_of_offset(const Claim& claim) {
  const double closed = one_term_sharpness(given(claim, "x"));
  const Verdict verdict = judge(claim.printed[0].value, {"", closed}, {}).verdict;
  return told(claim, verdict, "none", Told{"closed", closed}, Told{"verdict", name(verdict)});
}

Finding one_term_at_one(const Claim& claim) {
  const double value = fresnel_one_term(1.0, given(claim, "A"));
  return told(claim, judge(claim.printed[0].value, {"", value}, {}).verdict,
              effect_at_normal(value, given(claim, "f0")), Told{"best", optimum("fresnel-one-term")[0]});
}

Finding quadratic_at_one(const Claim& claim) {
  const double value = fresnel_quadratic(1.0, given(claim, "a"), given(claim, "b"));
  const double ratio = fresnel_one_term(1.0, given(claim, "A")) / value;
  const auto pair = optimum("fresnel-quadratic");
  const double best = fresnel_quadratic(1.0, pair[0], pair[1]);
  const double best_ratio = fresnel_one_term(1.0, optimum("fresnel-one-term")[0]) / best;
  const double of_printed = given(claim, "exp2(-A) as printed") / number_of(claim.printed[0].value);
  const std::array parts{judge(claim.printed[0].value, {"", value}, {}).verdict,
                         judge(claim.printed[1].value, {"", ratio}, {}).verdict};
  return told(claim, worst(parts), effect_at_normal(value, given(claim, "f0")), Told{"found", value},
              Told{"found_ratio", ratio}, Told{"verdict", name(parts[0])},
              Told{"ratio_verdict", name(parts[1])}, Told{"best", best}, Told{"best_ratio", best_ratio},
              Told{"of_printed", of_printed});
}

/// The absolute bound on the difference of both rules and on their estimates, for the integrals below.
constexpr double rms_tolerance = 1e-10;

/// The errors of a form against (1-c)^5 for each meaning of "worse": the rms under each measure, the largest,
/// and the largest relative one of F.
struct Distance {
  std::vector<double> readings = {};
  double uncertainty = 0;  ///< of the rms values, absolute: both rules' estimates and their difference
  std::string words = {};
};

/// sqrt(integral of w e^2 / integral of w) over the angle, where w is the weight of the measure, by one of
/// the two rules.
template <class Error>
std::array<double, 2> rms_and_error(const Error& error, Measure measure) {
  const auto weight = [&](double theta) {
    if (measure == Measure::angle) return 1.0;
    return measure == Measure::cosine ? std::sin(theta) : std::sin(theta) * std::cos(theta);
  };
  const auto square = [&](double theta) {
    const double e = error(std::cos(theta));
    return weight(theta) * e * e;
  };
  const double end = pi<double>() / 2;
  const Integral integral = by_two_rules(square, 0, end, 1e-12);
  const double total = gauss_kronrod(weight, 0, end, 1e-12).value;
  const double rms = std::sqrt(integral.value / total), doubt = integral.error / total;
  // d sqrt(I) = dI / (2 sqrt(I)); if the error is only rounding, so is the estimate
  return {rms, rms > 0 ? doubt / (2 * rms) : std::sqrt(doubt)};
}

template <class Form>
Distance distance_from_schlick(const Form& form, double f0) {
  const auto error = [&]<class T>(const T& c) { return T(T(form(c)) - schlick_weight(c)); };
  Distance distance;
  std::vector<std::string> words;
  for (const Measure measure : measures) {
    const auto [rms, doubt] = rms_and_error(error, measure);
    distance.readings.push_back(rms);
    distance.uncertainty = std::max(distance.uncertainty, doubt);
    words.push_back(fmt::format("rms {:.4g} ({})", rms, name(measure)));
  }
  const auto add = [&](const Extremum& largest, std::string_view of) {
    distance.readings.push_back(largest.magnitude);
    words.push_back(
        fmt::format("at most {:.4g}{} (c = {:.4g})", largest.magnitude, of, largest.at.cos_theta));
  };
  add(largest_over_cosine(error), "");
  add(largest_over_cosine(relative_error(form, f0)), " of F");
  distance.words = enumerated(words);
  return distance;
}

/// In how many readings `one` is further away than `other`.
std::size_t readings_worse(const Distance& one, const Distance& other) {
  std::size_t worse = 0;
  for (std::size_t i = 0; i < one.readings.size(); ++i) worse += one.readings[i] > other.readings[i] ? 1 : 0;
  return worse;
}

/// Whether `one` is further away; empty where the integrals are not accurate enough to compare.
std::optional<Verdict> verdict_of_comparison(const Distance& one, const Distance& other) {
  const bool is_sure = std::ranges::equal(one.readings, other.readings, [](double a, double b) {
    return a == b || std::abs(a - b) > 2 * rms_tolerance;
  });
  if (!is_sure || std::max(one.uncertainty, other.uncertainty) > rms_tolerance) return std::nullopt;
  const std::size_t worse = readings_worse(one, other);
  if (worse == one.readings.size()) return Verdict::confirmed;
  if (one.readings.front() > other.readings.front()) return Verdict::conditional;
  return worse > 0 ? Verdict::other_objective : Verdict::refuted;
}

Finding power_four(const Claim& claim) {
  const int n = static_cast<int>(std::lround(given(claim, "power")));
  const double f0 = given(claim, "f0");
  const auto power_form = [=]<class T>(const T& c) { return grazing_power(c, n); };
  const auto gaussian = one_term(given(claim, "A"));
  const Distance of_power = distance_from_schlick(power_form, f0);
  const Distance of_gaussian = distance_from_schlick(gaussian, f0);
  const auto closer = where_closer([&](double c) {
    const double target = schlick_weight(c);
    return std::abs(gaussian(c) - target) - std::abs(power_form(c) - target);
  });
  return told(claim, verdict_of_comparison(of_power, of_gaussian),
              sentences({sentence(effect_on_reflectance(power_form, f0), fmt::format("F of f0 = {:.3g}", f0),
                                  fmt::format("(1-c)^{}", n)),
                         sentence(effect_on_reflectance(gaussian, f0), "it", "exp2(-A c)")}),
              Told{"worse", readings_worse(of_power, of_gaussian)},
              Told{"readings", of_power.readings.size()}, Told{"of_power", of_power.words},
              Told{"of_gaussian", of_gaussian.words}, Told{"tolerance", rms_tolerance},
              Told{"closer", closer});
}

Finding relative_errors(const Claim& claim) {
  const double f0 = given(claim, "f0");
  const auto pair = [a = given(claim, "a"), b = given(claim, "b")]<class T>(const T& c) {
    return fresnel_quadratic(c, lift<T>(a), lift<T>(b));
  };
  const auto single = one_term(given(claim, "A"));
  const auto of_pair = relative_error(pair, f0);
  const auto of_single = relative_error(single, f0);
  const Extremum small = largest_over_cosine(of_pair), large = largest_over_cosine(of_single);
  const double ratio = small.magnitude / large.magnitude;
  const double small_codes = largest_code_shift(pair, f0), large_codes = largest_code_shift(single, f0);
  const auto closer = where_closer([&](double c) { return std::abs(of_pair(c)) - std::abs(of_single(c)); });
  return told(claim, verdict_of(ratio <= given(claim, "far smaller")),
              sentences({sentence(effect_on_reflectance(single, f0), fmt::format("F of f0 = {:.3g}", f0),
                                  "exp2(-A c)"),
                         sentence(effect_on_reflectance(pair, f0), "it", "the pair (a, b)")}),
              Told{"ratio", ratio}, Told{"pair", small.magnitude}, Told{"pair_at", small.at.cos_theta},
              Told{"single", large.magnitude}, Told{"single_at", large.at.cos_theta}, Told{"closer", closer},
              Told{"pair_codes", small_codes}, Told{"single_codes", large_codes},
              Told{"within", small_codes > 1 && large_codes > 1 ? "neither" : "at least one of them"});
}

Finding exponent_sum(const Claim& claim) {
  const double sum = fresnel_quadratic_exponent(1.0, given(claim, "a"), given(claim, "b"));
  const auto pair = optimum("fresnel-quadratic");
  const double best = fresnel_quadratic_exponent(1.0, pair[0], pair[1]);
  const std::string_view printed = claim.printed[0].value;
  return told(claim, judge(printed, {"", sum}, {}).verdict, "none", Told{"sum", sum}, Told{"best", best},
              Told{"verdict", name(judge(printed, {"", best}, {}).verdict)});
}

/// In half arithmetic, how many pairs of f0 and g have F above max(g, f0) at c = 0, where the weight is 1,
/// and the largest excess in ulps.
std::pair<int, double> excess_in_half(int steps) {
  int pairs = 0;
  double ulps = 0;
  const auto grey = [&](int i) { return round_to_half(static_cast<double>(i) / steps); };
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const Eigen::half f0 = grey(i), gloss = grey(j), top = max(gloss, f0);
      const double above =
          widened(schlick_reflectance_of_gloss(f0, gloss, integer<Eigen::half>(1))) - widened(top);
      pairs += above > 0 ? 1 : 0;
      ulps = std::max(ulps, above / ulp_of_half(widened(top)));
    }
  }
  return {pairs, ulps};
}

Finding roughness_range(const Claim& claim) {
  const int steps = static_cast<int>(std::lround(given(claim, "steps")));
  const double highest = schlick_weight(given(claim, "from")), lowest = schlick_weight(given(claim, "to"));
  double outside = 0;  // the distance of F from its range
  int pairs = 0, flat = 0;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j, ++pairs) {
      const double f0 = static_cast<double>(i) / steps, gloss = static_cast<double>(j) / steps;
      flat += j <= i ? 1 : 0;
      for (const double weight : {lowest, highest}) {
        const double f = schlick_reflectance_of_gloss(f0, gloss, weight);
        outside = std::max({outside, f0 - f, f - max(gloss, f0)});
      }
    }
  }
  // Three operations on numbers of at most 1, each rounded by at most half an epsilon.
  const double rounding = 1.5 * std::numeric_limits<double>::epsilon();
  const auto [half_pairs, half_ulps] = excess_in_half(steps);
  return told(claim, verdict_of(outside <= rounding), "none", Told{"pairs", pairs},
              Told{"stays", outside <= rounding ? "stays within" : fmt::format("leaves by {:.4g}", outside)},
              Told{"rounding", rounding}, Told{"flat", flat}, Told{"half_pairs", half_pairs},
              Told{"half_ulps", half_ulps});
}

}  // namespace

std::vector<Evaluator> fresnel_evaluators() {
  return {{"fresnel-one-term", sharpness_of_offset},    {"fresnel-one-term-at-1", one_term_at_one},
          {"fresnel-quadratic-at-1", quadratic_at_one}, {"fresnel-power-four", power_four},
          {"fresnel-relative-error", relative_errors},  {"fresnel-exponent-sum", exponent_sum},
          {"fresnel-roughness", roughness_range}};
}

}  // namespace shadefit
