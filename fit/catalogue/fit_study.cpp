#include "fit/catalogue/fit_study.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "fit/catalogue/bounded_study.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/exchange/minimax_study.hpp"
#include "fit/panels/features.hpp"
#include "fit/panels/limits.hpp"
#include "fit/squares/prepared_study.hpp"
#include "fit/squares/rules.hpp"
#include "fit/squares/solve_in_units.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A fit whose nodes see what its formulas and its error do: where they do not, the study is cut and solved
/// again.
template <class Solve>
StudyFit seen_fit(ReadStudy& study, const Solve& solve) {
  constexpr int most_rounds = 3;
  std::optional<double> unresolved = cut_at_features(study);
  StudyFit fit = solve();
  for (int round = 0; fit.status == Status::converged && !unresolved; ++round) {
    const Features missed = features_of_error(study, fit.parameters);
    unresolved = missed.unresolved;
    if (missed.cuts.empty()) return fit;
    if (round == most_rounds) unresolved = missed.cuts.front();
    if (unresolved) break;
    std::ranges::copy(missed.cuts, std::back_inserter(study.axes.front().cuts));
    fit = solve();
  }
  const bool is_open = fit.status == Status::converged || fit.status == Status::not_converged;
  if (!is_open || !unresolved) return fit;
  fit.status = Status::unresolved;
  fit.why = why_unresolved(study, *unresolved);
  return fit;
}

/// The minimax fit of a form that meets its target but for rounding: no place holds its level, which is 0.
std::optional<StudyFit> exact_fit(const ReadStudy& study, const std::vector<Held>& starts,
                                  const Checkpoint& checkpoint) {
  if (study.rows) return std::nullopt;
  StudyFit fit = solve_study(study, starts, checkpoint);
  if (fit.status != Status::converged || fit.max_abs_error.magnitude > 0) return std::nullopt;
  // Long double leaves 1e-19 of an exact form. What is below that and is not 0 was seen by 50 digits.
  constexpr double seen_by_50_digits = 1e-21, zero_of_50_digits = 1e-40;
  if (zero_of_50_digits < fit.rms_error && fit.rms_error < seen_by_50_digits) return std::nullopt;
  fit.level = 0;
  return fit;
}

/// The minimax fit from the least squares of the first start.
StudyFit minimax_from(const StudyObjective& objective, const std::vector<double>& start) {
  ReadStudy study = read_study(objective.study);
  study.has_only_starts = true;
  if (!objective.study.cuts) take_limits(study);
  std::vector<Held> starts;
  for (std::size_t i = 0; i < start.size(); ++i) starts.push_back({study.parameters[i], start[i]});
  return solve_minimax_study(study, objective.constraints, starts);
}

}  // namespace

Study with_cuts(Study study) {
  ReadStudy read = read_study(study);
  take_limits(read);
  cut_at_features(read);
  study.cuts = read.axes.front().cuts;
  return study;
}

StudyFit errors_of_given(ReadStudy study) {
  take_limits(study);
  cut_at_features(study);
  std::ranges::copy(features_of_error(study, {}).cuts, std::back_inserter(study.axes.front().cuts));
  require_values(study, nodes_of(study, edges_of(study), fit_rules.front()));
  StudyFit given;
  given.status = Status::converged;
  given.rms_error = rms_error(study, StudyError(study), {});
  given.max_abs_error = study.rows ? largest_residual(study, {}) : largest_error(study, {});
  return given;
}

StudyFit fit_study(const StudyObjective& objective, const Checkpoint& checkpoint) {
  const Study& study = objective.study;
  return fit_study(objective, study.held.empty() ? read_study(study) : read_formulas(study), checkpoint);
}

StudyFit fit_study(const StudyObjective& objective, ReadStudy read, const Checkpoint& checkpoint) {
  if (read.parameters.empty()) return errors_of_given(std::move(read));
  take_limits(read);
  const auto solve = [&](const ReadStudy& study, const std::vector<Held>& starts) {
    if (objective.norm == Norm::least_squares)
      return solve_constrained_study(study, objective.constraints, starts, checkpoint);
    StudyFit minimax = solve_minimax_study(study, objective.constraints, starts, checkpoint);
    if (minimax.status != Status::degenerate || has_constraints(objective.constraints)) return minimax;
    return exact_fit(study, starts, checkpoint).value_or(std::move(minimax));
  };
  const auto solve_any = [&](const ReadStudy& study, const std::vector<Held>& starts) {
    // Constraints are in the units of the study.
    return has_constraints(objective.constraints) ? solve(study, starts)
                                                  : solve_in_units(study, starts, solve);
  };
  const auto solve_read = [&] {
    const std::vector<Held>& starts = objective.study.starts;
    return read.bounds.empty()
               ? solve_any(read, starts)
               : solve_bounded_study(read, objective.norm, objective.constraints, starts, solve_any);
  };
  StudyFit fit = objective.study.cuts ? solve_read() : seen_fit(read, solve_read);
  fit.is_sampled = !read.rows && !is_enclosed(read);
  if (const auto pole = fit.parameters.empty() ? std::nullopt : pole_of(read, fit.parameters))
    fail(fit, Status::at_border,
         "the way down leads to a pole of the form, at " + read.axes.front().variable + " = " +
             decimal(*pole, 6));
  const auto is_finite = [](double parameter) { return std::isfinite(parameter); };
  if (fit.status == Status::converged && !std::ranges::all_of(fit.parameters, is_finite)) {
    fit.status = Status::not_finite;
    fit.why = "a parameter is beyond the range of a double";
  }
  return fit;
}

StudyFit fit_from_starts(const StudyObjective& objective, const std::vector<std::vector<double>>& starts) {
  try {
    StudyFit fit = objective.norm == Norm::minimax ? minimax_from(objective, starts.front())
                                                   : PreparedStudy(objective.study).fit_from(starts);
    if (fit.status == Status::converged && !pole_of(read_study(objective.study), fit.parameters)) return fit;
  } catch (const Infeasible&) {
    throw;
  } catch (const UserError&) {
    // A search finds more, or says why there is nothing.
  }
  return fit_study(objective);
}

}  // namespace shadefit
