#include "fit/error_bounds.hpp"

#include <cmath>
#include <vector>

#include "fit/certified_formula.hpp"
#include "fit/enclosure.hpp"
#include "fit/integrate.hpp"

namespace shadefit {
namespace {

template <class Error>
ErrorBounds bounds_of(const Error& error, const Domain& domain, const ExactPlace& hint, double width) {
  const Enclosure found = enclose_largest(error, domain, {.width = width, .hint = hint});
  return {found.lower, found.upper, found.is_reached};
}

/// The integral over a domain, cut where a surface's reflectance has a kink or ends its fall.
template <class F>
double integral(const F& f, const Domain& domain, const Surface& surface) {
  constexpr double tolerance = 1e-12;  // far below the digits that an rms error is shown with
  const auto joint = joint_of(surface);
  if (!joint || joint->cosine <= domain.lower || joint->cosine >= domain.upper)
    return tanh_sinh(f, domain.lower, domain.upper, tolerance).value;
  return tanh_sinh(f, domain.lower, joint->cosine, tolerance).value +
         tanh_sinh(f, joint->cosine, domain.upper, tolerance).value;
}

}  // namespace

ErrorBounds bound_error(const Subject& subject, double width) {
  const FittableFamily& family = *find_family(subject.family);
  std::vector<double> parameters;
  for (const auto& parameter : subject.parameters)
    parameters.push_back(upper_end(enclosed_constant(parameter.second).value()));
  const ExactPlace hint = place_of(family.max_abs_error(subject.setting, subject.domain, parameters).at);
  return visit_formula(subject, [&](const auto& error, const auto&, const auto&) {
    return bounds_of(error, subject.domain, hint, width);
  });
}

SchlickError schlick_error(const Surface& surface, const Domain& domain, double width) {
  const auto error = [&]<class T>(const Cosine<T>& c) {
    const T f0 = normal_reflectance<T>(surface);
    return T((integer<T>(1) - f0) * (schlick_weight(c.cos_theta) - target_weight(surface, c.cos_theta)));
  };
  const auto relative = [&]<class T>(const Cosine<T>& c) {
    return T(error(c) / exact_reflectance(surface, c.cos_theta));
  };
  const auto squared = [&](double c) { return std::pow(error(Cosine<double>{c, 1 - c}), 2); };
  const auto panels =
      Substitution::panels({.domain = domain}, Shape{.joint = joint_of(surface)}.for_search());
  SchlickError result{.bounds = {},
                      .absolute = largest_magnitude(error, panels),
                      .relative = largest_magnitude(relative, panels),
                      .rms = std::sqrt(integral(squared, domain, surface) / (domain.upper - domain.lower))};
  result.bounds = bounds_of(error, domain, place_of(result.absolute.at), width);
  return result;
}

}  // namespace shadefit
