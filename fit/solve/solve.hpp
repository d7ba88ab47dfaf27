#pragma once

#include <array>
#include <tuple>
#include <variant>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/families/families.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/solve/solution.hpp"

/// The solvers of a family. Each is compiled in its own unit: in one unit the compiler inlines less, and a
/// plain fit takes 1.5 times as long.
namespace shadefit {

template <class List>
struct OneOf;
template <class... F>
struct OneOf<std::tuple<F...>> {
  using type = std::variant<F...>;
};

/// Any of the `Families`, with its setting. The solvers are compiled for each of them.
using AnyFamily = OneOf<Families>::type;

/// Plain least squares: of the absolute error, without weight, with all parameters free.
Solution solve_plain(const AnyFamily& family, const Metric& metric);

/// The same from given starts: three points, each with one number per parameter of the family.
Solution solve_plain_from(const AnyFamily& family, const Metric& metric,
                          const std::array<std::vector<double>, 3>& starts);

/// A family under a metric, between the places `top` and `bottom`.
Solution solve_under(const AnyFamily& family, const Metric& metric, const Cosine<double>& top,
                     const Cosine<double>& bottom);

}  // namespace shadefit
