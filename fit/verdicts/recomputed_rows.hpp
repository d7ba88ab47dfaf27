#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/support/checkpoint.hpp"

/// Checks a table of truth against the formula that it was computed from.
namespace shadefit {

/// A row whose value differs from that of the formula.
struct WrongRow {
  std::size_t row;  ///< from 1
  double value, recomputed;
};

struct RecomputedRows {
  std::size_t drawn = 0;  ///< how many rows were recomputed
  std::vector<WrongRow> wrong = {};
};

/// Draws 1 % of the rows, at least five, or all if there are fewer, as `drawn_from` does. Rows count from 1.
std::vector<std::size_t> drawn_rows(std::size_t count);

/// How far a row may be from its formula, relative to the largest value of the table. Tables have 12 digits,
/// as truths have (docs/truths.md); a formula such as albedo - bias may lose two of them.
inline constexpr double rows_agree = 1e-10;

/// Recomputes the drawn rows of a study, in 50 digits except for truths that are integrals. NaN agrees with
/// no row. Throws UserError for a formula that cannot be read.
RecomputedRows recompute_rows(const Study& study, const std::string& formula,
                              const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
