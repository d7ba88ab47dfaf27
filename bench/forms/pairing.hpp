#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "bench/forms/catalogue.hpp"
#include "fit/support/checkpoint.hpp"

/// The cheapest exp2 that is accurate enough for a form.
namespace shadefit::forms {

/// The error that exp2 may add, relative to the form's own error.
inline constexpr double allowed_addition = 0.01;

/// A form with one set of constants, and its polynomial. All errors are the largest |form - target| over c in
/// [0, 1], over all 256 codes of a gloss, and over all places of the lights.
struct Pairing {
  double own_lower = 0, own_upper = 0;  ///< with an exact exp2: proven bounds
  int degree = 0;  ///< of the cheapest polynomial that is accurate enough; 0 if there is none
  /// By degree: the proven bound with that polynomial instead of exp2, for float or for double, in exact
  /// arithmetic. For a form of the cosine, the form with the polynomial is proven as a whole, with both sides
  /// of each jump. For a decoded gloss, which uses the polynomial twice, bounds are combined. At 0: with an
  /// exact exp2.
  std::array<double, largest_exp2_degree + 1> totals{};
  /// A proven bound of the rounding if everything, including the polynomial, is computed in float. Empty for
  /// lights: there the cosine is a product of rounded vectors, which changes the target as much as the form.
  std::optional<double> rounding = std::nullopt;

  double total() const { return totals[static_cast<std::size_t>(degree)]; }
};

/// The pairing of an exp2 form of a target; empty for all other forms. The checkpoint is called for each
/// degree.
std::optional<Pairing> pair_exp2(const Target& target, std::string_view form, const Constants& constants,
                                 const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::forms
