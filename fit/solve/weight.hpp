#pragma once

#include <array>
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

/// What multiplies the error of a fit at a place: a user's formula in the cosine c, such as "1 + 4 c".
namespace shadefit {

class Weight {
 public:
  /// Everywhere 1.
  Weight() = default;

  /// By `parse_formula`, of the variable c; an empty text is 1. Throws std::invalid_argument with one line
  /// that says what was expected where.
  explicit Weight(std::string_view text, const Domain& domain = {});

  bool is_one() const { return !formula_; }
  const Domain& domain() const { return domain_; }

  /// Where the formula is not smooth inside its domain or at its ends, in falling order: where the two sides
  /// of a choice, min or max are equal, and where a root, power or logarithm is one of zero. Found by their
  /// signs between the `search_points`, refined to neighbouring doubles; what changes its sign twice between
  /// two of them and has no extremum there is missed.
  const std::vector<Shape::Edge>& edges() const { return edges_; }

  /// A place where it divides by zero, or takes the logarithm of it.
  const std::optional<double>& pole() const { return pole_; }

  /// The value at a cosine. Rounding may carry a place beyond an end of the domain, where sqrt(0.25 - c^2) is
  /// not defined: the end stands for it.
  template <class T>
  T at(const T& cos_theta) const {
    if (!formula_) return integer<T>(1);
    const T inside = max(min(cos_theta, lift<T>(domain_.upper)), lift<T>(domain_.lower));
    return evaluate<T>(*formula_, [&](const std::string&) { return inside; });
  }

 private:
  std::optional<Symbolic> formula_ = std::nullopt;
  Domain domain_ = {};
  std::vector<Shape::Edge> edges_ = {};
  std::optional<double> pole_ = std::nullopt;
};

/// A weight alone, as a family without parameters that count: its error is the weight itself.
struct WeightItself {
  static constexpr std::array<std::string_view, 1> parameters{};

  Weight weight;

  template <class T>
  struct Sample {
    T weight;
  };
  template <class T>
  Sample<T> sample(const Cosine<T>& c) const {
    return {weight.at(c.cos_theta)};
  }
  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, 1>&) const {
    return lift<P>(s.weight);
  }
  Shape shape() const { return {.edges = weight.edges()}; }
};

/// The most edges that a weight may have: each is one more panel of every sum.
inline constexpr std::size_t most_edges = 64;

/// The largest value of a weight lies between this and its inverse: its square, and that of the small errors
/// that it multiplies, is a double.
inline constexpr double largest_weight = 1e100;

/// Why a formula is no weight on its domain, as the end of a sentence that begins with it: "is -0.5 at c = 0:
/// it must not be negative". Empty where it is finite, nowhere negative, and zero at single places only. What
/// is negative or zero is decided in 50 digits. Sampled: at the `search_points`, at both ends, at the edges
/// and half-way between them, and at the minima between these.
std::optional<std::string> find_fault(const Weight& weight);

}  // namespace shadefit
