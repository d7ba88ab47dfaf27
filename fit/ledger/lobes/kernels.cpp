#include "approx/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "fit/ledger/lobes/lobe_rule.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

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

/// The heat kernel of the sphere, its peak scaled to 1.
Kernel heat_kernel(double t) {
  std::vector<double> weights;
  for (int l = 0; l <= last_term(t); ++l) weights.push_back(heat_weight(l, t));
  const double peak = std::accumulate(weights.rbegin(), weights.rend(), 0.0);  // the small ones first
  return [weights = std::move(weights), peak](const LobeAngle& direction) {
    return legendre_series(1 - direction.one_minus_cos, std::span<const double>(weights)) / peak;
  };
}

constexpr std::string_view spherical_gaussian = "the spherical Gaussian";
constexpr std::string_view printed_gauss = "the printed Gauss-Weierstrass";
constexpr std::string_view heat = "Gauss-Weierstrass on the sphere";

/// The squared quantity of the printed Gaussian: the angle, or the chord from the axis to the direction.
double abscissa(std::string_view reading, const LobeAngle& direction) {
  if (reading == "angle") return direction.angle;
  if (reading == "chord") return std::sqrt(2 * direction.one_minus_cos);
  throw std::invalid_argument(fmt::format("x is read as angle or chord, not as {}", reading));
}

/// The kernel of that name in the record, with a sharpness `k`.
Kernel kernel_of(std::string_view name, double k, std::string_view reading) {
  if (name == spherical_gaussian)
    return [=](const LobeAngle& p) { return gaussian_lobe_near_peak(p.one_minus_cos, k, 0.0); };
  if (name == printed_gauss)
    return [=](const LobeAngle& p) { return line_gaussian(abscissa(reading, p), 1 / k); };
  if (name == "the printed Abel-Poisson")
    return [=](const LobeAngle& p) { return poisson_of_circle_lobe(p.one_minus_cos, k); };
  if (name == "Abel-Poisson on the sphere")
    return [=](const LobeAngle& p) { return poisson_of_sphere_lobe(p.one_minus_cos, k); };
  if (name == heat) return heat_kernel(time_of(k));
  throw std::invalid_argument(fmt::format("no kernel is called {}", name));
}

/// With the best parameter. In units of the exponent the best sharpness of every kernel lies well inside 1/4
/// to 8; beyond 2 the heat kernel would have more terms than any fit needs.
LobeCandidate candidate(const LobeRule& rule, std::string_view name, std::string_view reading) {
  const auto values = [&](double sharpness) {
    const Kernel kernel = kernel_of(name, rule.exponent() * sharpness, reading);
    std::vector<double> found;
    for (const auto& node : rule.nodes()) found.push_back(kernel(node.direction));
    return found;
  };
  const KernelFit fit = fit_kernel(rule, values, 0.25, name == heat ? 2 : 8);
  return {name, fit.rms, fit.parameter, kernel_of(name, rule.exponent() * fit.parameter, reading)};
}

/// Both rules have to give the integral of every squared error to this, relative.
constexpr double agreement_of_rules = 1e-6;

bool rules_agree(const LobeRule& rule, const std::vector<LobeCandidate>& all) {
  return std::ranges::all_of(all, [&](const LobeCandidate& c) {
    const double other = rule.square_by_other_rule(c.kernel);
    return std::abs(other - c.square()) <= agreement_of_rules * other;
  });
}

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
  /// That kernel with its best parameter, or null if it does not take part.
  const LobeCandidate* find(std::string_view name) const {
    const auto found = std::ranges::find(candidates, name, &LobeCandidate::name);
    return found == candidates.end() ? nullptr : &*found;
  }
};

/// Whether the integrals are accurate enough to name the winner: the difference to every other kernel is
/// larger than the errors of the rules, or negligible.
bool is_sure(const LobeRule& rule, const KernelContest& contest) {
  const double least = contest.winner().square();
  return rules_agree(rule, contest.candidates) &&
         std::ranges::all_of(contest.candidates, [&](const LobeCandidate& c) {
           const double more = c.square() / least - 1;
           return more > 2 * agreement_of_rules || std::abs(more) < 1e-3 * agreement_of_rules;
         });
}

/// "3, 4 and 5" the exponents at which that kernel wins; empty if it never does.
std::string exponents_won(const std::vector<KernelContest>& contests, std::string_view name) {
  std::vector<std::string> words;
  for (const KernelContest& contest : contests) {
    if (contest.winner().name == name) words.push_back(decimal(contest.exponent, 6));
  }
  return words.size() == contests.size() ? "all of them" : enumerated(words);
}

