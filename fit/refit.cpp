#include "fit/refit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "approx/catalogue.hpp"
#include "fit/sweep.hpp"

namespace shadefit {
namespace {

constexpr std::array<double, 3> exponents_of_a_limit{1e4, 1e5, 1e6};

std::size_t parameter_index(const FittableFamily& family, std::string_view name) {
  const auto found = std::find(family.parameters.begin(), family.parameters.end(), name);
  if (found == family.parameters.end())
    throw std::logic_error("a record names a parameter that its family lacks");
  return static_cast<std::size_t>(found - family.parameters.begin());
}

double fitted(FitCache& fits, double exponent, const Metric& metric, std::size_t parameter) {
  const Fit& fit = fits.at(exponent, metric);
  if (fit.status != Status::converged) {
    throw std::runtime_error("a published number rests on a fit of " + std::string(fit.family->id) +
                             " that is " + std::string(name(fit.status)));
  }
  return fit.parameters[parameter];
}

/// The value that a published number states, computed under a metric.
double computed_value(FitCache& fits, const Published& published, const Metric& metric) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  if (published.statement == Statement::limit_of_fits) return extrapolate(fits, metric, parameter).limit;
  const auto exponents = exponents_of(published);
  double sum = 0;
  for (const double exponent : exponents) sum += fitted(fits, exponent, metric, parameter);
  return sum / static_cast<double>(exponents.size());
}

/// The largest effect over the exponents of the published number; other parameters stay as fitted. Numbers
/// that agree to the ten digits that a report shows have no effect: what is left of them is rounding.
Effect effect_of_replacing(FitCache& fits, const Published& published, const Metric& metric,
                           double computed) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  Effect worst;
  if (std::abs(constant<double>(published.printed) - computed) < 1e-10 * std::abs(computed)) return worst;
  for (const double exponent : exponents_of(published)) {
    auto from = fits.at(exponent, metric).parameters, to = from;
    from[parameter] = constant<double>(published.printed);
    to[parameter] = computed;
    const Effect effect = fits.family().effect(exponent, metric.domain, from, to);
    if (effect.absolute.magnitude >= worst.absolute.magnitude) worst = effect;
  }
  return worst;
}

bool is_meant_for(const Published& published, const Fit& fit) {
  return published.family == fit.family->id && published.statement == Statement::best_fit &&
         (!fit.exponent || exponents_of(published) == std::vector<double>{*fit.exponent});
}

}  // namespace

const Fit& FitCache::at(double exponent, const Metric& metric) {
  const auto key = std::pair(metric.measure, exponent);
  const auto found = fits_.find(key);
  return found != fits_.end() ? found->second
                              : fits_.emplace(key, family_.fit(exponent, metric)).first->second;
}

std::vector<double> exponents_of(const Published& published) {
  if (published.statement == Statement::limit_of_fits) return {exponents_of_a_limit.back()};
  if (published.exponents.empty()) return {0};
  return parse_sweep(published.exponents);
}

Assessment assess(FitCache& fits, const Published& published, const Metric& metric) {
  const Alternative own{std::string(name(metric.measure)), computed_value(fits, published, metric)};
  std::vector<Alternative> others;
  for (const Measure measure : measures) {
    if (measure == metric.measure) continue;
    Metric other = metric;
    other.measure = measure;
    others.push_back({std::string(name(measure)), computed_value(fits, published, other)});
  }
  if (published.convention.value != nullptr) {
    others.push_back({std::string(published.convention.name), published.convention.value()});
  }
  return {&published, metric, own.value, judge(published.printed, own, others),
          effect_of_replacing(fits, published, metric, own.value)};
}

std::vector<FitReport> fit_and_assess(FitCache& fits, const std::vector<double>& exponents,
                                      std::span<const Measure> under) {
  std::vector<FitReport> reports;
  for (const Measure measure : under) {
    const Metric metric{.measure = measure};
    for (const double exponent : fits.family().has_exponent() ? exponents : std::vector<double>{0}) {
      FitReport report{fits.at(exponent, metric), {}};
      for (const Published& published : published_constants) {
        if (report.fit.status == Status::converged && is_meant_for(published, report.fit)) {
          report.assessments.push_back(assess(fits, published, metric));
        }
      }
      reports.push_back(std::move(report));
    }
  }
  return reports;
}

Refit refit(const FittableFamily& family, const std::vector<double>& exponents,
            std::span<const Measure> under) {
  FitCache fits(family);
  Refit result{&family, fit_and_assess(fits, exponents, under), {}};
  for (const Published& published : published_constants) {
    if (published.family != family.info.id || published.statement == Statement::best_fit) continue;
    for (const Measure measure : under)
      result.derived.push_back(assess(fits, published, {.measure = measure}));
  }
  return result;
}

Approach extrapolate(FitCache& fits, const Metric& metric, std::size_t parameter) {
  std::array<double, 3> f, x;
  for (std::size_t i = 0; i < 3; ++i) {
    f[i] = 1 / exponents_of_a_limit[i];
    x[i] = fitted(fits, exponents_of_a_limit[i], metric, parameter);
  }
  // Newton's divided differences: x(f) = x0 + d01 (f - f0) + d012 (f - f0)(f - f1), at f = 0
  const double d01 = (x[1] - x[0]) / (f[1] - f[0]);
  const double d12 = (x[2] - x[1]) / (f[2] - f[1]);
  const double d012 = (d12 - d01) / (f[2] - f[0]);
  return {x[0] - d01 * f[0] + d012 * f[0] * f[1], d01 - d012 * (f[0] + f[1])};
}

}  // namespace shadefit
