#include "approx/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "fit/claims/lobe_rule.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit {
namespace {

using LobeAngle = LobeRule::LobeAngle;
using Kernel = std::function<double(const LobeAngle& direction)>;

struct LobeCandidate {
  std::string_view name;
  double rms;
  double parameter;  ///< the fitted sharpness, in units of the exponent, so that all are of order 1
  Kernel kernel;
  double square() const { return rms * rms; }
};

/// Terms of the heat kernel for a relative truncation of at most e^-40 = 4e-18: last (last + 1) t >= 40,
/// where the weights have long begun to fall. The peak is at least its first terms, about 1/t.
int last_term(double t, double decay = 40) {
  return static_cast<int>(std::ceil((std::sqrt(1 + 4 * decay / t) - 1) / 2));
}

/// Of the heat kernel's width: near the peak it is exp(-theta^2/(4t)), a lobe exp(-k theta^2/2).
double time_of(double sharpness) {
  return 1 / (2 * sharpness);
}

/// Of the heat kernel of the sphere: its terms, and their sum, by which the peak is scaled to 1.
struct HeatSeries {
  std::vector<double> weights = {};
  double peak = 0;

  explicit HeatSeries(double t) {
    for (int l = 0; l <= last_term(t); ++l) weights.push_back(heat_weight(l, t));
    peak = std::accumulate(weights.rbegin(), weights.rend(), 0.0);  // the small ones first
  }
};

Kernel heat_kernel(double t) {
  return [series = HeatSeries(t)](const LobeAngle& direction) {
    return legendre_series(1 - direction.one_minus_cos, std::span<const double>(series.weights)) /
           series.peak;
  };
}

/// P_0(c) to P_last(c) at each node. They do not depend on the sharpness, and to compute them takes most of
/// the time of a series.
std::vector<std::vector<double>> polynomials_at_nodes(const LobeRule& rule, int last) {
  std::vector<std::vector<double>> rows;
  for (const auto& node : rule.nodes()) {
    const double c = 1 - node.direction.one_minus_cos;
    std::vector<double>& row = rows.emplace_back(std::vector{1.0, c});
    for (int l = 1; l < last; ++l) row.push_back(next_legendre(c, row.end()[-1], row.end()[-2], l));
  }
  return rows;
}

constexpr std::string_view spherical_gaussian = "the spherical Gaussian";
constexpr std::string_view printed_gauss = "the printed Gauss-Weierstrass";
constexpr std::string_view heat = "Gauss-Weierstrass on the sphere";

/// The kernel of that name in the record, with a sharpness `k`.
Kernel kernel_of(std::string_view name, double k, std::string_view reading) {
  if (name == spherical_gaussian)
    return [=](const LobeAngle& p) { return gaussian_lobe_near_peak(p.one_minus_cos, k, 0.0); };
  if (name == printed_gauss && reading == "angle")
    return [=](const LobeAngle& p) { return line_gaussian(p.angle, 1 / k); };
  if (name == printed_gauss && reading == "chord")  // from the axis to the direction
    return [=](const LobeAngle& p) { return line_gaussian(std::sqrt(2 * p.one_minus_cos), 1 / k); };
  if (name == "the printed Abel-Poisson")
    return [=](const LobeAngle& p) { return poisson_of_circle_lobe(p.one_minus_cos, k); };
  if (name == "Abel-Poisson on the sphere")
    return [=](const LobeAngle& p) { return poisson_of_sphere_lobe(p.one_minus_cos, k); };
  if (name == heat) return heat_kernel(time_of(k));
  throw std::invalid_argument(fmt::format("no kernel is {} of the {}", name, reading));
}

/// With the best parameter. In units of the exponent the best sharpness of every kernel lies well inside 1/4
/// to 8; beyond 2 the heat kernel would have more terms than any fit needs.
LobeCandidate candidate(const LobeRule& rule, std::string_view name, std::string_view reading) {
  const double sharpest = name == heat ? 2 : 8;
  const auto polynomials = name == heat
                               ? polynomials_at_nodes(rule, last_term(time_of(rule.exponent() * sharpest)))
                               : std::vector<std::vector<double>>();
  const auto values = [&](double sharpness) {
    std::vector<double> found;
    if (name == heat) {
      const HeatSeries series(time_of(rule.exponent() * sharpness));
      for (const auto& row : polynomials)
        found.push_back(std::inner_product(series.weights.begin(), series.weights.end(), row.begin(), 0.0) /
                        series.peak);
      return found;
    }
    const Kernel kernel = kernel_of(name, rule.exponent() * sharpness, reading);
    for (const auto& node : rule.nodes()) found.push_back(kernel(node.direction));
    return found;
  };
  const KernelFit fit = fit_kernel(rule, values, 0.25, sharpest);
  return {name, fit.rms, fit.parameter, kernel_of(name, rule.exponent() * fit.parameter, reading)};
}

/// Both rules have to give the integral of every squared error to this, relative.
constexpr double agreement_of_rules = 1e-6;

/// The candidates of an exponent, and the best.
struct KernelContest {
  double exponent;
  std::vector<LobeCandidate> candidates;
  /// The participant with the least squared error; of equal ones, to the tolerance of the rules, the first.
  template <class TakesPart>
  const LobeCandidate& winner_among(const TakesPart& takes_part) const {
    double least = std::numeric_limits<double>::infinity();
    for (const LobeCandidate& c : candidates) least = takes_part(c) ? std::min(least, c.square()) : least;
    return *std::ranges::find_if(candidates, [&](const LobeCandidate& c) {
      return takes_part(c) && c.square() <= least * (1 + agreement_of_rules);
    });
  }
  const LobeCandidate& winner() const {
    return winner_among([](const LobeCandidate&) { return true; });
  }
};

/// Whether the integrals are accurate enough to name the winner: both rules agree, and the difference to
/// every other kernel is larger than their errors, or negligible.
bool is_sure(const LobeRule& rule, const KernelContest& contest) {
  const double least = contest.winner().square();
  return std::ranges::all_of(contest.candidates, [&](const LobeCandidate& c) {
    const double other = rule.square_by_other_rule(c.kernel), more = c.square() / least - 1;
    return std::abs(other - c.square()) <= agreement_of_rules * other &&
           (more > 2 * agreement_of_rules || std::abs(more) < 1e-3 * agreement_of_rules);
  });
}

/// The instructions of one more term of the heat kernel's series.
int cost_of_a_term() {
  const auto series = [](int terms) {
    std::vector<Symbolic> weights;
    for (int l = 0; l < terms; ++l) weights.push_back(Symbolic::variable(fmt::format("w{}", l)));
    return count_operations(legendre_series(Symbolic::variable("c"), std::span<const Symbolic>(weights)));
  };
  return series(6).total() - series(5).total();
}

/// Terms of the heat kernel's series that leave at most one part in 255 of its peak; 0 if it takes no part.
int terms_to_see(const KernelContest& contest) {
  const auto candidate = std::ranges::find(contest.candidates, heat, &LobeCandidate::name);
  return candidate == contest.candidates.end()
             ? 0
             : last_term(time_of(contest.exponent * candidate->parameter), std::log(255.0)) + 1;
}

/// The errors side by side at the exponents to be shown.
std::string errors_in_words(const std::vector<KernelContest>& contests, const std::vector<double>& shown) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < contests.front().candidates.size(); ++i) {
    std::vector<std::string> numbers;
    for (const KernelContest& contest : contests) {
      if (std::ranges::count(shown, contest.exponent) > 0)
        numbers.push_back(decimal(contest.candidates[i].rms, 3));
    }
    lines.push_back(fmt::format("{} {}", contests.front().candidates[i].name, enumerated(numbers)));
  }
  return fmt::format("{}", fmt::join(lines, "; "));
}

