#include "fit/proof/stationary.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "fit/family_visit.hpp"
#include "fit/least_squares/positive_definite.hpp"
#include "fit/proof/enclosed_integral.hpp"
#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/solve.hpp"

namespace shadefit {
namespace {

/// Orders of the Taylor series: a gradient needs 20 digits, a Hessian a few.
constexpr int gradient_order = 20, hessian_order = 8;
/// Requested relative widths of the integrals. The width of the gradient moves the box by about as much,
/// times the condition of the problem (a few hundred for the pair).
constexpr double gradient_width = 1e-19, hessian_width = 1e-4;

template <std::size_t N>
using Intervals = std::array<Interval, N>;

/// A parameter as a scalar that carries the derivative by it, if `is_moved`.
template <class T>
ceres::Jet<T, 1> seed(const T& value, bool is_moved) {
  ceres::Jet<T, 1> jet(value);
  jet.v[0] = integer<T>(is_moved ? 1 : 0);
  return jet;
}

/// error * d error/dp_i at a place: the integrand of the gradient of half the squared error. One parameter
/// moves at a time: so the scalars are the same for any number of parameters, and compile once.
template <class F, std::size_t N>
auto gradient_integrand(const F& family, const Intervals<N>& parameters) {
  return [=]<class T>(const Cosine<T>& c) {
    const auto sample = family.sample(c);
    std::array<T, N> result;
    for (std::size_t i = 0; i < N; ++i) {
      std::array<ceres::Jet<T, 1>, N> p;
      for (std::size_t k = 0; k < N; ++k) p[k] = seed(lift<T>(parameters[k]), k == i);
      const auto error = family.error(sample, p);
      result[i] = error.a * error.v[0];
    }
    return result;
  };
}

/// The same for the derivatives of the gradient, row by row. Two parameters move at a time.
template <class F, std::size_t N>
auto hessian_integrand(const F& family, const Intervals<N>& parameters) {
  return [=]<class T>(const Cosine<T>& c) {
    const auto sample = family.sample(c);
    std::array<T, N * N> result;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        std::array<ceres::Jet<ceres::Jet<T, 1>, 1>, N> p;
        for (std::size_t k = 0; k < N; ++k) p[k] = seed(seed(lift<T>(parameters[k]), k == j), k == i);
        const auto error = family.error(sample, p);
        result[i * N + j] = result[j * N + i] = error.v[0].a * error.a.v[0] + error.a.a * error.v[0].v[0];
      }
    }
    return result;
  };
}

template <class F>
StationaryPoint prove(const F& family, const Fit& fit, const Checkpoint& checkpoint) {
  constexpr std::size_t N = F::parameters.size();
  using Matrix = Eigen::Matrix<double, static_cast<int>(N), static_cast<int>(N)>;
  const std::array<double, N> p = parameter_array<F>(fit.parameters);

  // The scales and the inverse are chosen in plain doubles. The proof does not depend on their accuracy.
  const auto substitutions = Substitution::panels(fit.metric, family.shape());
  long double total = 0;
  for (const Substitution& panel : substitutions) total += panel.total();
  const ParameterMatrix<double> of_measure = sums_of(AnyFamily(family), fit.metric, fit.parameters).hessian;
  const Matrix hessian = of_measure * static_cast<double>(total);
  const Matrix inverse = hessian.inverse();

  std::array<double, N> radius, gradient_tolerance;
  std::array<double, N * N> hessian_tolerance;
  Intervals<N> at, box;
  for (std::size_t i = 0; i < N; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    radius[i] = std::abs(p[i]) * stationary_radius;
    at[i] = Interval(p[i]);
    box[i] = span_of(p[i] - radius[i], p[i] + radius[i]);
    gradient_tolerance[i] = gradient_width * std::abs(hessian(row, row) * p[i]);
    for (std::size_t j = 0; j < N; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      hessian_tolerance[i * N + j] =
          hessian_width * std::sqrt(std::abs(hessian(row, row) * hessian(column, column)));
    }
  }

  const auto g = EnclosedIntegral<gradient_order, N>(fit.metric, gradient_tolerance)
                     .of(gradient_integrand(family, at), checkpoint);
  const auto h = EnclosedIntegral<hessian_order, N * N>(fit.metric, hessian_tolerance)
                     .of(hessian_integrand(family, box), checkpoint);
  if (!g || !h)
    return {.reason = std::string("the ") + (g ? "Hessian" : "gradient") + " could not be enclosed in " +
                      std::to_string(most_panels) + " panels"};
  StationaryPoint result{.is_proven = true};
  double distance = 0;
  for (std::size_t i = 0; i < N; ++i) {
    Interval image = at[i];
    for (std::size_t j = 0; j < N; ++j) {
      const auto entry = [&](std::size_t column) {
        return Interval(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column)));
      };
      image = image - entry(j) * (*g)[j];
      Interval left(i == j ? 1 : 0);
      for (std::size_t k = 0; k < N; ++k) left = left - entry(k) * (*h)[k * N + j];
      image = image + left * (box[j] - at[j]);
    }
    const double lower = lower_end(image), upper = upper_end(image);
    if (!(lower_end(box[i]) < lower && upper < upper_end(box[i])))
      return {.reason = "Krawczyk's operator does not map the box into itself"};
    result.unique_in.emplace_back(lower_end(box[i]), upper_end(box[i]));
    result.lies_in.emplace_back(lower, upper);
    distance = std::max({distance, (upper - p[i]) / std::abs(p[i]), (p[i] - lower) / std::abs(p[i])});
  }
  result.is_minimum = is_positive_definite(
      *h, N, [](const Interval& pivot) { return has_one_sign(pivot) && is_never_negative(pivot); });
  result.digits = static_cast<int>(std::floor(-std::log10(distance)));
  return result;
}

}  // namespace

StationaryPoint prove_stationary(const Fit& fit, const Checkpoint& checkpoint) {
  if (fit.status != Status::converged) return {.reason = "the fit did not converge"};
  if (fit.metric.norm != Norm::least_squares) return {.reason = "its norm is not least squares"};
  if (fit.metric.error != Error::absolute) return {.reason = "its error is not the absolute one"};
  return visit_family(fit.family->id, [&]<class F>(std::type_identity<F>) {
    return prove(make_family<F>(setting_of(fit)), fit, checkpoint);
  });
}

}  // namespace shadefit
