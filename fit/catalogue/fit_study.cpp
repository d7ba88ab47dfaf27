#include "fit/catalogue/fit_study.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "fit/catalogue/bounded_study.hpp"
#include "fit/catalogue/near_peak.hpp"
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
StudyFit seen_fit(ReadStudy& study, const std::optional<std::vector<double>>& target_cuts,
                  const Solve& solve) {
  constexpr int most_rounds = 3;
  std::optional<double> unresolved;
  if (target_cuts) {
    study.axes.front().cuts = *target_cuts;
  } else {
    unresolved = cut_at_features(study);
  }
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

/// The known starts of a study without its held parameters.
std::vector<std::vector<Held>> free_starts(const Study& study) {
  std::vector<std::vector<Held>> starts = study.known_starts;
  for (std::vector<Held>& start : starts) {
    std::erase_if(start, [&](const Held& value) {
      return std::ranges::find(study.held, value.parameter, &Held::parameter) != study.held.end();
    });
  }
  return starts;
}

/// The minimax fit from the least squares of the first known start.
StudyFit minimax_from_start(const StudyObjective& objective) {
  ReadStudy study = read_study(objective.study);
  study.has_only_starts = true;
  if (!objective.study.cuts) take_limits(study);
  return solve_minimax_study(study, objective.constraints, free_starts(objective.study).front());
}

/// The least-squares fit from all known starts.
StudyFit squares_from_starts(const Study& study) {
  PreparedStudy prepared(study);
  std::vector<std::vector<double>> starts;
  for (const std::vector<Held>& known : free_starts(study)) {
    std::vector<double>& start = starts.emplace_back();
    for (const Held& value : known) start.push_back(value.value);
  }
  StudyFit fit = prepared.fit_from(starts);
  fit.starts = static_cast<int>(starts.size());
  return fit;
}

/// Fits a study from its known starts. Returns nothing where the study has no starts, and where they do not
/// agree on an answer. Bounds, and constraints of least squares, have a search of their own.
std::optional<StudyFit> fit_from_known_starts(const StudyObjective& objective, const ReadStudy& read) {
  const Study& study = objective.study;
  const bool is_minimax = objective.norm == Norm::minimax;
  if (study.known_starts.empty() || !study.bounds.empty() || study.rows) return std::nullopt;
  if (!is_minimax && has_constraints(objective.constraints)) return std::nullopt;
  try {
    StudyFit fit = is_minimax ? minimax_from_start(objective) : squares_from_starts(study);
    if (fit.status == Status::converged && !pole_of(read, fit.parameters)) return fit;
  } catch (const Infeasible&) {
    throw;
  } catch (const UserError&) {
    // A search finds more, or says why there is nothing.
  }
  return std::nullopt;
}

/// The errors of a form without a free parameter: nothing is fitted. Throws UserError where the target has no
/// value.
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

/// The fit of a study whose variable is its own, and whose formulas are read.
StudyFit fit_in_its_variable(const StudyObjective& objective, ReadStudy read, const Checkpoint& checkpoint) {
  if (read.parameters.empty()) return errors_of_given(std::move(read));
  if (auto known = fit_from_known_starts(objective, read)) return *std::move(known);
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
  StudyFit fit = objective.study.cuts ? solve_read() : seen_fit(read, objective.target_cuts, solve_read);
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

/// The places of a fit, as cosines.
void take_cosines(StudyFit& fit, const PeakVariable& variable) {
  fit.why = in_cosines(variable, std::move(fit.why));
  for (double& place : fit.max_abs_error.at) place = variable.cosine_at(place).cos_theta;
  for (AlternationPoint& point : fit.alternation) point.at = variable.cosine_at(point.at.cos_theta);
}

/// What is read of a study before its fit: all of its parameters may be held.
ReadStudy read_to_fit(const Study& study) {
  return study.held.empty() ? read_study(study) : read_formulas(study);
}

/// The largest errors that a fit from known starts lacks.
void add_errors(StudyFit& fit, const Study& study) {
  if (fit.status != Status::converged || study.rows) return;
  if (!fit.max_abs_error.at.empty() && study.weight == "1") return;
  const ReadStudy read = read_formulas(study);
  if (fit.max_abs_error.at.empty()) fit.max_abs_error = largest_error(read, fit.parameters);
  if (study.weight != "1") fit.max_weighted_error = largest_weighted_error(read, fit.parameters).magnitude;
}

/// Fits a study near its peak. Without `has_errors` the largest errors of a fit from known starts are left
/// out.
StudyFit fit_near_peak(const StudyObjective& objective, bool has_errors, const Checkpoint& checkpoint) {
  const PeakVariable variable = peak_variable(objective.study);
  StudyObjective near = objective;
  near.study = near_peak(objective.study);
  for (double& place : near.constraints.exact_at) place = variable.value_at({place, 1 - place});
  try {
    StudyFit fit = fit_in_its_variable(near, read_to_fit(near.study), checkpoint);
    if (has_errors) add_errors(fit, near.study);
    if (has_peak(objective.study)) take_cosines(fit, variable);
    return fit;
  } catch (const Infeasible& error) {
    throw Infeasible(in_cosines(variable, error.why));
  }
}

}  // namespace

std::optional<std::vector<double>> cuts_of_target(const Study& study) {
  if (study.cuts || has_peak(study)) return std::nullopt;
  ReadStudy read = read_formulas(study);
  take_limits(read);
  if (cut_at_features(read)) return std::nullopt;
  return read.axes.front().cuts;
}

Study with_cuts(Study study) {
  ReadStudy read = read_study(study);
  take_limits(read);
  cut_at_features(read);
  study.cuts = read.axes.front().cuts;
  return study;
}

StudyFit fit_study(const StudyObjective& objective, const Checkpoint& checkpoint) {
  return fit_near_peak(objective, true, checkpoint);
}

StudyFit fit_study(const StudyObjective& objective, ReadStudy read, const Checkpoint& checkpoint) {
  if (has_peak(objective.study)) return fit_study(objective, checkpoint);
  StudyFit fit = fit_in_its_variable(objective, std::move(read), checkpoint);
  add_errors(fit, objective.study);
  return fit;
}

StudyFit fit_constants(const StudyObjective& objective, const Checkpoint& checkpoint) {
  return fit_near_peak(objective, false, checkpoint);
}

}  // namespace shadefit
