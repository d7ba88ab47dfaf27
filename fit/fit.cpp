#include "fit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

#include "fit/catalogue_study.hpp"
#include "fit/families/admissible.hpp"
#include "fit/family_visit.hpp"
#include "fit/fit_study.hpp"
#include "fit/least_squares/digits.hpp"
#include "fit/study_exchange/constrained_study.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

template <class F>
constexpr bool is_fresnel_family() {
  return requires(F f) {
    f.surface;
  };
}

/// The infinite error at a pole in the domain, which sampling would miss. Empty without a pole.
template <class F>
std::optional<Extremum> pole_of([[maybe_unused]] const F& family, [[maybe_unused]] const Domain& domain,
                                [[maybe_unused]] std::span<const double> parameters) {
  if constexpr (HasDenominator<F>) {
    const auto p = parameter_array<F>(parameters);
    if (!is_admissible(family, domain, p)) return Extremum{HUGE_VAL, pole_in(family, domain, p)};
  }
  return std::nullopt;
}

/// The places of extrema do not depend on the measure, so the search is in the cosine.
template <class F>
Extremum max_abs_error(const Setting& setting, const Domain& domain, std::span<const double> parameters) {
  const auto family = make_family<F>(setting);
  if (const auto pole = pole_of(family, domain, parameters)) return *pole;
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
  if (const auto pole = pole_of(family, domain, parameters)) return pole;
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

/// The upper and lower end of the places that count under a metric; empty if its error has no meaning
/// anywhere.
template <class F>
std::optional<std::pair<Cosine<double>, Cosine<double>>> ends_under(const F& family, const Metric& metric) {
  if (metric.error == Error::relative) return relative_ends(family, metric.domain);
  return std::pair(Cosine<double>{metric.domain.upper, 1 - metric.domain.upper},
                   Cosine<double>{metric.domain.lower, 1 - metric.domain.lower});
}

/// The study of a family under a metric, between the places that count.
template <class F>
Study study_of(const F& family, const Setting& setting, const Metric& metric) {
  const auto ends = ends_under(family, metric);
  return study_of(F::info.id, setting, metric, ends->first, ends->second);
}

template <class F>
Objective objective(const Setting& setting, const Metric& metric) {
  const auto family = make_family<F>(setting);
  if (!ends_under(family, metric))
    return [](std::span<const double>) { return std::numeric_limits<double>::quiet_NaN(); };
  Metric free = metric;
  free.constraints = {};
  const Objective value = objective_of(study_of(family, setting, free), metric);
  return [=](std::span<const double> parameters) {
    return pole_of(family, metric.domain, parameters) ? HUGE_VAL : value(parameters);
  };
}

/// The given parameters of a metric by their places.
template <class F>
std::array<std::optional<double>, F::parameters.size()> given_parameters(const Constraints& constraints) {
  std::array<std::optional<double>, F::parameters.size()> given;
  for (const Held& held : constraints.held)
    given.at(static_cast<std::size_t>(std::ranges::find(F::parameters, held.parameter) -
                                      F::parameters.begin())) = held.value;
  return given;
}

/// The answer if the form with all free parameters 0 equals its target, in value and slope, at every place of
/// a search: a domain of total reflection has the target 1 = exp2(0). The solvers cannot find it: a parameter
/// 0 has no relative digits, and an error 0 has no alternation. Usually empty, after one evaluation.
template <class F>
std::optional<Solution> exact_solution(const F& family, const Metric& metric) {
  using Jet = SearchedFunction::Jet;
  constexpr std::size_t N = F::parameters.size();
  std::array<double, N> p{};
  std::array<Jet, N> q{};
  const auto given = given_parameters<F>(metric.constraints);
  for (std::size_t i = 0; i < N; ++i) q[i] = Jet(p[i] = given[i].value_or(0));
  const Constraints& constraints = metric.constraints;
  const auto panels = Substitution::panels({.domain = metric.domain}, family.shape().for_search());
  const auto is_exact = [&](double s) {
    return std::all_of(panels.begin(), panels.end(), [&](const Substitution& panel) {
      const auto sample = family.sample(panel.at(s).cosine);
      const double slope = family.error(family.sample(panel.at(Jet(s, 0)).cosine), q).v[0];
      const double form = family.form(sample, p);
      // A panel without length has no slope. A form that has underflowed does not equal its target.
      return panel.total() > 0 && family.error(sample, p) == 0 && slope == 0 && std::isnormal(form) &&
             form <= constraints.at_most.value_or(form) && form >= constraints.at_least.value_or(form);
    });
  };
  if (!is_exact(0.5) || !is_exact(0) || !is_exact(1)) return std::nullopt;
  const auto places = search_points();
  if (!std::all_of(places.begin(), places.end(), is_exact)) return std::nullopt;
  Solution solution{.parameters = {p.begin(), p.end()}, .status = Status::converged, .digits = most_digits};
  if (metric.norm == Norm::minimax) solution.level = 0;
  return solution;
}

/// The starts of a family without its given parameters.
template <class F>
std::vector<std::vector<double>> free_starts(const F& family, const Constraints& constraints) {
  const auto given = given_parameters<F>(constraints);
  std::vector<std::vector<double>> starts;
  for (const auto& start : family.starts()) {
    starts.emplace_back();
    for (std::size_t i = 0; i < start.size(); ++i)
      if (!given[i]) starts.back().push_back(start[i]);
  }
  return starts;
}

/// The fit of a study as one of a family.
template <class F>
Solution solution_of(const StudyFit& fit, const Setting& setting, const Constraints& constraints) {
  Solution solution{.parameters = std::vector<double>(F::parameters.size()),
                    .status = fit.status,
                    .digits = fit.digits,
                    .rms_error = fit.rms_error,
                    .level = fit.level,
                    .alternation = fit.alternation,
                    .why = fit.why};
  const auto given = given_parameters<F>(constraints);
  auto next = fit.parameters.begin();
  for (std::size_t i = 0; i < given.size(); ++i)
    solution.parameters[i] = given[i] ? *given[i] : next != fit.parameters.end() ? *next++ : 0;
  std::ranges::reverse(solution.alternation);
  for (AlternationPoint& point : solution.alternation)
    point.at = cosine_at(F::info.id, setting, point.at.cos_theta);
  return solution;
}

template <class F>
Solution solve(const F& family, const Setting& setting, const Metric& metric) {
  if (!ends_under(family, metric))
    return {.parameters = std::vector<double>(F::parameters.size()),
            .status = Status::not_finite,
            .why = "a relative error has no meaning on this domain"};
  if (const auto exact = exact_solution(family, metric)) return *exact;
  StudyObjective asked{
      .study = study_of(family, setting, metric), .norm = metric.norm, .constraints = metric.constraints};
  for (double& place : asked.constraints.exact_at) place = variable_at(F::info.id, setting, place);
  StudyFit found;
  try {
    found = fit_from_starts(asked, free_starts(family, metric.constraints));
    found.rms_error /= scale_of_weight(asked.study, metric.weight);
  } catch (const Infeasible& error) {
    fail(found, Status::infeasible, in_cosines(F::info.id, setting, error.why));
  } catch (const UserError& error) {
    fail(found, Status::not_finite, error.what());
  }
  return solution_of<F>(found, setting, metric.constraints);
}

/// Why a solution is rejected: its errors contradict each other. Empty if they do not.
std::string contradiction_in(const Fit& fit) {
  const bool is_relative = fit.metric.error == Error::relative;
  const double largest = is_relative ? fit.max_rel_error.value().magnitude : fit.max_abs_error.magnitude;
  return contradiction_of(fit.rms_error, largest);
}

/// Of parameters with a pole: whether far larger ones than the start are better than the last admissible ones
/// on the way from the start.
template <class F>
bool has_no_end(const Setting& setting, const Metric& metric, const std::vector<double>& parameters) {
  const auto family = make_family<F>(setting);
  const auto start = family.starts().front();
  std::vector<double> far(start.begin(), start.end()), near = far;
  double inside = 0, outside = 1;
  for (int halving = 0; halving < 40; ++halving) {
    const double share = (inside + outside) / 2;
    std::vector<double> tried = near;
    for (std::size_t i = 0; i < far.size(); ++i) tried[i] = std::lerp(start[i], parameters[i], share);
    (pole_of(family, metric.domain, tried) ? outside : inside) = share;
    if (inside == share) near = tried;
  }
  for (double& value : far) value *= 0x1p30;
  const Objective value = objective<F>(setting, metric);
  return value(far) < value(near);
}

template <class F>
Fit fit(const Setting& setting, const Metric& metric) {
  const auto family = make_family<F>(setting);
  Fit result{solve(family, setting, metric)};
  result.family = &F::info;
  if (!F::info.sweep.empty()) result.exponent = setting.exponent;
  if (is_fresnel_family<F>()) result.surface = setting.surface;
  result.metric = metric;
  result.relative_to = family.relative_to();
  if (result.status != Status::infeasible && pole_of(family, metric.domain, result.parameters)) {
    if (has_constraints(metric.constraints)) {
      result.status = Status::infeasible;
    } else if (has_no_end<F>(setting, metric, result.parameters)) {
      result.status = Status::not_converged;
      result.why = "larger parameters are always better: the form has no best ones";
    } else {
      result.status = Status::at_border;
    }
  }
  if (result.status == Status::converged) {
    result.max_abs_error = max_abs_error<F>(setting, metric.domain, result.parameters);
    result.max_rel_error = max_rel_error<F>(setting, metric.domain, result.parameters);
    if (const auto ends = relative_ends(family, metric.domain)) {
      result.relative_domain = {ends->second.cos_theta, metric.domain.upper};
    } else {
      result.relative_to = "nothing: the target is nowhere between 1/255 and what a double can reach";
    }
    result.why = contradiction_in(result);
    if (!result.why.empty()) result.status = Status::not_converged;
  }
  if constexpr (HasDenominator<F>) {
    const std::string rule = rule_of_admission(family, metric.domain);
    if (result.status == Status::at_border)
      result.why = "the way down leads to the border of the admissible parameters, which is " + rule;
    if (result.status == Status::infeasible && result.why.empty())
      result.why = "no admissible parameters, " + rule + ", meet the constraints";
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
CurvePoint point(const Setting& setting, std::span<const double> parameters, const Cosine<double>& cosine) {
  const auto family = make_family<F>(setting);
  const auto sample = family.sample(cosine);
  const auto p = parameter_array<F>(parameters);
  const double form = family.form(sample, p), error = family.error(sample, p),
               relative = family.relative_error(sample, p);
  return {form - error, form, error, std::isfinite(relative) ? std::optional(relative) : std::nullopt};
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
    F::info,       F::parameters, &fit<F>,  &max_abs_error<F>,         &max_rel_error<F>,   &effect<F>,
    &objective<F>, &target<F>,    &form<F>, reflectance_error_of<F>(), &relative_domain<F>, &point<F>};

}  // namespace

std::string contradiction_of(double rms_error, double largest_error) {
  constexpr double rounding = 1e-15;  // a few ulps at 1, the largest value of forms and targets
  // Errors that differ by less count as equal in the search.
  if (rms_error <= largest_error * (1 + equal_extrema) + rounding) return "";
  return "the rms error " + to_text(rms_error) + " exceeds the largest error found, " +
         to_text(largest_error) + ": one of them is wrong";
}

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
