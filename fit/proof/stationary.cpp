#include "fit/proof/stationary.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "fit/family_visit.hpp"
#include "fit/least_squares/positive_definite.hpp"
#include "fit/proof/enclosed_integral.hpp"
#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/solve/solve.hpp"

namespace shadefit {
namespace {

/// Orders of the Taylor series: a gradient needs 20 digits, a Hessian a few.
constexpr int gradient_order = 20, hessian_order = 8;
/// Requested relative widths of the integrals. The width of the gradient moves the box by about as much,
/// times the condition of the problem (a few hundred for the pair).
constexpr double gradient_width = 1e-19, hessian_width = 1e-4;

template <std::size_t N>
using Intervals = std::array<Interval, N>;

/// A parameter as a scalar that carries the derivative with respect to it.
template <class T, int N>
ceres::Jet<T, N> seed(const T& value, int i) {
  ceres::Jet<T, N> jet(value);
  jet.v[i] = integer<T>(1);
  return jet;
}

/// error * d error/dp_i at a place: the integrand of the gradient of half the squared error.
template <class F, std::size_t N>
auto gradient_integrand(const F& family, const Intervals<N>& parameters) {
  return [=]<class T>(const Cosine<T>& c) {
    using Jet = ceres::Jet<T, static_cast<int>(N)>;
    std::array<Jet, N> p;
    for (std::size_t i = 0; i < N; ++i)
      p[i] = seed<T, static_cast<int>(N)>(lift<T>(parameters[i]), static_cast<int>(i));
    const Jet error = family.error(family.sample(c), p);
    std::array<T, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = error.a * error.v[static_cast<int>(i)];
    return result;
  };
}

/// The same for the derivatives of the gradient, row by row.
template <class F, std::size_t N>
auto hessian_integrand(const F& family, const Intervals<N>& parameters) {
  return [=]<class T>(const Cosine<T>& c) {
    constexpr int n = static_cast<int>(N);
    using First = ceres::Jet<T, n>;
    using Second = ceres::Jet<First, n>;
    std::array<Second, N> p;
    for (int i = 0; i < n; ++i) {
      const T value = lift<T>(parameters[static_cast<std::size_t>(i)]);
      p[static_cast<std::size_t>(i)] = seed<First, n>(seed<T, n>(value, i), i);
    }
    const Second error = family.error(family.sample(c), p);
    std::array<T, N * N> result;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        result[static_cast<std::size_t>(i * n + j)] =
            error.v[i].a * error.v[j].a + error.a.a * error.v[i].v[j];
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

  StationaryPoint result;
  const auto g = EnclosedIntegral<gradient_order, N>(fit.metric, gradient_tolerance)
                     .of(gradient_integrand(family, at), checkpoint);
  const auto h = EnclosedIntegral<hessian_order, N * N>(fit.metric, hessian_tolerance)
                     .of(hessian_integrand(family, box), checkpoint);
  if (!g || !h) {
    result.reason = std::string("the ") + (g ? "Hessian" : "gradient") + " could not be enclosed in " +
                    std::to_string(most_panels) + " panels";
    return result;
  }
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
    if (!(lower_end(box[i]) < lower && upper < upper_end(box[i]))) {
      result.reason = "Krawczyk's operator does not map the box into itself";
      return result;
    }
    result.unique_in.emplace_back(lower_end(box[i]), upper_end(box[i]));
    result.lies_in.emplace_back(lower, upper);
  }
  result.is_proven = true;
  result.is_minimum = is_positive_definite(
      *h, N, [](const Interval& pivot) { return has_one_sign(pivot) && is_never_negative(pivot); });
  double distance = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const auto [lower, upper] = result.lies_in[i];
    distance = std::max(distance, std::max(upper - p[i], p[i] - lower) / std::abs(p[i]));
  }
  result.digits = static_cast<int>(std::floor(-std::log10(distance)));
  return result;
}

}  // namespace

StationaryPoint prove_stationary(const Fit& fit, const Checkpoint& checkpoint) {
  const auto refused = [](const char* reason) {
    StationaryPoint result;
    result.reason = reason;
    return result;
  };
  if (fit.status != Status::converged) return refused("the fit did not converge");
  if (fit.metric.norm != Norm::least_squares) return refused("its norm is not least squares");
  if (fit.metric.error != Error::absolute) return refused("its error is not the absolute one");
  return visit_family(fit.family->id, [&]<class F>(std::type_identity<F>) {
    return prove(make_family<F>(setting_of(fit)), fit, checkpoint);
  });
}

}  // namespace shadefit
