#include "fit/squares/minimax_rows.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "fit/squares/confirm_integrals.hpp"
#include "fit/squares/row_descent.hpp"
#include "fit/squares/rules.hpp"
#include "fit/steps/digits.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Matrix = MatrixOf<double>;

/// The rows whose slopes along some steps are independent.
std::vector<LevelRow> independent(const std::vector<LevelRow>& rows, const Matrix& slopes) {
  std::vector<LevelRow> result;
  Matrix chosen(slopes.cols(), 0);
  for (const LevelRow& row : rows) {
    Matrix longer(slopes.cols(), chosen.cols() + 1);
    longer << chosen, slopes.row(static_cast<Eigen::Index>(row.row)).transpose();
    constexpr double rounding = 1e-9;  // up to which the optimum makes one slope a sum of the others
    if (pivoted_qr(longer, rounding).rank() < longer.cols() || !(longer.rightCols(1).norm() > 1e-9)) continue;
    chosen = longer;
    result.push_back(row);
  }
  return result;
}

/// A basis of the steps that leave the errors of some rows as they are.
Matrix steps_beside(const std::vector<LevelRow>& held, const Matrix& slopes) {
  Matrix columns(slopes.cols(), static_cast<Eigen::Index>(held.size()));
  for (std::size_t i = 0; i < held.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) =
        slopes.row(static_cast<Eigen::Index>(held[i].row)).transpose();
  return qr_basis(columns).rightCols(slopes.cols() - columns.cols());
}

/// The next stage: the rows of a level stay there, and the others may still move.
RowStage stage_after(const RowStage& stage, const PolishedLevel& level, const RowErrors& at) {
  const Matrix slopes = at.slopes * row_directions(at.slopes, level.level) / level.level;
  std::vector<LevelRow> rows = level.rows;
  RowStage next{stage.ceilings, {}};
  for (LevelRow& row : rows) {
    if (row.held) continue;
    row.held = level.level;
    next.ceilings[row.row] = level.level;
  }
  next.held = independent(rows, slopes);
  const Matrix moved = slopes * steps_beside(next.held, slopes);
  constexpr double unmoved = 1e-9;
  for (std::size_t i = 0; i < next.ceilings.size(); ++i) {
    const bool is_moved = moved.cols() > 0 && moved.row(static_cast<Eigen::Index>(i)).norm() > unmoved;
    if (next.counts(i) && !is_moved) next.ceilings[i] = level.level;
  }
  return next;
}

/// A fit and its levels.
struct LeveledFit {
  StudyFit fit;
  std::vector<double> levels;
};

/// The rows that determine a level, in the order of their places.
void append_contacts(const ReadStudy& study, const PolishedLevel& level,
                     std::vector<StudyContact>& contacts) {
  const auto first = static_cast<std::ptrdiff_t>(contacts.size());
  for (const LevelRow& row : level.rows) {
    if (row.held) continue;
    contacts.push_back({{}, row.sign * level.level});
    for (const auto& column : study.rows->places) contacts.back().at.push_back(column[row.row]);
  }
  std::ranges::sort(contacts.begin() + first, contacts.end(), {}, &StudyContact::at);
}

/// The fit from one start: one level after the other.
LeveledFit descend(const RowDescent& descent, const ReadStudy& study, const std::vector<double>& start,
                   bool is_linear, const Checkpoint& checkpoint) {
  RowStage stage{std::vector<double>(study.rows->value.size(), HUGE_VAL), {}};
  LeveledFit result;
  StudyFit& fit = result.fit;
  fit.parameters = start;
  const auto ended = [&](Status status, const std::string& why) {
    fail(fit, status, why);
    return result;
  };
  for (;;) {
    const DescentEnd end = descent(fit.parameters, stage, checkpoint);
    fit.parameters = end.at.parameters;
    result.levels.push_back(end.answer ? end.answer->level : end.at.largest);
    fit.level = result.levels.front();
    if (std::isinf(end.at.largest)) return ended(Status::not_converged, "the form has a pole at its start");
    if (row_directions(end.at.slopes, 1).cols() < end.at.slopes.cols())
      return ended(Status::degenerate, "the parameters do not move the error independently");
    if (!end.answer) return ended(Status::not_converged, end.why);
    if (!is_linear && end.answer->bend < -no_bend)
      return ended(Status::not_converged,
                   "a step along a curve lowers the level, " + decimal(end.answer->level, 10));
    fit.digits = end.answer->digits;
    append_contacts(study, *end.answer, fit.touching);
    if (end.answer->bend > no_bend) break;
    stage = stage_after(stage, *end.answer, end.at);
    if (std::find(stage.ceilings.begin(), stage.ceilings.end(), HUGE_VAL) == stage.ceilings.end())
      return ended(Status::degenerate, "the level, " + decimal(*fit.level, 10) +
                                           ", is the least, but other parameters have it too");
  }
  if (fit.digits < least_study_digits)
    return ended(Status::not_converged, "Newton's method does not settle in long double");
  return ended(Status::converged, "");
}

