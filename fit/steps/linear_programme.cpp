#include "fit/steps/linear_programme.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadefit {
namespace {

/// Two to ten exchanges are usual. Sixty, and two for each condition, end a cycle.
constexpr std::size_t least_cycle = 60;
/// A condition counts as violated from here on: the elimination leaves this much of an equality. A condition
/// on the error is relative to the largest bound of these, or to the level. A constraint has the unit of the
/// form or of its logarithm, and is relative to 1 or to its own bound.
constexpr double violation_floor = 1e-13;

/// A condition can leave if its share is more than this part of the largest one. With a smaller one the next
/// reference is dependent up to rounding.
constexpr double pivot_floor = 1e-10;

/// What the conditions of a cycle may exceed the answer by, relative to the largest bound or to the level.
constexpr double cycle_excess = 1e-9;

double product(const Unknowns& a, const Unknowns& b, std::size_t size) {
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

bool invert(const SmallMatrix& matrix, std::size_t size, SmallMatrix& inverse) {
  SmallMatrix m = matrix;
  // Columns are brought to one scale: parameters differ by orders of magnitude.
  Unknowns scale{};
  for (std::size_t j = 0; j < size; ++j) {
    double largest = 0;
    for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, std::abs(m[i][j]));
    if (!(largest > 0) || !std::isfinite(largest)) return false;
    scale[j] = 1 / largest;
    for (std::size_t i = 0; i < size; ++i) m[i][j] *= scale[j];
  }
  // Gauss-Jordan in place: each pivot's row and column are exchanged for those of the inverse.
  std::array<std::size_t, most_unknowns> row_of{}, column_of{};
  std::array<bool, most_unknowns> row_done{}, column_done{};
  double first = 0;
  for (std::size_t step = 0; step < size; ++step) {
    std::size_t row = 0, column = 0;
    double pivot = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (row_done[i]) continue;
      for (std::size_t j = 0; j < size; ++j) {
        if (!column_done[j] && std::abs(m[i][j]) > std::abs(pivot)) pivot = m[row = i][column = j];
      }
    }
    if (step == 0) first = std::abs(pivot);
    if (!(std::abs(pivot) > 1e-13 * first)) return false;
    row_done[row] = column_done[column] = true;
    row_of[column] = row;
    column_of[row] = column;
    for (std::size_t i = 0; i < size; ++i) {
      if (i == row) continue;
      const double factor = m[i][column] / pivot;
      for (std::size_t j = 0; j < size; ++j) {
        if (j != column) m[i][j] -= factor * m[row][j];
      }
      m[i][column] = -factor;
    }
    for (std::size_t j = 0; j < size; ++j) {
      if (j != column) m[row][j] /= pivot;
    }
    m[row][column] = 1 / pivot;
  }
  // m maps a right-hand side at the rows to unknowns at the columns, each at its pivot's place.
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) inverse[i][j] = scale[i] * m[row_of[i]][column_of[j]];
  }
  return true;
}

LowestLevel lowest_level(std::span<const Condition> conditions, std::size_t unknowns,
                         std::span<const std::size_t> first_reference, double rounding) {
  LowestLevel result;
  std::ranges::copy(first_reference, result.reference.begin());
  double largest_bound = 0;
  for (const Condition& condition : conditions) {
    if (condition.slope[unknowns - 1] != 0)
      largest_bound = std::max(largest_bound, std::abs(condition.bound));
  }

  const std::size_t most_exchanges = std::max(least_cycle, 2 * conditions.size());
  for (std::size_t exchange = 0; exchange < most_exchanges; ++exchange) {
    SmallMatrix matrix{}, inverse{};
    Unknowns bounds{};
    for (std::size_t i = 0; i < unknowns; ++i) {
      const Condition& condition = conditions[result.reference[i]];
      matrix[i] = condition.slope;
      bounds[i] = condition.bound;
    }
    if (!invert(matrix, unknowns, inverse)) {
      result.ending = LowestLevel::Ending::degenerate;
      return result;
    }
    for (std::size_t i = 0; i < unknowns; ++i) result.unknowns[i] = product(inverse[i], bounds, unknowns);
    // sum of multiplier * slope = -(0, .., 0, 1), the direction of a falling level
    for (std::size_t i = 0; i < unknowns; ++i) result.multipliers[i] = -inverse[unknowns - 1][i];

    std::size_t entering = conditions.size();
    double most = 0;
    for (std::size_t j = 0; j < conditions.size(); ++j) {
      const auto end = result.reference.begin() + static_cast<std::ptrdiff_t>(unknowns);
      if (conditions[j].is_equation || std::find(result.reference.begin(), end, j) != end) continue;
      const double excess = product(conditions[j].slope, result.unknowns, unknowns) - conditions[j].bound;
      const double size = conditions[j].slope[unknowns - 1] != 0
                              ? std::max(largest_bound, std::abs(result.unknowns[unknowns - 1]))
                              : std::max(1.0, std::abs(conditions[j].bound));
      if (excess > most && excess > std::max(violation_floor * size, rounding)) {
        most = excess;
        entering = j;
      }
    }
    // References that differ by rounding follow each other in a cycle: each of them is the answer.
    const bool is_cycle =
        exchange + 1 == most_exchanges &&
        most <= cycle_excess * std::max(largest_bound, std::abs(result.unknowns[unknowns - 1]));
    if (entering == conditions.size() || is_cycle) {
      result.ending = LowestLevel::Ending::found;
      return result;
    }

    // The entering slope as a sum of the reference's: shares.
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t leaving = unknowns;
    Unknowns shares{};
    double largest_share = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t j = 0; j < unknowns; ++j) shares[i] += conditions[entering].slope[j] * inverse[j][i];
      largest_share = std::max(largest_share, std::abs(shares[i]));
    }
    for (std::size_t i = 0; i < unknowns; ++i) {
      if (conditions[result.reference[i]].is_equation || !(shares[i] > pivot_floor * largest_share)) continue;
      const double ratio = std::max(0.0, result.multipliers[i]) / shares[i];
      if (ratio < smallest) {
        smallest = ratio;
        leaving = i;
      }
    }
    if (leaving == unknowns) {
      result.ending = LowestLevel::Ending::infeasible;
      return result;
    }
    result.reference[leaving] = entering;
  }
  return result;
}

}  // namespace shadefit
