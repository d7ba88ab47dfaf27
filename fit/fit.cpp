#include "fit/fit.hpp"

#include <algorithm>
#include <array>

#include "fit/families.hpp"

namespace shadefit {
namespace {

template <class F>
F make_family(double exponent) {
  if constexpr (requires(F f) { f.exponent; }) {
    return F{exponent};
  } else {
    return F{};
  }
}

template <class F>
auto parameter_array(std::span<const double> parameters) {
  std::array<double, F::parameters.size()> p;
  std::copy_n(parameters.begin(), p.size(), p.begin());
  return p;
}

/// A function of the cosine that evaluates one of a family's error functions at fixed parameters, in any
/// scalar.
template <class F, std::size_t N, class Function>
auto at_parameters(const F& family, const std::array<double, N>& parameters, Function function) {
  return [=]<class T>(const Cosine<T>& c) {
    std::array<T, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = lift<T>(parameters[i]);
    return function(family, family.sample(c), p);
  };
}

/// Extrema are places in c whatever the measure, so they are looked for in the cosine.
template <class F>
Extremum max_abs_error(double exponent, const Domain& domain, std::span<const double> parameters) {
  const auto family = make_family<F>(exponent);
  const auto error =
      at_parameters(family, parameter_array<F>(parameters),
                    [](const F& f, const auto& sample, const auto& p) { return f.error(sample, p); });
  return largest_magnitude(error, Substitution({.domain = domain}, family.shape()));
}

template <class F>
Extremum max_rel_error(double exponent, const Domain& domain, std::span<const double> parameters) {
  const auto family = make_family<F>(exponent);
  const auto error = at_parameters(
      family, parameter_array<F>(parameters),
      [](const F& f, const auto& sample, const auto& p) { return f.relative_error(sample, p); });
  return largest_magnitude(error, Substitution({.domain = family.relative_domain(domain)}, {}));
}

template <class F>
Fit fit(double exponent, const Metric& metric) {
  const auto family = make_family<F>(exponent);
  const auto optimum = solve_least_squares(family, metric);
  Fit result{.family = &F::info,
             .exponent = F::info.sweep.empty() ? std::nullopt : std::optional(exponent),
             .metric = metric,
             .parameters = {optimum.parameters.begin(), optimum.parameters.end()},
             .status = optimum.status,
             .iterations = optimum.iterations,
             .digits = optimum.digits,
             .rms_error = optimum.rms_error,
             .max_abs_error = {},
             .max_rel_error = {},
             .relative_domain = family.relative_domain(metric.domain),
             .relative_to = F::relative_to};
  if (result.status == Status::converged) {
    result.max_abs_error = max_abs_error<F>(exponent, metric.domain, result.parameters);
    result.max_rel_error = max_rel_error<F>(exponent, metric.domain, result.parameters);
  }
  return result;
}

template <class F>
Effect effect(double exponent, const Domain& domain, std::span<const double> from,
              std::span<const double> to) {
  return effect_of_change(make_family<F>(exponent), domain, parameter_array<F>(from), parameter_array<F>(to));
}

template <class F>
constexpr FittableFamily entry{F::info, F::parameters, &fit<F>, &max_abs_error<F>, &effect<F>};

}  // namespace

std::span<const FittableFamily> fittable_families() {
  static constexpr std::array all{entry<SgOffset>, entry<FresnelOneTerm>, entry<FresnelQuadratic>};
  return all;
}

const FittableFamily* find_family(std::string_view id) {
  const auto all = fittable_families();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.info.id == id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace shadefit