/// The instructions of a shader, counted from the formulas; c and the parameters are given.
std::string costs() {
  const auto variable = [](const char* name) { return Symbolic::variable(name); };
  const Symbolic c = variable("c"), s = variable("s"), y = integer<Symbolic>(1) - c;
  const auto words = [](const Symbolic& e) { return to_text(count_operations(e)); };
  const auto series = [&](int terms) {
    std::vector<Symbolic> weights;
    for (int l = 0; l < terms; ++l) weights.push_back(Symbolic::variable(fmt::format("w{}", l)));
    return count_operations(legendre_series(c, std::span<const Symbolic>(weights))).total();
  };
  return fmt::format(
      "for the spherical Gaussian {}; for the Gaussian of the angle an arc cosine and {}; for Abel-Poisson as "
      "printed {}; for Abel-Poisson on the sphere {} (a square root); for Gauss-Weierstrass on the sphere {} "
      "instructions per term of its series",
      words(gaussian_lobe(c, variable("k"), variable("x"))), words(line_gaussian(variable("theta"), s)),
      words(poisson_of_circle_lobe(y, s)), words(poisson_of_sphere_lobe(y, s)), series(6) - series(5));
}

/// Terms of the heat kernel's series that leave at most one part in 255 of its peak.
std::string terms_to_see(const KernelContest& contest) {
  const LobeCandidate* candidate = contest.find(heat);
  if (candidate == nullptr) return "none asked";
  const int last = last_term(time_of(contest.exponent * candidate->parameter), std::log(255.0));
  return fmt::format("{} at k = {:.6g}", last + 1, contest.exponent);
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

/// "the printed Gauss-Weierstrass at all of them", one part for each winner.
std::string winners_in_words(const std::vector<KernelContest>& contests) {
  std::vector<std::string> words;
  for (const LobeCandidate& candidate : contests.front().candidates) {
    const std::string at = exponents_won(contests, candidate.name);
    if (!at.empty()) words.push_back(fmt::format("that of {} at {}", candidate.name, at));
  }
  return enumerated(words);
}

/// Whether a kernel needs more than the cosine in closed form: the angle itself, or a series.
bool needs_more_than_the_cosine(std::string_view name, std::string_view reading) {
  return name == heat || (name == printed_gauss && reading == "angle");
}

/// The number of exponents at which the Spherical Gaussian has the smallest error of the kernels that need
/// only the cosine.
long wins_of_the_cosine(const std::vector<KernelContest>& contests, std::string_view reading) {
  const auto takes_part = [&](const LobeCandidate& c) {
    return !needs_more_than_the_cosine(c.name, reading);
  };
  return std::ranges::count_if(contests, [&](const KernelContest& contest) {
    return contest.winner_among(takes_part).name == spherical_gaussian;
  });
}

/// The error of the first rival relative to the Spherical Gaussian's, at the last exponent.
std::string ratio_in_words(const KernelContest& last, std::string_view reading) {
  const LobeCandidate& rival = last.candidates.at(1);
  std::string text =
      fmt::format("the error of {} is {:.4g} times that of the spherical Gaussian at k = {:.6g}", rival.name,
                  rival.rms / last.candidates[0].rms, last.exponent);
  if (rival.name == printed_gauss && reading == "angle")
    text += fmt::format(" and {:.4g} in the limit", gaussian_error_ratio<double>());
  return text;
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
  const auto of = std::ssize(contests);
  const KernelContest &first = contests.front(), &last = contests.back();
  return {
      is_known ? std::optional(verdict_of_cases(static_cast<std::size_t>(won), contests.size()))
               : std::nullopt,
      fmt::format("smallest at {} of {}", won, counted(of, "exponent")),
      told(claim, Told{"exponents_tried", counted(of, "exponent")},
           Told{"winners", winners_in_words(contests)}, Told{"wins", wins_of_the_cosine(contests, reading)},
           Told{"errors", errors_in_words(contests, parse_sweep(claim.inputs.at("shown")))},
           Told{"ratio", ratio_in_words(last, reading)}, Told{"costs", costs()},
           Told{"first_terms", terms_to_see(first)}, Told{"last_terms", terms_to_see(last)},
           Told{"agreement", agreement_of_rules}),
      sentences({sentence(effect_of(first.candidates[0], first.exponent), "the lobe",
                          fmt::format("at k = {:.6g} {}", first.exponent, spherical_gaussian)),
                 first.winner().name == spherical_gaussian
                     ? "none"
                     : sentence(effect_of(first.winner(), first.exponent), "it", first.winner().name)})};
}

}  // namespace

std::vector<Evaluator> kernels_evaluators() {
  return {{"other-kernels", other_kernels}};
}

}  // namespace shadefit
