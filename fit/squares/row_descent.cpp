#include "fit/squares/row_descent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/steps/quadratic_programme.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// Newton's method starts when the programme and the rows agree on the level to this share of it.
constexpr double agree = 1e-10;
/// A row within this share of the level is at the level.
constexpr double same_level = 1e-9;

bool holds(const std::vector<LevelRow>& rows, const LevelRow& one) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const LevelRow& row) { return row.row == one.row && row.sign == one.sign; });
}

bool are_same(const std::vector<LevelRow>& a, const std::vector<LevelRow>& b) {
  return a.size() == b.size() &&
         std::all_of(a.begin(), a.end(), [&](const LevelRow& row) { return holds(b, row); });
}

/// sign * error <= level after a step, in units of the level. The level is the last unknown. A held row is an
/// equation.
Condition condition_of(const LevelRow& row, const RowErrors& at, const Matrix& slopes) {
  const auto i = static_cast<Eigen::Index>(row.row);
  Condition condition{
      {}, (row.held.value_or(0) - row.sign * at.errors[i]) / at.largest, row.held.has_value()};
  for (Eigen::Index j = 0; j < slopes.cols(); ++j)
    condition.slope[static_cast<std::size_t>(j)] = row.sign * slopes(i, j);
  condition.slope[static_cast<std::size_t>(slopes.cols())] = row.held ? 0 : -1;
  return condition;
}

std::vector<LevelRow> rows_of(const RowStage& stage) {
  std::vector<LevelRow> rows = stage.held;
  for (std::size_t i = 0; i < stage.ceilings.size(); ++i) {
    if (stage.counts(i))
      for (const double sign : {1.0, -1.0}) rows.push_back({i, sign, 0});
  }
  return rows;
}

/// The curvature without its negative parts. A larger `shortening` adds curvature in all directions: the step
/// becomes shorter.
Matrix convex(const Matrix& curvature, double shortening) {
  const auto values = eigen_of(curvature);
  const Vector raised = values.eigenvalues().cwiseMax(0).array() + shortening;
  return values.eigenvectors() * raised.asDiagonal() * values.eigenvectors().transpose();
}

/// The step of the quadratic programme. Its objective is level + level^2/2 + step^T curvature step, all in
/// units of the present level: near 1 that is twice level + step^T curvature step/2, and it is strictly
/// convex.
std::optional<RowStep> row_step(const RowErrors& at, const RowStage& stage, const RowModel& model) {
  const Eigen::Index n = model.steps.cols();
  const Matrix slopes = at.slopes * model.steps / at.largest;
  const std::vector<LevelRow> rows = rows_of(stage);
  std::vector<Condition> conditions;
  for (const LevelRow& row : rows) conditions.push_back(condition_of(row, at, slopes));
  Matrix hessian = Matrix::Identity(n + 1, n + 1);
  hessian.topLeftCorner(n, n) = 2 * model.curvature;
  const auto found = least_step(hessian, Vector::Unit(n + 1, n), conditions);
  if (!found || !found->step.allFinite()) return std::nullopt;

  const Vector moved = model.steps * found->step.head(n);
  RowStep result{moved_by(moved, at.parameters), found->step[n] * at.largest, {}};
  double sum = 0;
  for (const ActiveCondition& active : found->active)
    if (!rows[active.condition].held) sum += active.multiplier;
  if (!(sum > 0)) return std::nullopt;
  for (const ActiveCondition& active : found->active) {
    LevelRow row = rows[active.condition];
    row.multiplier = active.multiplier / sum;
    constexpr double none = 1e-12;  // the rounding of 0
    if (row.held || row.multiplier > none) result.rows.push_back(row);
  }
  return result;
}

/// The errors with their curvature on the way to a trial, so that the programme takes it into account: it
/// differs from row to row. Source: Fletcher 1982, "Second order corrections for non-differentiable
/// optimization", Lecture Notes in Mathematics 912.
RowErrors bent(const RowErrors& at, const RowErrors& trial) {
  RowErrors result = at;
  const Vector step = vector_of(trial.parameters) - vector_of(at.parameters);
  result.errors = trial.errors - at.slopes * step;
  return result;
}

}  // namespace

Matrix row_directions(const Matrix& slopes, double unit) {
  const Eigen::Index n = slopes.cols();
  const Vector sizes = slopes.colwise().norm();
  const Vector scale = (sizes.array() > 0).select(sizes.cwiseInverse(), 0);
  constexpr double rounding = 1e-12;  // of the slopes
  const PivotedQr qr = pivoted_qr(slopes * scale.asDiagonal(), rounding);
  const Eigen::Index rank = qr.rank();
  const Matrix triangle = qr.matrixR().topLeftCorner(rank, rank);
  Matrix steps = Matrix::Zero(n, rank);
  steps.topRows(rank) = triangle.triangularView<Eigen::Upper>().solve(Matrix(Matrix::Identity(rank, rank)));
  steps = scale.asDiagonal() * Matrix(qr.colsPermutation() * steps);
  return steps * (unit * std::sqrt(static_cast<double>(slopes.rows())));
}

