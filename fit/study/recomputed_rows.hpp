#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/support/checkpoint.hpp"

/// A table of truth against the formula that it was computed from.
namespace shadefit {

/// A row whose value is not that of the formula.
struct WrongRow {
  std::size_t row;  ///< from 1
  double value, recomputed;
};

struct RecomputedRows {
  std::size_t drawn = 0;  ///< how many rows were recomputed
  std::vector<WrongRow> wrong = {};
};

/// 1 % of so many rows, at least five, or all where they are fewer: one from each of equal stretches, by the
/// generator std::minstd_rand, whose numbers the standard fixes. So they are the same on each machine. Rows
/// from 1, rising.
std::vector<std::size_t> drawn_rows(std::size_t count);

/// How far a row may be from its formula, relative to the largest value of the table. Tables have 12 digits,
/// and so have truths (docs/truths.md); a formula such as albedo - bias may lose two of them.
inline constexpr double rows_agree = 1e-10;

/// Recomputes the drawn rows of a study, in 50 digits but for truths that are integrals. A value that is not
/// a number agrees with no row. Throws UserError for a formula that cannot be read.
RecomputedRows recompute_rows(const Study& study, const std::string& formula,
                              const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
