#include "fit/verdicts/refit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "fit/catalogue/family.hpp"
#include "fit/support/root.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

constexpr std::array<double, 4> exponents_of_a_limit{1e4, 1e5, 1e6, 1e7};

std::optional<double> fitted(FitCache& fits, double exponent, const Metric& metric, std::size_t parameter) {
  const Fit& fit = fits.at(exponent, metric);
  return fit.status == Status::converged ? std::optional(fit.parameters[parameter]) : std::nullopt;
}

/// The largest effect over the exponents of the published number; other parameters stay as fitted. Numbers
/// that agree to the ten digits of a report have no effect: their difference is rounding.
Effect effect_of_replacing(FitCache& fits, const Published& published, const Metric& metric,
                           double computed) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  Effect worst;
  if (std::abs(constant<double>(published.printed) - computed) < 1e-10 * std::abs(computed)) return worst;
  const bool has_exponent = fits.family().has_exponent();
  for (const double exponent : exponents_of(published)) {
    auto from = fits.at(exponent, metric).parameters, to = from;
    from[parameter] = constant<double>(published.printed);
    to[parameter] = computed;
    worst.include(fits.family().effect(exponent, metric.domain, from, to),
                  has_exponent ? Coordinate{"k = ", exponent} : Coordinate{});
  }
  return worst;
}

bool is_meant_for(const Published& published, const Fit& fit) {
  return published.family == fit.family->id && published.statement == Statement::best_fit &&
         (!fit.exponent || exponents_of(published) == std::vector<double>{*fit.exponent});
}

}  // namespace

std::vector<const Published*> numbers_of(const Family& family) {
  std::vector<const Published*> numbers;
  for (const Published& published : published_constants()) {
    if (published.family == family.id) numbers.push_back(&published);
  }
  return numbers;
}

const Fit& FitCache::at(double exponent, const Metric& metric) {
  const auto key = std::pair(metric, exponent);
  const auto found = fits_.find(key);
  return found != fits_.end() ? found->second : fits_.emplace(key, fitter_(exponent, metric)).first->second;
}

FitCache& Fits::of(const Family& family) {
  return caches_.try_emplace(&family, family).first->second;
}

std::optional<double> computed_value(FitCache& fits, const Published& published, const Metric& metric) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  if (published.statement == Statement::limit_of_fits) {
    const auto law = extrapolate(fits, metric, parameter);
    return law ? std::optional(law->limit) : std::nullopt;
  }
  const auto exponents = exponents_of(published);
  double sum = 0;
  for (const double exponent : exponents) {
    const auto value = fitted(fits, exponent, metric, parameter);
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / static_cast<double>(exponents.size());
}

std::vector<double> exponents_of(const Published& published) {
  if (published.statement == Statement::limit_of_fits) return {exponents_of_a_limit[2]};
  if (published.exponents.empty()) return {0};
  return parse_sweep(published.exponents);
}

std::vector<Metric> whole_domain_metrics() {
  std::vector<Metric> metrics;
  for (const Measure measure : measures) metrics.push_back({.measure = measure});
  return metrics;
}

namespace {

/// The exponents at which the fitted parameter has the printed value, and the two numbers half a unit of its
/// last digit away. They are searched between the exponents of the family's sweep. Empty if the parameter
/// does not cross them.
std::optional<ExponentRange> where_it_holds(FitCache& fits, const Published& published,
                                            const Metric& metric) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  const auto exponents = parse_sweep(fits.family().sweep);
  // The smallest exponent at which the fitted parameter crosses `value`.
  const auto crossing = [&](double value) -> std::optional<double> {
    const auto above = [&](double log_exponent) {
      return fitted(fits, std::exp(log_exponent), metric, parameter).value_or(std::nan("")) - value;
    };
    for (std::size_t i = 0; i + 1 < exponents.size(); ++i) {
      const double low = std::log(exponents[i]), high = std::log(exponents[i + 1]);
      const double at_low = above(low), at_high = above(high);
      if (!(at_low * at_high <= 0)) continue;
      return std::exp(root_between(above, low, high, at_low, at_high, 48));
    }
    return std::nullopt;
  };
  const double value = constant<double>(published.printed);
  const double half_unit = last_unit(published.printed) / 2;
  const auto exactly = crossing(value), one = crossing(value - half_unit),
             other = crossing(value + half_unit);
  if (!exactly || !one || !other) return std::nullopt;
  return ExponentRange{std::min(*one, *other), std::max(*one, *other), *exactly};
}

