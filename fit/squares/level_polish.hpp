#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/study/study_problem.hpp"

/// The end of a minimax fit: Newton's method on its conditions of optimality.
namespace shadefit {

/// A row, or a top, that determines a level, the sign of its error, and its multiplier.
struct LevelRow {
  std::size_t row;
  double sign;
  double multiplier;
  std::optional<double> held = std::nullopt;  ///< the earlier level where the row stays
};

/// Parameters where some rows are at one level, others stay at earlier ones, and no small step lowers the
/// level:
///   sign_i error_i = level, or its held level;
///   sum of multiplier_i sign_i slope_i = 0, where the multipliers of the rows that are not held sum to 1.
/// If these multipliers are >= 0, this is Kolmogorov's criterion; it is also that of Lagrange. Source: Watson
/// 1980, "Approximation Theory and Numerical Methods".
struct PolishedLevel {
  std::vector<double> parameters;
  double level = 0;
  std::vector<LevelRow> rows;
  int digits = 0;  ///< of the worst parameter, by a Newton step with residuals in long double
  /// The least curvature of the sum of multiplier_i sign_i error_i along steps that do not change these
  /// errors, in units of `steps` and of the level. Infinite if there is no such step.
  double bend = 0;
};

/// A smaller curvature is the rounding of 0.
inline constexpr double no_bend = 1e-7;

/// The errors that are at a level, in the order of its rows: those of rows, or of tops, which move with the
/// parameters.
struct LevelPoints {
  /// The errors and their slopes by the parameters. At a top the slope of the height is that at its place.
  std::function<void(std::span<const double>, VectorOf<double>&, MatrixOf<double>&)> errors;
  std::function<void(std::span<const long double>, VectorOf<long double>&, MatrixOf<long double>&)> wide;
  /// The second derivatives of the sum of share * error, along the columns of `steps`.
  std::function<MatrixOf<double>(std::span<const double> parameters, std::span<const double> shares,
                                 const MatrixOf<double>& steps)>
      curvature;
};

/// Some of these nodes.
LevelPoints points_of_rows(const StudyError& error, const StudyNodes& all_rows,
                           const std::vector<LevelRow>& rows);

/// Newton's method on these equations. A column of `steps` is a direction of the parameters that changes the
/// errors by about `level`. Empty if it does not settle, or if a multiplier of the level becomes negative.
std::optional<PolishedLevel> polish_level(const LevelPoints& points, const MatrixOf<double>& steps,
                                          std::vector<double> parameters, double level,
                                          std::vector<LevelRow> rows);

}  // namespace shadefit
