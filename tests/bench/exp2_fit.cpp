#include "tests/bench/exp2_fit.hpp"

#include <Eigen/Dense>
#include <array>

#include "approx/exp2_polynomial.hpp"
#include "fit/minimax/minimax.hpp"
#include "fit/minimax/minimax_curve.hpp"
#include "fit/minimax/minimax_problem.hpp"
#include "fit/scalars/jet.hpp"
#include "tests/bench/exp2_error.hpp"

namespace shadefit::testing {
namespace {

/// The error at r in [-1/2, 1/2]; P is T or has derivatives by the parameters, which are the deviations from
/// Taylor's coefficients.
template <class P, class T, std::size_t N>
P relative_error(const T& r, int degree, const std::array<P, N>& d) {
  const T tail = exp2_tail(r, degree, integer<T>(1));
  return exp2_relative_error(lift<P>(r), degree, d, lift<P>(tail), lift<P>(exp2(T(-r))));
}

/// A place of the search as r.
template <class T>
T rest_at(const T& s) {
  return s - integer<T>(1) / integer<T>(2);
}

/// Least squares at the places, a linear problem: near enough for the exchange.
MinimaxParameters start(int degree, const std::vector<SearchPlace>& places) {
  const auto rows = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd powers(rows, degree);
  Eigen::VectorXd tails(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double r = rest_at(places[static_cast<std::size_t>(i)].s), scale = exp2(-r);
    double term = scale;
    for (int j = 0; j < degree; ++j) powers(i, j) = term *= r;
    tails[i] = scale * exp2_tail(r, degree, 1.0);
  }
  const Eigen::VectorXd d = powers.colPivHouseholderQr().solve(tails);
  MinimaxParameters found{};
  for (int j = 0; j < degree; ++j) found[static_cast<std::size_t>(j)] = d[j];
  return found;
}

}  // namespace

Exp2Fit fit_exp2(int degree) {
  exp2_of_degree(exp2_for_double, degree);  // throws if there is none
  std::vector<SearchPlace> places;
  for (const double s : chebyshev_places()) places.push_back({0, s});
  const auto error = [degree]<class T, class P>(std::size_t, const T& s,
                                                const std::array<P, most_parameters>& d) {
    return relative_error(rest_at(s), degree, d);
  };
  const MinimaxCurve curve = curve_of_error(error, places);
  const MinimaxProblem problem{.size = static_cast<std::size_t>(degree),
                               .places = places,
                               .cosine_at =
                                   [](const SearchPlace& at) {
                                     return Cosine<double>{at.s, 1 - at.s};
                                   },
                               .error = curve};
  const MinimaxOptimum optimum = solve_minimax(problem, start(degree, places));
  Exp2Fit fit{.degree = degree,
              .level = optimum.level,
              .contacts = static_cast<int>(optimum.alternation.size()),
              .status = optimum.status,
              .why = optimum.why};
  for (int i = 1; i <= degree; ++i) {
    const auto deviation = static_cast<long double>(optimum.parameters[static_cast<std::size_t>(i) - 1]);
    fit.coefficients.push_back(exp2_taylor_coefficient<long double>(i) + deviation);
  }
  return fit;
}

}  // namespace shadefit::testing
