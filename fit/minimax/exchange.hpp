#pragma once

#include <array>
#include <cstddef>
#include <span>

/// The linear programme of a minimax fit: the lowest level under conditions that are linear in a step of the
/// parameters, solved by exchanging one condition of a reference at a time.
namespace shadefit {

/// The most parameters a form with a minimax fit may have: exp2 by a polynomial of degree 6 has as many.
inline constexpr std::size_t most_parameters = 6;
inline constexpr std::size_t most_unknowns = most_parameters + 1;

using Unknowns = std::array<double, most_unknowns>;

/// A square matrix of at most seven rows; what lies beyond its size is not looked at.
using SmallMatrix = std::array<Unknowns, most_unknowns>;

/// The inverse of the leading `size` rows and columns by elimination with full pivoting. False where a pivot
/// is below 1e-13 of the first: what is inverted there is rounding.
bool invert(const SmallMatrix& matrix, std::size_t size, SmallMatrix& inverse);

/// slope . x <= bound, or = bound. Of the unknowns the first are the step of the parameters, the last one is
/// the level.
struct Condition {
  Unknowns slope{};
  double bound = 0;
  bool is_equation = false;
};

/// What of a programme is known at its end: the reference, as many conditions as unknowns, which the answer
/// meets with equality, and how much each of them holds it up (Lagrange's multipliers; of the conditions on
/// the error they are Kolmogorov's weights, with the sum 1).
struct LowestLevel {
  enum class Outcome {
    found,       ///<
    infeasible,  ///< no step satisfies all conditions
    degenerate,  ///< the conditions of a reference are linearly dependent
    unfinished,  ///< the cap on exchanges
  };
  Outcome outcome = Outcome::unfinished;
  Unknowns unknowns{};
  std::array<std::size_t, most_unknowns> reference{};  ///< places in the list of conditions
  Unknowns multipliers{};
};

/// The smallest level under the conditions, from a reference whose inequalities have multipliers >= 0.
///
/// Each exchange takes the condition that the reference's solution violates most into the reference, and that
/// one out whose multiplier is the first to fall to zero: Stiefel's exchange, the dual simplex method. The
/// level rises with each. Source: Stiefel 1960, "Note on Jordan elimination, linear programming and
/// Tchebycheff approximation", Numerische Mathematik 2.
LowestLevel lowest_level(std::span<const Condition> conditions, std::size_t unknowns,
                         std::span<const std::size_t> first_reference);

}  // namespace shadefit
