#include "fit/squares/linear_optimum.hpp"

#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <iterator>
#include <string>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {

std::optional<LinearOptimum> optimum_in_50_digits(const ReadStudy& study, const StudyNodes& nodes,
                                                  const std::vector<double>& start) {
  // A linear form takes one step to its 50 digits, a curved one as many as still fall. A step of this share
  // of the first one moves no digit of a double.
  constexpr int most_rounds = 20;
  constexpr long double falls = 0.8L, enough = 1e-24L, dependent = 1e45L;
  const std::size_t n = start.size();
  std::vector<std::string> names = study.parameters;
  std::ranges::copy(node_variables(study), std::back_inserter(names));
  TapeProgram<Decimal50> program(tape_of(error_formula(study), names, n), {});
  std::vector<Decimal50> at(start.begin(), start.end());
  at.resize(names.size());
  VectorOf<Decimal50> row(n + 1);  // the error and its derivatives
  LinearOptimum found;
  long double first = 0;
  for (long double last = HUGE_VALL, moved = 0, round = 0; round < most_rounds; ++round, last = moved) {
    MatrixOf<Decimal50> sums = MatrixOf<Decimal50>::Zero(row.size(), row.size());
    for (std::size_t node = 0; node < nodes.weights.size(); ++node) {
      for (std::size_t i = n; i < at.size(); ++i) at[i] = nodes.coordinates[i - n][node];
      program.run(at);
      for (std::size_t i = 0; i <= n; ++i) row[static_cast<Eigen::Index>(i)] = program.output(i);
      sums += Decimal50(nodes.weights[node]) * row * row.transpose();
    }
    const auto count = static_cast<Eigen::Index>(n);
    const MatrixOf<Decimal50> hessian = sums.bottomRightCorner(count, count), inverse = hessian.inverse();
    const VectorOf<Decimal50> step = inverse * sums.col(0).tail(count);
    found = {{},
             step.cast<long double>(),
             inverse.diagonal().cast<long double>().cwiseSqrt(),
             static_cast<long double>(sums(0, 0))};
    const VectorOf<long double> sizes = hessian.diagonal().cast<long double>().cwiseSqrt();
    const long double condition = found.spread.cwiseProduct(sizes).maxCoeff();
    if (!std::isfinite(found.square) || !(condition * condition < dependent)) return std::nullopt;
    found.parameters.resize(count);
    for (std::size_t i = 0; i < n; ++i) {
      at[i] -= step[static_cast<Eigen::Index>(i)];
      found.parameters[static_cast<Eigen::Index>(i)] = static_cast<long double>(at[i]);
    }
    moved = found.last_step.cwiseQuotient(found.spread).cwiseAbs().maxCoeff();
    if (round == 0) first = moved;
    if (!(moved < falls * last) || moved <= enough * first) break;
  }
  return found;
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target) {
  return solution(pivoted_qr(columns), target);
}

}  // namespace shadefit
