#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "approx/scalar.hpp"
#include "fit/metric.hpp"
#include "fit/symbolic.hpp"

/// What multiplies the error of a fit at a place: a user's formula in the cosine c, such as "1 + 4 c".
namespace shadefit {

class Weight {
 public:
  /// Everywhere 1.
  Weight() = default;

  /// By `parse_formula`, of the variable c; an empty text is 1. Throws std::invalid_argument with one line
  /// that says what was expected where.
  explicit Weight(std::string_view text);

  bool is_one() const { return !formula_; }

  template <class T>
  T at(const T& cos_theta) const {
    if (!formula_) return integer<T>(1);
    return evaluate<T>(*formula_, [&](const std::string&) { return cos_theta; });
  }

 private:
  std::optional<Symbolic> formula_ = std::nullopt;
};

/// A place where a weight is no weight, and what it is there.
struct WeightFault {
  double cosine;
  double value;
};

/// Where a weight is not finite, not above 1e-12 of its largest value, or of the other sign; empty where it
/// is positive. Sampled: at the `search_points` and both ends of the domain, and at its minima between them.
std::optional<WeightFault> find_fault(const Weight& weight, const Domain& domain);

}  // namespace shadefit