/// The other metrics, and the record's convention, against which a published number is judged.
std::vector<Alternative> alternatives(FitCache& fits, const Published& published, const Metric& metric) {
  std::vector<Alternative> others;
  const auto add = [&](const Metric& other) {
    if (other == metric) return;
    if (const auto value = computed_value(fits, published, other))
      others.push_back({describe(other), *value});
  };
  for (Metric other : whole_domain_metrics()) {
    other.domain = metric.domain;
    add(other);
  }
  if (metric.domain != Domain{}) {
    for (const Metric& other : whole_domain_metrics()) add(other);
  }
  if (published.convention.value) {
    others.push_back({std::string(published.convention.name), *published.convention.value});
  }
  return others;
}

Assessment assess_somewhere(FitCache& fits, const Published& published, const Metric& metric) {
  const auto range = where_it_holds(fits, published, metric);
  const double printed = constant<double>(published.printed);
  if (!range) return {&published, metric, printed, {Verdict::refuted, "", printed}, {}, std::nullopt};
  return {&published, metric, printed, {Verdict::conditional, describe(metric), printed}, {}, range};
}

}  // namespace

std::optional<Assessment> assess(FitCache& fits, const Published& published, const Metric& metric) {
  if (published.statement == Statement::fit_somewhere) return assess_somewhere(fits, published, metric);
  const auto computed = computed_value(fits, published, metric);
  if (!computed) return std::nullopt;
  const auto others = alternatives(fits, published, metric);
  return Assessment{&published, metric, *computed,
                    judge(published.printed, {describe(metric), *computed}, others),
                    effect_of_replacing(fits, published, metric, *computed)};
}

std::vector<double> exponents_needed_by(const Published& published, const Family& family) {
  if (family.sweep.empty()) return {};
  return published.statement == Statement::fit_somewhere ? parse_sweep(family.sweep)
                                                         : exponents_of(published);
}

Refit refit(FitCache& fits, std::vector<double> exponents, std::vector<const Published*> numbers,
            std::span<const Metric> under, const Checkpoint& checkpoint) {
  const Family& family = fits.family();
  // A number published for an exponent outside the sweep is fitted and judged too.
  for (const Published* number : numbers) {
    if (number->statement == Statement::best_fit && family.has_exponent())
      exponents.push_back(exponents_of(*number).front());
  }
  std::ranges::sort(exponents);
  exponents.erase(std::unique(exponents.begin(), exponents.end()), exponents.end());

  if (!family.has_exponent()) exponents = {0};
  Refit result{&family, std::move(numbers), {}, {}};
  for (const Metric& metric : under) {
    for (const double exponent : exponents) {
      checkpoint();
      FitReport report{fits.at(exponent, metric), {}};
      for (const Published& published : published_constants()) {
        if (!is_meant_for(published, report.fit)) continue;
        const auto assessment = assess(fits, published, metric);
        if (assessment) report.assessments.push_back(*assessment);
      }
      result.fits.push_back(std::move(report));
    }
  }
  for (const Published* number : result.numbers) {
    if (number->statement == Statement::best_fit) continue;
    for (const Metric& metric : under) {
      checkpoint();
      const auto assessment = assess(fits, *number, metric);
      if (assessment) result.derived.push_back(*assessment);
    }
  }
  return result;
}

namespace {

/// The law through the fits at three of the `exponents_of_a_limit`, from the `first` on.
std::optional<ApproachLaw<double>> law_through(FitCache& fits, const Metric& metric, std::size_t parameter,
                                               std::size_t first) {
  std::array<double, 3> f, x;
  for (std::size_t i = 0; i < 3; ++i) {
    const double exponent = exponents_of_a_limit.at(first + i);
    f[i] = 1 / exponent;
    const auto value = fitted(fits, exponent, metric, parameter);
    if (!value) return std::nullopt;
    x[i] = *value;
  }
  // Newton's divided differences: x(f) = x0 + d01 (f - f0) + d012 (f - f0)(f - f1), at f = 0
  const double d01 = (x[1] - x[0]) / (f[1] - f[0]);
  const double d12 = (x[2] - x[1]) / (f[2] - f[1]);
  const double d012 = (d12 - d01) / (f[2] - f[0]);
  return ApproachLaw<double>{x[0] - d01 * f[0] + d012 * f[0] * f[1], d01 - d012 * (f[0] + f[1])};
}

}  // namespace

std::optional<ApproachLaw<double>> extrapolate(FitCache& fits, const Metric& metric, std::size_t parameter) {
  const auto law = law_through(fits, metric, parameter, 0), further = law_through(fits, metric, parameter, 1);
  if (!law || !further) return std::nullopt;
  // If there is a limit, both are right to 1e-12, the size of terms in 1/k^3 and of the rounding of x.
  const bool is_limit = std::abs(further->limit - law->limit) < 1e-10 * std::abs(law->limit);
  return is_limit ? law : std::nullopt;
}

}  // namespace shadefit