/// The effect of a candidate instead of the lobe, at a thousand angles and both ends.
Effect effect_of(const LobeCandidate& candidate, double exponent) {
  constexpr int steps = 1000;
  Effect effect;
  for (int i = 0; i <= steps; ++i) {
    const LobeAngle direction = LobeRule::direction_at(i * pi<double>() / (2 * steps));
    effect.show(power_lobe_near_peak(direction.one_minus_cos, exponent), candidate.kernel(direction),
                at_cosine({1 - direction.one_minus_cos, direction.one_minus_cos}));
  }
  return effect;
}

/// "that of the printed Gauss-Weierstrass at all of them", one part for each winner.
std::string winners_in_words(const std::vector<KernelContest>& contests) {
  std::vector<std::string> words;
  for (const LobeCandidate& candidate : contests.front().candidates) {
    std::vector<std::string> won;
    for (const KernelContest& contest : contests) {
      if (contest.winner().name == candidate.name) won.push_back(decimal(contest.exponent, 6));
    }
    if (won.empty()) continue;
    words.push_back(fmt::format("that of {} at {}", candidate.name,
                                won.size() == contests.size() ? "all of them" : enumerated(won)));
  }
  return enumerated(words);
}

/// The number of exponents at which the Spherical Gaussian has the smallest error of the kernels that need
/// only the cosine: neither the angle itself nor a series.
long wins_of_the_cosine(const std::vector<KernelContest>& contests, std::string_view reading) {
  const auto takes_part = [&](const LobeCandidate& c) {
    return c.name != heat && (c.name != printed_gauss || reading != "angle");
  };
  return std::ranges::count_if(contests, [&](const KernelContest& contest) {
    return contest.winner_among(takes_part).name == spherical_gaussian;
  });
}

