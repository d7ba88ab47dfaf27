#include "fit/steps/quadratic_programme.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace shadefit {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr Eigen::Index dimension = 3;
constexpr unsigned condition_count = 6;

double value(const Matrix& hessian, const Vector& gradient, const Vector& step) {
  return step.dot(hessian * step) / 2 + gradient.dot(step);
}

Vector slope_of(const Condition& condition) {
  return Eigen::Map<const Vector>(condition.slope.data(), dimension);
}

/// The least value over all sets of conditions that hold with equality; infinite if none is possible.
double least_of_all_sets(const Matrix& hessian, const Vector& gradient, const std::vector<Condition>& all) {
  double least = HUGE_VAL;
  for (unsigned set = 0; set < 1u << condition_count; ++set) {
    std::vector<Condition> met;
    bool has_equations = true;
    for (unsigned i = 0; i < condition_count; ++i) {
      if (set >> i & 1u)
        met.push_back(all[i]);
      else
        has_equations = has_equations && !all[i].is_equation;
    }
    if (!has_equations || met.size() > static_cast<std::size_t>(dimension)) continue;
    const auto rows = static_cast<Eigen::Index>(met.size());
    Matrix matrix = Matrix::Zero(dimension + rows, dimension + rows);
    Vector right(dimension + rows);
    matrix.topLeftCorner(dimension, dimension) = hessian;
    right.head(dimension) = -gradient;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Condition& condition = met[static_cast<std::size_t>(i)];
      matrix.col(dimension + i).head(dimension) = slope_of(condition);
      matrix.row(dimension + i).head(dimension) = slope_of(condition).transpose();
      right[dimension + i] = condition.bound;
    }
    const Vector step = matrix.fullPivLu().solve(right).head(dimension);
    bool is_possible = true;
    for (const Condition& condition : all) {
      const double excess = slope_of(condition).dot(step) - condition.bound;
      is_possible = is_possible && (condition.is_equation ? std::abs(excess) : excess) < 1e-9;
    }
    if (is_possible) least = std::min(least, value(hessian, gradient, step));
  }
  return least;
}

// Against all sets of active conditions, one after the other.
TEST(QuadraticProgramme, FindsTheLeastOfAllActiveSets) {
  std::mt19937 random(7);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  int possible = 0;
  for (int problem = 0; problem < 400; ++problem) {
    const Matrix root = Matrix::NullaryExpr(dimension, dimension, next);
    const Matrix hessian = root * root.transpose() + 0.01 * Matrix::Identity(dimension, dimension);
    const Vector gradient = Vector::NullaryExpr(dimension, next);
    std::vector<Condition> conditions(condition_count);
    for (unsigned i = 0; i < condition_count; ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(dimension); ++j) conditions[i].slope[j] = next();
      conditions[i].bound = next();
      conditions[i].is_equation = i == 0 && problem % 3 == 0;
    }
    const double least = least_of_all_sets(hessian, gradient, conditions);
    const auto answer = least_step(hessian, gradient, conditions);
    ASSERT_EQ(answer.has_value(), least != HUGE_VAL) << problem;
    if (!answer) continue;
    ++possible;
    EXPECT_NEAR(value(hessian, gradient, answer->step), least, 1e-8 * (1 + std::abs(least))) << problem;
    // The gradient is a combination of the slopes that are met.
    Vector rest = hessian * answer->step + gradient;
    for (const auto& [index, multiplier] : answer->active) {
      rest += multiplier * slope_of(conditions[index]);
      EXPECT_TRUE(conditions[index].is_equation || multiplier >= 0) << problem;
    }
    EXPECT_LT(rest.norm(), 1e-8) << problem;
  }
  EXPECT_GT(possible, 100);
  EXPECT_LT(possible, 400);
}

}  // namespace
}  // namespace shadefit
