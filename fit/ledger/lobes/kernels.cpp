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
#include "fit/ledger/topics.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// A kernel as a function of the direction; `sharpness` is in units of the exponent, so that all are of
/// order 1.
using LobeAngle = LobeRule::LobeAngle;
using Kernel = std::function<double(const LobeAngle& direction, double sharpness)>;

struct LobeCandidate {
  std::string_view name;
  double rms;
  double parameter;  ///< the fitted sharpness
  Kernel kernel;
  double square() const { return rms * rms; }
};

/// Terms of the heat kernel for a relative truncation of at most e^-40 = 4e-18: last (last + 1) t >= 40,
/// where the weights have long begun to fall. The peak is at least its first terms, about 1/t.
int last_term(double t, double decay = 40) {
  return static_cast<int>(std::ceil((std::sqrt(1 + 4 * decay / t) - 1) / 2));
}

std::vector<double> heat_weights(double t) {
  std::vector<double> weights;
  for (int l = 0; l <= last_term(t); ++l) weights.push_back(heat_weight(l, t));
  return weights;
}

double sum_of(const std::vector<double>& terms) {
  return std::accumulate(terms.rbegin(), terms.rend(), 0.0);  // the small ones first
}

/// Of the heat kernel's width: near the peak it is exp(-theta^2/(4t)), the lobe exp(-k theta^2/2).
double time_of(double sharpness, double exponent) {
  return 1 / (2 * exponent * sharpness);
}

/// The heat kernel at the nodes of a rule: the polynomials do not depend on the parameter, and are computed
/// once.
class HeatValues {
 public:
  HeatValues(const LobeRule& rule, double largest_sharpness) : exponent_(rule.exponent()) {
    const int last = last_term(time_of(largest_sharpness, exponent_));
    std::vector<double> cosines, before, current;
    for (const auto& node : rule.nodes()) cosines.push_back(1 - node.direction.one_minus_cos);
    before.assign(cosines.size(), 1.0);
    current = cosines;
    polynomials_ = {before, current};
    for (int l = 1; l < last; ++l) {
      std::vector<double> next(cosines.size());
      for (std::size_t i = 0; i < next.size(); ++i)
        next[i] = next_legendre(cosines[i], current[i], before[i], l);
      before = std::move(current);
      current = next;
      polynomials_.push_back(std::move(next));
    }
  }

  std::vector<double> operator()(double sharpness) const {
    const std::vector<double> weights = heat_weights(time_of(sharpness, exponent_));
    const double peak = sum_of(weights);
    std::vector<double> values(polynomials_[0].size(), 0.0);
    for (std::size_t l = 0; l < weights.size(); ++l) {
      const double weight = weights[l] / peak;
      for (std::size_t i = 0; i < values.size(); ++i) values[i] += weight * polynomials_[l][i];
    }
    return values;
  }

 private:
  double exponent_;
  std::vector<std::vector<double>> polynomials_;
};

/// The heat kernel at one angle, for the other rule and for the effect.
Kernel heat_kernel(double exponent, double sharpness) {
  std::vector<double> weights = heat_weights(time_of(sharpness, exponent));
  const double peak = sum_of(weights);
  return [weights = std::move(weights), peak](const LobeAngle& direction, double) {
    return legendre_series(1 - direction.one_minus_cos, std::span<const double>(weights)) / peak;
  };
}

/// The range of fitted sharpnesses, in units of the exponent: the best of all kernels lie well inside.
constexpr double least_sharpness = 0.25, largest_sharpness = 8;