double RowDescent::rounding(const RowErrors& at) const {
  return 2e-15 * std::max(sampled_.target_norm(), at.errors.cwiseAbs().maxCoeff());
}

RowErrors RowDescent::errors_at(const std::vector<double>& parameters, const RowStage& stage) const {
  RowErrors result{parameters, {}, {}};
  sampled_.errors(parameters, result.errors, &result.slopes);
  const double slack = rounding(result);
  for (std::size_t i = 0; i < stage.ceilings.size(); ++i) {
    const double size = std::abs(result.errors[static_cast<Eigen::Index>(i)]);
    const bool is_over = size > stage.ceilings[i] * (1 + same_level) + slack;
    if (is_over) result.largest = HUGE_VAL;
    if (stage.counts(i)) result.largest = std::max(result.largest, size);
  }
  if (!result.errors.allFinite() || !result.slopes.allFinite() || sampled_.has_pole(parameters))
    result.largest = HUGE_VAL;
  return result;
}

RowModel RowDescent::model_at(const RowErrors& at, const std::vector<LevelRow>& rows,
                              double shortening) const {
  RowModel model{row_directions(at.slopes, at.largest), {}};
  std::vector<double> shares(nodes_.weights.size(), 0);
  for (const LevelRow& row : rows) shares[row.row] += row.multiplier * row.sign / at.largest;
  const Matrix curvature = sampled_.curvature(at.parameters, shares);
  model.curvature = convex(model.steps.transpose() * curvature * model.steps, shortening);
  return model;
}

std::optional<PolishedLevel> RowDescent::polished(const RowErrors& at, const RowStage& stage,
                                                  const MatrixOf<double>& steps, double promised,
                                                  const std::vector<LevelRow>& rows) const {
  auto level = polish_level(points_of_rows(error_, nodes_, rows), steps, at.parameters, promised, rows);
  if (!level) return std::nullopt;
  const RowErrors there = errors_at(level->parameters, stage);
  const double least = std::min(level->level, at.largest);
  return there.largest <= least * (1 + same_level) + rounding(there) ? level : std::nullopt;
}

RowErrors RowDescent::moved(const RowErrors& at, const RowStage& stage, const RowModel& model,
                            const RowStep& step) const {
  RowErrors there = errors_at(step.to, stage);
  constexpr double nearly = 0.75;
  const double wanted = at.largest - nearly * (at.largest - step.promised);
  if (there.largest <= wanted || std::isinf(there.largest)) return there;
  const auto corrected = row_step(bent(at, there), stage, model);
  if (!corrected) return there;
  RowErrors again = errors_at(corrected->to, stage);
  return again.largest < there.largest ? again : there;
}

DescentEnd RowDescent::operator()(const std::vector<double>& start, const RowStage& stage,
                                  const Checkpoint& checkpoint) const {
  constexpr int most_passes = 200;
  constexpr double least_shortening = 1e-4, most_shortening = 1e8;
  RowErrors at = errors_at(start, stage);
  double shortening = 1e-2;
  std::vector<LevelRow> rows;  // of the last step, with their multipliers
  bool meets_border = std::isinf(at.largest);
  const auto ended = [&](std::string why) { return DescentEnd{at, std::nullopt, std::move(why)}; };
  for (int pass = 0; pass < most_passes && shortening <= most_shortening && std::isfinite(at.largest);
       ++pass) {
    checkpoint();
    if (!(at.largest > 1e-14 * sampled_.target_norm()))
      return ended("the largest error is down to the rounding of the form: it has no level");
    const RowModel model = model_at(at, rows, shortening);
    const auto step = row_step(at, stage, model);
    if (!step) {
      shortening *= 10;
      continue;
    }
    const double gain = at.largest - step->promised;
    const bool is_level = gain <= agree * at.largest + rounding(at);
    if (is_level || are_same(rows, step->rows)) {
      const auto level = polished(at, stage, model.steps, step->promised, step->rows);
      if (level) return {errors_at(level->parameters, stage), level, ""};
    }
    if (is_level) return ended("Newton's method does not settle on the rows at the level");
    rows = step->rows;
    RowErrors next = moved(at, stage, model, *step);
    meets_border = std::isinf(next.largest);
    const double share = (at.largest - next.largest) / gain;
    if (share < 0.25) shortening *= 4;
    if (share > 0.75) shortening = std::max(shortening / 4, least_shortening);
    if (share > 1e-3) at = std::move(next);
  }
  return ended(meets_border
                   ? "the level falls, below " + decimal(at.largest, 4) + ", as the form nears a pole"
                   : "the level, about " + decimal(at.largest, 4) +
                         ", does not fall as the slopes of the form promise: it has a kink at a row");
}

}  // namespace shadefit
