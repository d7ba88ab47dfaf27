#include "fit/study_squares/linear_optimum.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "fit/scalars/multiprecision.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decompositions.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

using Row = std::vector<Decimal50>;

/// The sums of weight * u * v over the nodes, for u and v the derivatives of the error by the parameters, and
/// last the error itself.
class WideSums {
 public:
  WideSums(const ReadStudy& study, const StudyNodes& nodes)
      : nodes_(nodes),
        count_(study.parameters.size()),
        inputs_(count_ + nodes.coordinates.size()),
        program_(tape_of(error_formula(study), names(study), count_), {}) {}

  std::vector<Row> operator()(const Row& parameters) {
    std::vector<Row> sums(count_ + 1, Row(count_ + 1));
    std::ranges::copy(parameters, inputs_.begin());
    for (std::size_t n = 0; n < nodes_.weights.size(); ++n) {
      for (std::size_t i = 0; i < nodes_.coordinates.size(); ++i)
        inputs_[count_ + i] = nodes_.coordinates[i][n];
      program_.run(inputs_);
      for (std::size_t i = 0; i <= count_; ++i) {
        const Decimal50 weighted = Decimal50(nodes_.weights[n]) * column(i);
        for (std::size_t j = 0; j <= i; ++j) sums[i][j] += weighted * column(j);
      }
    }
    for (std::size_t i = 0; i <= count_; ++i)
      for (std::size_t j = 0; j < i; ++j) sums[j][i] = sums[i][j];
    return sums;
  }

 private:
  static std::vector<std::string> names(const ReadStudy& study) {
    std::vector<std::string> result = study.parameters;
    std::ranges::copy(node_variables(study), std::back_inserter(result));
    return result;
  }
  /// The first output is the error.
  const Decimal50& column(std::size_t i) const { return program_.output((i + 1) % (count_ + 1)); }

  const StudyNodes& nodes_;
  std::size_t count_;
  Row inputs_;
  TapeProgram<Decimal50> program_;
};

/// Replaces a positive definite matrix, the sums without their last row and column, by its inverse; that
/// column by minus the solution (Gauss, Jordan). False if a column is a combination of those before it.
bool invert_in_place(std::vector<Row>& a) {
  const Decimal50 independent("1e-45");  // of 50 digits, less those that the sums lose
  const std::size_t n = a.size() - 1;
  Row diagonal;
  for (std::size_t k = 0; k < n; ++k) diagonal.push_back(a[k][k]);
  for (std::size_t k = 0; k < n; ++k) {
    if (!(a[k][k] > independent * diagonal[k])) return false;
    const Decimal50 inverse = 1 / a[k][k];
    a[k][k] = 1;
    for (Decimal50& x : a[k]) x *= inverse;
    for (std::size_t i = 0; i <= n; ++i) {
      if (i == k) continue;
      const Decimal50 factor = a[i][k];
      a[i][k] = 0;
      for (std::size_t j = 0; j <= n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return true;
}

}  // namespace

std::optional<LinearOptimum> optimum_in_50_digits(const ReadStudy& study, const StudyNodes& nodes,
                                                  const std::vector<double>& start) {
  // A linear form takes one step to its 50 digits, a curved one as many as still fall.
  constexpr int most_rounds = 20;
  constexpr long double falls = 0.8L;
  WideSums sums_at(study, nodes);
  Row at(start.begin(), start.end());
  const std::size_t n = at.size();
  LinearOptimum found;
  for (LinearOptimum::Vector* v : {&found.parameters, &found.last_step, &found.spread})
    v->resize(static_cast<Eigen::Index>(n));
  long double last = HUGE_VALL;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Row> sums = sums_at(at);
    found.square = static_cast<long double>(sums[n][n]);
    if (!std::isfinite(found.square) || !invert_in_place(sums)) return std::nullopt;
    long double longest = 0;  // by how far it moves the form: a root mean square
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      at[i] -= sums[i][n];
      found.parameters[k] = static_cast<long double>(at[i]);
      found.last_step[k] = static_cast<long double>(sums[i][n]);
      found.spread[k] = std::sqrt(static_cast<long double>(sums[i][i]));
      longest = std::max(longest, std::abs(found.last_step[k]) / found.spread[k]);
    }
    if (longest >= falls * last) break;
    last = longest;
  }
  return found;
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target) {
  return solution(pivoted_qr(columns), target);
}

}  // namespace shadefit
