#include "fit/squares/linear_optimum.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

// Rows of numbers: Eigen's templates over 50 digits take longer to compile than all else here.
using Square = std::vector<std::vector<Decimal50>>;

/// The inverse of a positive definite matrix, by Gauss and Jordan in place.
Square inverse_of(Square a) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Decimal50 pivot = 1 / a[k][k];
    a[k][k] = 1;
    for (Decimal50& value : a[k]) value *= pivot;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (i == k) continue;
      const Decimal50 factor = a[i][k];
      a[i][k] = 0;
      for (std::size_t j = 0; j < a.size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return a;
}

/// The target at each node: it is the same for all parameters.
std::vector<Decimal50> target_at(const ReadStudy& study, const StudyNodes& nodes) {
  TapeProgram<Decimal50> program(tape_of(study.target, node_variables(study)), {});
  std::vector<Decimal50> at(nodes.coordinates.size()), values;
  for (std::size_t node = 0; node < nodes.weights.size(); ++node) {
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = nodes.coordinates[i][node];
    program.run(at);
    values.push_back(program.output(0));
  }
  return values;
}

}  // namespace

std::optional<LinearOptimum> optimum_in_50_digits(const ReadStudy& study, const StudyNodes& nodes,
                                                  const std::vector<double>& start) {
  // A linear form takes one step to its 50 digits, a curved one as many as still fall. A step of this share
  // of the first one moves no digit of a double.
  constexpr int most_rounds = 20;
  constexpr long double falls = 0.8L, enough = 1e-24L, dependent = 1e45L;
  const std::size_t n = start.size();
  std::vector<std::string> names = study.parameters;
  std::ranges::copy(node_variables(study), std::back_inserter(names));
  ReadStudy of_values = study;
  const std::string target = " target";  // no variable has this name
  of_values.target = Symbolic::variable(target);
  names.push_back(target);
  const std::vector<Decimal50> targets = target_at(study, nodes);
  TapeProgram<Decimal50> program(tape_of(error_formula(of_values), names, n), {});
  std::vector<Decimal50> at(start.begin(), start.end());
  at.resize(names.size());
  LinearOptimum found;
  long double first = 0;
  for (long double last = HUGE_VALL, moved = 0, round = 0; round < most_rounds; ++round, last = moved) {
    Square hessian(n, std::vector<Decimal50>(n));
    std::vector<Decimal50> gradient(n);
    Decimal50 square = 0;
    for (std::size_t node = 0; node < nodes.weights.size(); ++node) {
      for (std::size_t i = n; i + 1 < at.size(); ++i) at[i] = nodes.coordinates[i - n][node];
      at.back() = targets[node];
      program.run(at);
      const Decimal50 error = nodes.weights[node] * program.output(0);
      square += error * program.output(0);
      for (std::size_t i = 0; i < n; ++i) {
        gradient[i] += error * program.output(i + 1);
        const Decimal50 slope = nodes.weights[node] * program.output(i + 1);
        for (std::size_t j = 0; j < n; ++j) hessian[i][j] += slope * program.output(j + 1);
      }
    }
    const Square inverse = inverse_of(hessian);
    const auto count = static_cast<Eigen::Index>(n);
    found = {VectorOf<long double>(count), VectorOf<long double>(count), VectorOf<long double>(count),
             static_cast<long double>(square)};
    long double condition = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Decimal50 step = 0;
      for (std::size_t j = 0; j < n; ++j) step += inverse[i][j] * gradient[j];
      at[i] -= step;
      const auto place = static_cast<Eigen::Index>(i);
      found.last_step[place] = static_cast<long double>(step);
      found.spread[place] = std::sqrt(static_cast<long double>(inverse[i][i]));
      found.parameters[place] = static_cast<long double>(at[i]);
      const long double size = std::sqrt(static_cast<long double>(hessian[i][i]));
      condition = std::max(condition, found.spread[place] * size);
      if (!std::isfinite(found.spread[place])) return std::nullopt;
    }
    if (!std::isfinite(found.square) || !(condition * condition < dependent)) return std::nullopt;
    moved = found.last_step.cwiseQuotient(found.spread).cwiseAbs().maxCoeff();
    if (round == 0) first = moved;
    if (!(moved < falls * last) || moved <= enough * first) break;
  }
  return found;
}

}  // namespace shadefit
