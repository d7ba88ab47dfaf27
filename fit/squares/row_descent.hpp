#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fit/squares/level_polish.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// Which rows determine a level.
struct RowStage {
  /// For each row the earlier level that its error may not exceed; infinite if the error counts.
  std::vector<double> ceilings;
  std::vector<LevelRow> held;  ///< rows that stay at earlier levels; their slopes are independent

  bool counts(std::size_t row) const { return std::isinf(ceilings[row]); }
};

/// The errors of all rows at some parameters.
struct RowErrors {
  std::vector<double> parameters;
  VectorOf<double> errors;
  MatrixOf<double> slopes;
  double largest =
      0;  ///< of the rows that count; infinite if the form has a pole, or a row is above its ceiling
};

/// The local model of the form in the quadratic programme.
struct RowModel {
  MatrixOf<double> steps;      ///< its directions, `row_directions`
  MatrixOf<double> curvature;  ///< along them, of the sum of the errors times their multipliers; positive
};

/// A step of the quadratic programme.
struct RowStep {
  std::vector<double> to;      ///< the parameters after it
  double promised;             ///< the level there if the form were linear
  std::vector<LevelRow> rows;  ///< the rows at this level, and the held ones
};

/// Where a descent ended, and why if there is no answer.
struct DescentEnd {
  RowErrors at;
  std::optional<PolishedLevel> answer;
  std::string why;
};

/// The descent to the least level of the rows that count.
class RowDescent {
 public:
  /// Keeps references to all arguments. The nodes of `sampled` are the rows.
  RowDescent(const StudyError& error, const StudyNodes& nodes, const SampledStudy<double>& sampled)
      : error_(error), nodes_(nodes), sampled_(sampled) {}

  /// Sequential quadratic programming: the errors are linearised, and the curvature is that of the sum of the
  /// errors times their multipliers. A step that does not lower the level as promised is shortened, as in
  /// Levenberg's method. Source: Fletcher 1987, "Practical Methods of Optimization", chapter 14.
  DescentEnd operator()(const std::vector<double>& start, const RowStage& stage,
                        const Checkpoint& checkpoint) const;

  RowErrors errors_at(const std::vector<double>& parameters, const RowStage& stage) const;

  /// The rounding of an error.
  double rounding(const RowErrors& at) const;

 private:
  RowModel model_at(const RowErrors& at, const std::vector<LevelRow>& rows, double shortening) const;
  /// The errors after a step; if they fell less than promised, after a second one with their curvature.
  RowErrors moved(const RowErrors& at, const RowStage& stage, const RowModel& model,
                  const RowStep& step) const;
  /// The level of these rows, if no row exceeds it.
  std::optional<PolishedLevel> polished(const RowErrors& at, const RowStage& stage,
                                        const MatrixOf<double>& steps, double promised,
                                        const std::vector<LevelRow>& rows) const;

  const StudyError& error_;
  const StudyNodes& nodes_;
  const SampledStudy<double>& sampled_;
};

/// Directions in which the parameters move the errors independently, one in each column: a step of 1 changes
/// the root mean square of the errors by `unit`.
MatrixOf<double> row_directions(const MatrixOf<double>& slopes, double unit);

}  // namespace shadefit