/// Whether a fit is lower than another at the first level where they differ by more than rounding. A fit that
/// did not converge is never lower: its level may fall towards a pole.
bool is_lower(const LeveledFit& a, const LeveledFit& b) {
  constexpr double same = 1e-9;
  const bool is_answer = a.fit.status == Status::converged;
  if (is_answer != (b.fit.status == Status::converged)) return is_answer;
  for (std::size_t i = 0; i < std::min(a.levels.size(), b.levels.size()); ++i) {
    if (std::abs(a.levels[i] - b.levels[i]) > same * b.levels[i]) return a.levels[i] < b.levels[i];
  }
  return false;
}

/// The lowest of the fits from all basins of the search.
LeveledFit lowest_fit(const ReadStudy& study, const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, {}, starts, checkpoint);
  const StudyNodes nodes = nodes_of(study, {}, 1);
  std::vector<std::vector<double>> from;
  for (const StudyCandidate& candidate : lowest_basins(searched)) from.push_back(candidate.parameters);
  if (!starts.empty() && !searched.is_linear) from.push_back(start_of(study, starts));

  const RowDescent descent(error, nodes, searched.sampled);
  std::optional<LeveledFit> lowest;
  for (const auto& start : from) {
    LeveledFit found = descend(descent, study, start, searched.is_linear, checkpoint);
    const bool is_better =
        !lowest || is_lower(found, *lowest) ||
        (!is_lower(*lowest, found) && is_slower_wave(found.fit.parameters, lowest->fit.parameters));
    if (is_better) lowest = std::move(found);
  }
  lowest->fit.names = study.parameters;
  lowest->fit.starts = searched.starts;
  lowest->fit.is_global = searched.is_linear;
  return *std::move(lowest);
}

/// Appends of each stretch of rows the one with the largest error, if that is above a level.
void append_above(double level, const SampledStudy<double>& sampled, const std::vector<double>& parameters,
                  std::vector<std::size_t>& rows) {
  constexpr Eigen::Index stretch = 4096;
  VectorOf<double> errors;
  sampled.errors(parameters, errors, nullptr);
  for (Eigen::Index first = 0, row = 0; first < errors.size(); first += stretch) {
    const auto own = errors.segment(first, std::min(stretch, errors.size() - first)).array();
    if (own.isNaN().select(HUGE_VAL, own.abs()).maxCoeff(&row) > level)
      rows.push_back(static_cast<std::size_t>(first + row));
  }
}

/// The fit of some rows, to which the rows above its level come until there are none. The level of some rows
/// is never above that of all.
LeveledFit exchanged_fit(const ReadStudy& study, const std::vector<Held>& starts,
                         const Checkpoint& checkpoint) {
  constexpr std::size_t first = 2000;
  constexpr int most_rounds = 50;
  constexpr double rounding = 2e-15;
  const StudyError error(study);
  const StudyNodes nodes = nodes_of(study, {}, 1);
  require_values(study, nodes);
  const SampledStudy<double> sampled(error, nodes);
  std::vector<std::size_t> rows = drawn_from(sampled.size(), first);
  ReadStudy some = study;
  for (int round = 0;; ++round) {
    some.rows = std::make_shared<const MeasuredRows>(some_of(*study.rows, rows));
    LeveledFit found = lowest_fit(some, starts, checkpoint);
    if (found.fit.status != Status::converged) return found;
    const double unit = std::max(found.levels.front(), sampled.target_norm());
    const std::size_t before = rows.size();
    append_above(found.levels.back() + rounding * unit, sampled, found.fit.parameters, rows);
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (rows.size() == before) return found;
    if (round < most_rounds) continue;
    fail(found.fit, Status::not_converged, "more rows than can be exchanged are above its level");
    return found;
  }
}

}  // namespace

StudyFit solve_minimax_rows(const ReadStudy& study, const std::vector<Held>& starts,
                            const Checkpoint& checkpoint) {
  const bool has_many = study.rows->value.size() > most_copied_rows;
  LeveledFit lowest = (has_many ? exchanged_fit : lowest_fit)(study, starts, checkpoint);
  StudyFit best = std::move(lowest.fit);
  if (best.status != Status::converged) return best;
  // A later level keeps the rows of an earlier one at its minimum. There a rounding of the level moves the
  // parameters by its square root, and Newton's last step does not see that.
  if (lowest.levels.size() > 1) best.digits = std::min(best.digits, most_digits / 2);
  const StudyError error(study);
  best.rms_error = rms_error(study, error, best.parameters);
  best.max_abs_error = largest_residual(study, best.parameters);
  confirm_integrals(study, best);
  return best;
}

}  // namespace shadefit