Finding other_kernels(const Claim& claim) {
  const std::string_view reading = claim.inputs.at("x");
  const std::vector<std::string> names = items_of(claim.inputs.at("kernels"));
  std::vector<KernelContest> contests;
  bool is_known = true;
  for (const double k : parse_sweep(claim.inputs.at("exponents"))) {
    const LobeRule rule(k);
    contests.push_back({k, {candidate(rule, spherical_gaussian, reading)}});
    for (const std::string& name : names)
      contests.back().candidates.push_back(candidate(rule, name, reading));
    is_known = is_known && is_sure(rule, contests.back());
  }
  const auto won = std::ranges::count_if(
      contests, [](const KernelContest& c) { return c.winner().name == spherical_gaussian; });
  const KernelContest &first = contests.front(), &last = contests.back();
  const auto variable = [](const char* of) { return Symbolic::variable(of); };
  const auto cost_of = [](const Symbolic& form) { return to_text(count_operations(form)); };
  const Symbolic c = variable("c"), s = variable("s"), y = integer<Symbolic>(1) - c;
  return told(
      claim,
      is_known ? std::optional(verdict_of_cases(static_cast<std::size_t>(won), contests.size()))
               : std::nullopt,
      sentences({sentence(effect_of(first.candidates[0], first.exponent), "the lobe",
                          fmt::format("at k = {:.6g} {}", first.exponent, spherical_gaussian)),
                 first.winner().name == spherical_gaussian
                     ? "none"
                     : sentence(effect_of(first.winner(), first.exponent), "it", first.winner().name)}),
      Told{"won", won}, Told{"winners", winners_in_words(contests)},
      Told{"wins", wins_of_the_cosine(contests, reading)},
      Told{"errors", errors_in_words(contests, parse_sweep(claim.inputs.at("shown")))},
      Told{"rival", last.candidates.at(1).name},
      Told{"ratio", last.candidates.at(1).rms / last.candidates[0].rms},
      Told{"limit", gaussian_error_ratio<double>()},
      Told{"gaussian_cost", cost_of(gaussian_lobe(c, variable("k"), variable("x")))},
      Told{"angle_cost", cost_of(line_gaussian(variable("theta"), s))},
      Told{"circle_cost", cost_of(poisson_of_circle_lobe(y, s))},
      Told{"sphere_cost", cost_of(poisson_of_sphere_lobe(y, s))}, Told{"term_cost", cost_of_a_term()},
      Told{"first_terms", terms_to_see(first)}, Told{"last_terms", terms_to_see(last)},
      Told{"agreement", agreement_of_rules});
}

}  // namespace

std::vector<Evaluator> kernels_evaluators() {
  return {{"other-kernels", other_kernels}};
}

}  // namespace shadefit
