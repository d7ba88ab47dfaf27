#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "approx/scalar.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/scalars/two_lanes.hpp"

/// The factor of the error of a fit: a user's formula in the cosine c, such as "1 + 4 c".
namespace shadefit {

class Weight {
 public:
  /// The weight 1.
  Weight() = default;

  /// By `parse_formula`, of the variable c; an empty text is 1. Throws std::invalid_argument with one line
  /// that names the place and what was expected there.
  explicit Weight(std::string_view text, const Domain& domain = {});

  bool is_one() const { return !formula_; }
  /// Absent if the weight is 1.
  const std::optional<Symbolic>& formula() const { return formula_; }
  const Domain& domain() const { return domain_; }

  /// The places inside the domain or at its ends where the formula is not smooth, in falling order: the two
  /// sides of a choice, min or max are equal, or the argument of a root, power or logarithm is zero. They are
  /// found by changes of sign between the `search_points` and refined to neighbouring doubles. A double
  /// change of sign between two of them, without an extremum there, is missed.
  const std::vector<Shape::Edge>& edges() const { return edges_; }

  /// A place where the formula divides by zero or takes its logarithm.
  const std::optional<double>& pole() const { return pole_; }

  /// The value at a cosine. Rounding may move a place beyond an end of the domain, where sqrt(0.25 - c^2) is
  /// not defined: then the value at the end is returned.
  /// In any scalar: a double, two of them, long double, or Jets of these.
  template <class T>
  T at(const T& cos_theta) const {
    if (is_one()) return integer<T>(1);
    if constexpr (requires { derivatives_at(cos_theta); }) {
      return derivatives_at(cos_theta)[0];
    } else if constexpr (std::same_as<T, TwoLanes>) {
      return {at(cos_theta[0]), at(cos_theta[1])};
    } else {
      return composed(derivatives_at(innermost(cos_theta)), cos_theta, 0);
    }
  }

 private:
  /// The value with its first and second derivative.
  std::array<double, 3> derivatives_at(double cos_theta) const;
  /// In long double the value with its first.
  std::array<long double, 2> derivatives_at(long double cos_theta) const;

  template <class T>
  static auto innermost(const T& x) {
    if constexpr (is_jet<T>) {
      return innermost(x.a);
    } else {
      return x;
    }
  }

  /// The derivative of that order at a Jet, by the chain rule.
  template <class Derivatives, class T>
  static T composed(const Derivatives& derivatives, const T& x, std::size_t order) {
    if constexpr (is_jet<T>) {
      return T(composed(derivatives, x.a, order),
               Scalar<T>::chain(composed(derivatives, x.a, order + 1), x.v));
    } else {
      return derivatives[order];
    }
  }

  std::optional<Symbolic> formula_ = std::nullopt;
  Domain domain_ = {};
  std::vector<Shape::Edge> edges_ = {};
  std::optional<double> pole_ = std::nullopt;
};

/// The largest number of edges. Each edge is one more panel of every sum.
inline constexpr std::size_t most_edges = 64;

/// The largest value of a weight lies between this and its inverse: then its square, times the square of a
/// small error, is a double.
inline constexpr double largest_weight = 1e100;

/// Why a formula cannot be a weight on its domain, as the end of a sentence: "is -0.5 at c = 0: it must not
/// be negative". Empty if it is finite, nowhere negative, and zero only at single places. The sign is decided
/// in 50 digits, at samples: the `search_points`, both ends, the edges, half-way between edges, and the
/// minima between these.
std::optional<std::string> find_fault(const Weight& weight);

}  // namespace shadefit
