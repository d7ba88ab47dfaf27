#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fit/steps/sums.hpp"

/// The linear programme of a minimax fit: the lowest level under conditions that are linear in a step of the
/// parameters, solved by exchanging one condition of a reference at a time.
namespace shadefit {

/// The parameters of a form and the level.
inline constexpr std::size_t most_unknowns = most_fitted + 1;

using Unknowns = std::array<double, most_unknowns>;

/// A square matrix. Entries beyond its size are not used.
using SmallMatrix = std::array<Unknowns, most_unknowns>;

/// The inverse of the leading `size` rows and columns by elimination with full pivoting. False if a pivot is
/// below 1e-13 of the first: it would be rounding.
bool invert(const SmallMatrix& matrix, std::size_t size, SmallMatrix& inverse);

/// slope . x <= bound, or = bound. The last unknown is the level; the others are the step of the parameters.
struct Condition {
  Unknowns slope{};
  double bound = 0;
  bool is_equation = false;
};

/// The end of a programme: the reference and its multipliers. A reference has as many conditions as there are
/// unknowns, and the answer meets them with equality. The multipliers are Lagrange's; those of conditions on
/// the error are Kolmogorov's weights, and their sum is 1.
struct LowestLevel {
  enum class Ending {
    found,       ///<
    infeasible,  ///< no step satisfies all conditions
    degenerate,  ///< the conditions of a reference are linearly dependent
    unfinished,  ///< the cap on exchanges
  };
  Ending ending = Ending::unfinished;
  Unknowns unknowns{};
  std::array<std::size_t, most_unknowns> reference{};  ///< places in the list of conditions
  Unknowns multipliers{};
};

/// The smallest level under the conditions, from a reference whose inequalities have multipliers >= 0.
///
/// Each exchange brings the condition into the reference that its solution violates most. The condition whose
/// multiplier falls to zero first leaves it. This is Stiefel's exchange, the dual simplex method. The level
/// rises with each exchange. Source: Stiefel 1960, "Note on Jordan elimination, linear programming and
/// Tchebycheff approximation", Numerische Mathematik 2.
///
/// A condition on the error counts as violated if it is by more than `rounding`, that of the errors.
LowestLevel lowest_level(std::span<const Condition> conditions, std::size_t unknowns,
                         std::span<const std::size_t> first_reference, double rounding = 0);

}  // namespace shadefit
