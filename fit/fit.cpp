#include "fit/fit.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

#include "fit/family_visit.hpp"
#include "fit/solve.hpp"

namespace shadefit {
namespace {

template <class F>
constexpr bool is_fresnel_family() {
  return requires(F f) {
    f.surface;
  };
}

/// Extrema are places in c whatever the measure, so they are looked for in the cosine.
template <class F>
Extremum max_abs_error(const Setting& setting, const Domain& domain, std::span<const double> parameters) {
  const auto family = make_family<F>(setting);
  const auto error =
      at_parameters(family, parameter_array<F>(parameters),
                    [](const F& f, const auto& sample, const auto& p) { return f.error(sample, p); });
  return largest_magnitude(error, Substitution::panels({.domain = domain}, family.shape().for_search()));
}

/// The part of the domain in which a relative error has a meaning: its upper and lower end; empty where there
/// is none.
template <class F>
std::optional<std::pair<Cosine<double>, Cosine<double>>> relative_ends(const F& family,
                                                                       const Domain& domain) {
  const auto end = family.relative_end();
  if (!end) return std::nullopt;
  const Cosine<double> top{domain.upper, 1 - domain.upper};
  const Cosine<double> bottom =
      end->cos_theta >= domain.lower ? *end : Cosine<double>{domain.lower, 1 - domain.lower};
  if (bottom.one_minus_cos <= top.one_minus_cos) return std::nullopt;
  return std::pair(top, bottom);
}

template <class F>
std::optional<Extremum> max_rel_error(const Setting& setting, const Domain& domain,
                                      std::span<const double> parameters) {
  const auto family = make_family<F>(setting);
  const auto ends = relative_ends(family, domain);
  if (!ends) return std::nullopt;
  const auto error = at_parameters(
      family, parameter_array<F>(parameters),
      [](const F& f, const auto& sample, const auto& p) { return f.relative_error(sample, p); });
  return largest_magnitude(error,
                           Substitution::between(ends->first, ends->second, family.shape().for_search()));
}

template <class F>
std::optional<Domain> relative_domain(const Setting& setting, const Domain& domain) {
  const auto ends = relative_ends(make_family<F>(setting), domain);
  return ends ? std::optional(Domain{ends->second.cos_theta, domain.upper}) : std::nullopt;
}

bool is_plain(const Metric& metric) {
  return metric.norm == Norm::least_squares && metric.error == Error::absolute && metric.weight.empty() &&
         metric.constraints.held.empty();
}

/// Upper and lower end of the places that count under a metric; empty where its error has a meaning nowhere.
template <class F>
std::optional<std::pair<Cosine<double>, Cosine<double>>> ends_under(const F& family, const Metric& metric) {
  if (metric.error == Error::relative) return relative_ends(family, metric.domain);
  return std::pair(Cosine<double>{metric.domain.upper, 1 - metric.domain.upper},
                   Cosine<double>{metric.domain.lower, 1 - metric.domain.lower});
}

template <class F>
double objective(const Setting& setting, const Metric& metric, std::span<const double> parameters) {
  const auto family = make_family<F>(setting);
  const auto ends = ends_under(family, metric);
  if (!ends) return std::numeric_limits<double>::quiet_NaN();
  return objective_at(family, metric, ends->first, ends->second, parameter_array<F>(parameters));
}

template <class F>
Solution solve(const F& family, const Metric& metric) {
  if (is_plain(metric)) return solve_plain(family, metric);
  if (const auto ends = ends_under(family, metric))
    return solve_under(family, metric, ends->first, ends->second);
  return {.parameters = std::vector<double>(F::parameters.size()),
          .status = Status::not_finite,
          .why = "a relative error has no meaning on this domain"};
}

template <class F>
Fit fit(const Setting& setting, const Metric& metric) {
  const auto family = make_family<F>(setting);
  const Solution optimum = solve(family, metric);
  Fit result{.family = &F::info,
             .exponent = F::info.sweep.empty() ? std::nullopt : std::optional(setting.exponent),
             .surface = is_fresnel_family<F>() ? setting.surface : Surface{},
             .metric = metric,
             .parameters = optimum.parameters,
             .status = optimum.status,
             .iterations = optimum.iterations,
             .digits = optimum.digits,
             .rms_error = optimum.rms_error,
             .max_abs_error = {},
             .max_rel_error = std::nullopt,
             .relative_domain = {},
             .relative_to = family.relative_to(),
             .level = optimum.level,
             .alternation = optimum.alternation,
             .why = optimum.why};
  if (result.status == Status::converged) {
    result.max_abs_error = max_abs_error<F>(setting, metric.domain, result.parameters);
    result.max_rel_error = max_rel_error<F>(setting, metric.domain, result.parameters);
    if (const auto ends = relative_ends(family, metric.domain)) {
      result.relative_domain = {ends->second.cos_theta, metric.domain.upper};
    } else {
      result.relative_to = "nothing: the target is nowhere between 1/255 and what a double can reach";
    }
  }
  return result;
}

template <class F>
Effect effect(const Setting& setting, const Domain& domain, std::span<const double> from,
              std::span<const double> to) {
  return effect_of_change(make_family<F>(setting), domain, parameter_array<F>(from), parameter_array<F>(to));
}

template <class F>
Symbolic target() {
  return F::target_of(Symbolic::variable("c"), Symbolic::variable("k"));
}

template <class F>
Symbolic form() {
  return std::apply(
      [](const auto&... name) {
        return F::form_of(Symbolic::variable("c"), Symbolic::variable("k"),
                          std::array{Symbolic::variable(name)...});
      },
      F::parameters);
}

template <class F>
ReflectanceError reflectance_error(const Surface& surface, std::span<const double> parameters) {
  const F family{{surface}};
  const auto p = parameter_array<F>(parameters);
  const auto form = at_parameters(
      family, p, [](const F& f, const auto& sample, const auto& q) { return f.form(sample, q); });
  return compare_reflectance(surface, form);
}

template <class F>
constexpr auto reflectance_error_of() -> ReflectanceError (*)(const Surface&, std::span<const double>) {
  if constexpr (is_fresnel_family<F>()) {
    return &reflectance_error<F>;
  } else {
    return nullptr;
  }
}

template <class F>
constexpr FittableFamily entry{
    F::info,       F::parameters, &fit<F>,  &max_abs_error<F>,         &max_rel_error<F>,  &effect<F>,
    &objective<F>, &target<F>,    &form<F>, reflectance_error_of<F>(), &relative_domain<F>};

}  // namespace

std::span<const FittableFamily> fittable_families() {
  static constexpr auto all = []<class... F>(std::type_identity<std::tuple<F...>>) {
    return std::array{entry<F>...};
  }(std::type_identity<Families>{});
  return all;
}

std::size_t parameter_index(const FittableFamily& family, std::string_view name) {
  const auto found = std::find(family.parameters.begin(), family.parameters.end(), name);
  if (found == family.parameters.end())
    throw std::logic_error("a record names a parameter that its family lacks");
  return static_cast<std::size_t>(found - family.parameters.begin());
}

const FittableFamily* find_family(std::string_view id) {
  const auto all = fittable_families();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.info.id == id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace shadefit
