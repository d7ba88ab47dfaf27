#pragma once

#include <span>
#include <tuple>
#include <variant>

#include "approx/cosine.hpp"
#include "fit/families/families.hpp"
#include "fit/least_squares/descent.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/solution.hpp"

/// The solvers of a family. Each is compiled in its own unit: in one unit the compiler inlines less, and a
/// fit by least squares takes 1.5 times as long.
namespace shadefit {

template <class List>
struct OneOf;
template <class... F>
struct OneOf<std::tuple<F...>> {
  using type = std::variant<F...>;
};

/// Any of the `Families`, with its setting. The solvers are compiled for each of them.
using AnyFamily = OneOf<Families>::type;

/// A family by least squares, over the metric's domain.
Solution solve_by_squares(const AnyFamily& family, const Metric& metric);

/// The same from given starts: three points, each with one number per parameter of the family.
Solution solve_by_squares(const AnyFamily& family, const Metric& metric, const Starts& starts);

/// A family by minimax, between the places `top` and `bottom`.
Solution solve_by_minimax(const AnyFamily& family, const Metric& metric, const Cosine<double>& top,
                          const Cosine<double>& bottom);

/// The start of that by least squares; the root mean square and the sums of an error at given parameters: see
/// fit/least_squares/least_squares.hpp.
Candidate start_of_minimax(const AnyFamily& family, const Metric& metric);
Sums<double> sums_of(const AnyFamily& family, const Metric& metric, std::span<const double> parameters);
double rms_of(const AnyFamily& family, const Metric& metric, std::span<const double> parameters);

}  // namespace shadefit
