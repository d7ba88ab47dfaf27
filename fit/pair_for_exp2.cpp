#include "fit/pair_for_exp2.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "approx/exp2_polynomial.hpp"
#include "approx/fresnel.hpp"
#include "fit/families/families.hpp"
#include "fit/minimax/minimax.hpp"
#include "fit/minimax/minimax_curve.hpp"
#include "fit/minimax/minimax_problem.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/solve.hpp"

namespace shadefit {
namespace {

// The error jumps where the exponent x = (a c + b) c passes the middle between two whole numbers. In c, these
// places depend on the pair. With x as the variable instead of c, they do not: the form is 2^n p(x - n) for
// every pair, and the pair moves only the cosine at which the target is evaluated. Each whole number is a
// panel of the search, and jumps are at the ends of panels. The result is the global optimum: an error within
// a level means that the cosine of an exponent x lies between two cosines that do not depend on the pair. So
// (a c + b) c is at least x at one of them and at most x at the other. These conditions are linear in a and
// b.

/// The whole numbers of the search, from 0 down. Without the others the level can only be lower. But errors
/// there are below the level: the form is at most 2^-8.5 = 0.0028 and the target less, while the level is at
/// least 0.0034. So the level is that of the whole domain. Its test samples all of it.
constexpr int panels = 9;

/// x on a panel: from 0 to -1/2 on the first, on the others from 1/2 above a whole number to 1/2 below it.
template <class T>
T exponent_at(std::size_t panel, const T& s) {
  const T half = integer<T>(1) / integer<T>(2);
  return panel == 0 ? T(-(half * s)) : T(half - integer<T>(static_cast<int>(panel)) - s);
}

/// The root of (a c + b) c = x that is 0 at x = 0; a, b < 0.
template <class T>
T cosine_of_exponent(const T& x, const T& a, const T& b) {
  return integer<T>(2) * x / (b - sqrt(T(b * b + integer<T>(4) * a * x)));
}

/// c1 .. cn of a degree, then zeros.
template <class T>
std::array<T, largest_exp2_degree> coefficients_of(int degree) {
  std::array<T, largest_exp2_degree> c;
  c.fill(integer<T>(0));
  const Exp2Coefficients& polynomial = exp2_of_degree(exp2_for_float, degree);
  for (std::size_t i = 0; i < static_cast<std::size_t>(degree); ++i)
    c[i] = constant<T>(polynomial.printed[i]);
  return c;
}

/// 2^n p(x - n) - (1-c)^5; P is T or has derivatives by the pair.
template <class T, class P>
P error_at(int degree, std::size_t panel, const T& s, const std::array<P, most_parameters>& pair) {
  const T x = exponent_at(panel, s);
  const auto n = -static_cast<int>(panel);
  const T form = exp2_near_zero(T(x - integer<T>(n)), coefficients_of<T>(degree)) * power(integer<T>(2), n);
  return lift<P>(form) - schlick_weight(cosine_of_exponent(lift<P>(x), pair[0], pair[1]));
}

}  // namespace

PairForExp2 fit_pair_for_exp2(int degree) {
  const Solution exact = solve_by_squares(FresnelQuadratic(), Metric());
  MinimaxParameters start{};
  std::ranges::copy(exact.parameters, start.begin());
  std::vector<SearchPlace> places;
  for (std::size_t panel = 0; panel < panels; ++panel) {
    for (const double s : chebyshev_places()) places.push_back({panel, s});
  }
  const auto error = [degree]<class T, class P>(std::size_t panel, const T& s,
                                                const std::array<P, most_parameters>& pair) {
    return error_at(degree, panel, s, pair);
  };
  const MinimaxCurve curve = curve_of_error(error, places);
  const MinimaxProblem problem{.size = 2,
                               .places = places,
                               .cosine_at =
                                   [&start](const SearchPlace& at) {
                                     const double c =
                                         cosine_of_exponent(exponent_at(at.panel, at.s), start[0], start[1]);
                                     return Cosine<double>{c, 1 - c};
                                   },
                               .error = curve};
  const MinimaxOptimum optimum = solve_minimax(problem, start);
  return {optimum.parameters[0], optimum.parameters[1], optimum.level, optimum.status, optimum.why};
}

}  // namespace shadefit