LobeCandidate fit_candidate(const LobeRule& rule, std::string_view name, const Kernel& kernel) {
  const auto fit = fit_kernel(
      rule,
      [&](double sharpness) {
        std::vector<double> values;
        values.reserve(rule.nodes().size());
        for (const auto& node : rule.nodes()) values.push_back(kernel(node.direction, sharpness));
        return values;
      },
      least_sharpness, largest_sharpness);
  return {name, fit.rms, fit.parameter, kernel};
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

/// The formula of a kernel of the record; not for the heat kernel, which is a series.
Kernel kernel_of(std::string_view name, double k, std::string_view reading) {
  if (name == spherical_gaussian)
    return [=](const LobeAngle& p, double s) { return gaussian_lobe_near_peak(p.one_minus_cos, k * s, 0.0); };
  if (name == printed_gauss)
    return [=](const LobeAngle& p, double s) { return line_gaussian(abscissa(reading, p), 1 / (k * s)); };
  if (name == "the printed Abel-Poisson")
    return [=](const LobeAngle& p, double s) { return poisson_of_circle_lobe(p.one_minus_cos, k * s); };
  if (name == "Abel-Poisson on the sphere")
    return [=](const LobeAngle& p, double s) { return poisson_of_sphere_lobe(p.one_minus_cos, k * s); };
  throw std::invalid_argument(fmt::format("no kernel is called {}", name));
}

LobeCandidate candidate(const LobeRule& rule, std::string_view name, std::string_view reading) {
  if (name != heat) return fit_candidate(rule, name, kernel_of(name, rule.exponent(), reading));
  // Beyond twice the lobe's own sharpness there would be more terms than any fit needs.
  constexpr double sharpest = 2;
  const auto fit = fit_kernel(rule, HeatValues(rule, sharpest), least_sharpness, sharpest);
  return {name, fit.rms, fit.parameter, heat_kernel(rule.exponent(), fit.parameter)};
}

/// Each with its best parameter; the Spherical Gaussian first.
std::vector<LobeCandidate> candidates(const LobeRule& rule, std::string_view names,
                                      std::string_view reading) {
  std::vector<LobeCandidate> all{candidate(rule, spherical_gaussian, reading)};
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t comma = std::min(names.find(',', at), names.size());
    all.push_back(candidate(rule, names.substr(at, comma - at), reading));
    at = comma + 1;
  }
  return all;
}

/// Both rules have to give the integral of every squared error to this, relative.
constexpr double agreement_of_rules = 1e-6;

bool rules_agree(const LobeRule& rule, const std::vector<LobeCandidate>& all) {
  return std::ranges::all_of(all, [&](const LobeCandidate& c) {
    const double other = rule.square_by_other_rule(
        [&](const LobeAngle& direction) { return c.kernel(direction, c.parameter); });
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
  const int last = last_term(time_of(candidate->parameter, contest.exponent), std::log(255.0));
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
    effect.show(power_lobe_near_peak(direction.one_minus_cos, exponent),
                candidate.kernel(direction, candidate.parameter),
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
  const std::string_view reading = claim.inputs.at("x"), names = claim.inputs.at("kernels");
  std::vector<KernelContest> contests;
  bool is_known = true;
  for (const double k : parse_sweep(claim.inputs.at("exponents"))) {
    const LobeRule rule(k);
    contests.push_back({k, candidates(rule, names, reading)});
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
      fmt::format(
          "{} from {:.6g} to {:.6g} were tried, with x read as the {}; the smallest rms error is {}. Among the "
          "kernels that need neither the angle nor a series, it is that of {} at {} of them. The rms errors "
          "at k "
          "= {} are: {}. As a ratio, {}. The instructions in a shader are: {}. The series needs this many "
          "terms "
          "for an error within 1/255: {}, {}. Two quadrature rules agree on the squared errors to {:.1g}, "
          "relative",
          counted(of, "exponent"), first.exponent, last.exponent, reading, winners_in_words(contests),
          spherical_gaussian, wins_of_the_cosine(contests, reading), claim.inputs.at("shown"),
          errors_in_words(contests, parse_sweep(claim.inputs.at("shown"))), ratio_in_words(last, reading),
          costs(), terms_to_see(first), terms_to_see(last), agreement_of_rules),
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
