#include "fit/verdicts/recomputed_rows.hpp"

#include <algorithm>
#include <cmath>

#include "fit/scalars/in_50_digits.hpp"

namespace shadefit {
namespace {

double value_at(const Symbolic& formula, const Study& study, std::size_t row) {
  return static_cast<double>(in_50_digits(formula, [&](const std::string& name) {
    std::size_t i = 0;
    while (study.over[i].variable != name) ++i;
    return Decimal50(study.rows->places[i][row - 1]);
  }));
}

}  // namespace

std::vector<std::size_t> drawn_rows(std::size_t count) {
  const std::size_t drawn = std::min(count, std::max<std::size_t>(5, (count + 99) / 100));
  std::vector<std::size_t> rows = drawn_from(count, drawn);
  for (std::size_t& row : rows) ++row;
  return rows;
}

RecomputedRows recompute_rows(const Study& study, const std::string& formula, const Checkpoint& checkpoint) {
  const Symbolic truth = read_recompute(study, formula);
  const std::vector<double>& values = study.rows->value;
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  RecomputedRows result;
  for (const std::size_t row : drawn_rows(values.size())) {
    checkpoint();
    ++result.drawn;
    const double value = values[row - 1], recomputed = value_at(truth, study, row);
    if (!(std::abs(value - recomputed) <= rows_agree * largest))
      result.wrong.push_back({row, value, recomputed});
  }
  return result;
}

}  // namespace shadefit
