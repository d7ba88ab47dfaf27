#include "fit/verdicts/study_verdict.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "approx/scalar.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The fit under an objective; empty if there is none, as for a relative error where the target is 0.
std::optional<StudyFit> fit_if_any(const StudyObjective& objective, const Checkpoint& checkpoint) {
  try {
    StudyFit fit = fit_study(objective, checkpoint);
    return fit.status == Status::converged ? std::optional(std::move(fit)) : std::nullopt;
  } catch (const UserError&) {
    return std::nullopt;
  }
}

/// How far the worst constant is off, in units of its last printed digit.
long worst_units_off(const std::vector<std::string>& printed, const std::vector<double>& computed) {
  long worst = 0;
  for (std::size_t i = 0; i < printed.size(); ++i)
    worst = std::max(worst, units_off(printed[i], computed[i]));
  return worst;
}

/// Each parameter in turn held at its printed value, under each of the objectives. One that is exact at a
/// place is left out: it would only say again what is held.
std::vector<StudyObjective> with_one_held(const std::vector<StudyObjective>& all, const PublishedSet& set) {
  std::vector<StudyObjective> objectives;
  if (set.values.size() < 2) return objectives;
  for (const StudyObjective& objective : all) {
    if (!objective.constraints.exact_at.empty()) continue;
    for (const auto& [parameter, printed] : set.values) {
      StudyObjective held = objective;
      held.study.held.push_back({parameter, constant<double>(printed)});
      held.words += " with " + parameter + " = " + printed;
      objectives.push_back(held);
    }
  }
  return objectives;
}

/// The fitted values in the order of all parameters, the held ones at their printed values.
std::vector<double> all_values(const StudyFit& fit, const StudyObjective& objective,
                               const std::vector<std::string>& parameters) {
  std::vector<double> values;
  for (const std::string& name : parameters) {
    const auto found = std::find(fit.names.begin(), fit.names.end(), name);
    if (found != fit.names.end()) {
      values.push_back(fit.parameters[static_cast<std::size_t>(found - fit.names.begin())]);
      continue;
    }
    for (const Held& held : objective.study.held) {
      if (held.parameter == name) values.push_back(held.value);
    }
  }
  return values;
}

}  // namespace

StudyFit fit_study(const StudyObjective& objective, const Checkpoint& checkpoint) {
  const ReadStudy read = read_study(objective.study);
  return objective.norm == Norm::minimax
             ? solve_minimax_study(read, objective.constraints, objective.study.starts, checkpoint)
             : solve_constrained_study(read, objective.constraints, objective.study.starts, checkpoint);
}

StudyObjective objective_of(const Study& study, Norm norm, const Constraints& constraints) {
  StudyObjective objective{norm == Norm::minimax ? "minimax" : "least squares", study, norm, constraints};
  if (study.error == Error::relative) objective.words += ", relative error";
  const std::string& variable = study.over.front().variable;
  for (const double x : constraints.exact_at)
    objective.words += ", exact at " + variable + " = " + to_text(x);
  if (constraints.one_sided)
    objective.words += *constraints.one_sided == Side::above ? ", form >= target" : ", form <= target";
  if (constraints.at_most) objective.words += ", form <= " + to_text(*constraints.at_most);
  if (constraints.at_least) objective.words += ", form >= " + to_text(*constraints.at_least);
  if (constraints.monotone) objective.words += ", form " + std::string(name(*constraints.monotone));
  return objective;
}

std::vector<StudyObjective> other_objectives(const StudyObjective& asked) {
  std::vector<StudyObjective> objectives;
  const auto add = [&](const StudyObjective& objective) {
    if (objective.words != asked.words) objectives.push_back(objective);
  };
  const bool has_rows = asked.study.rows != nullptr;
  for (const Error error : {Error::absolute, Error::relative}) {
    Study study = asked.study;
    study.error = error;
    add(objective_of(study, Norm::least_squares, {}));
    if (!has_rows) add(objective_of(study, Norm::minimax, {}));
  }
  if (has_rows || asked.study.over.size() > 1) return objectives;
  const StudyAxis axis = read_study(asked.study).axes.front();
  if (0 <= axis.lower && axis.upper <= 1) {
    for (const char* word : {"angle", "cosine-weighted"}) {
      StudyObjective objective = objective_of(asked.study, Norm::least_squares, {});
      objective.study.over.front().density = density_of(word, axis.variable);
      objective.words += std::string(", measure ") + word;
      objectives.push_back(objective);
    }
  }
  for (const auto& ends :
       {std::vector{axis.lower}, std::vector{axis.upper}, std::vector{axis.lower, axis.upper}})
    add(objective_of(asked.study, Norm::minimax, {.exact_at = ends}));
  return objectives;
}

std::vector<std::string> values_of(const PublishedSet& set, const std::vector<std::string>& parameters) {
  std::vector<std::string> values;
  for (const std::string& name : parameters) {
    const auto found = std::find_if(set.values.begin(), set.values.end(),
                                    [&](const auto& value) { return value.first == name; });
    if (found == set.values.end())
      throw UserError("published values of '" + set.form + "' lack the parameter '" + name + "'");
    if (!parse_number(found->second))
      throw UserError("published value '" + found->second + "' of '" + name + "' is not a number");
    values.push_back(found->second);
  }
  for (const auto& [name, value] : set.values) {
    if (std::find(parameters.begin(), parameters.end(), name) == parameters.end())
      throw UserError("published value '" + name + "' is not a parameter of the form '" + set.form + "'");
  }
  return values;
}

StudyJudgement judge_set(const StudyObjective& asked, const PublishedSet& set, const Checkpoint& checkpoint) {
  const std::vector<std::string> parameters = read_study(asked.study).parameters;
  const std::vector<std::string> printed = values_of(set, parameters);
  StudyJudgement judgement{Verdict::refuted, "", {}};
  if (const auto fit = fit_if_any(asked, checkpoint)) {
    judgement.computed = fit->parameters;
    const long off = worst_units_off(printed, fit->parameters);
    if (off == 0) return {Verdict::confirmed, asked.words, fit->parameters};
    if (off == 1) return {Verdict::rounding, asked.words, fit->parameters};
  }
  std::vector<StudyObjective> others = other_objectives(asked);
  std::vector<StudyObjective> all{asked};
  all.insert(all.end(), others.begin(), others.end());
  for (StudyObjective& objective : with_one_held(all, set)) others.push_back(std::move(objective));
  for (const StudyObjective& other : others) {
    const auto fit = fit_if_any(other, checkpoint);
    if (!fit) continue;
    const std::vector<double> values = all_values(*fit, other, parameters);
    if (worst_units_off(printed, values) == 0) return {Verdict::other_objective, other.words, values};
  }
  return judgement;
}

Verdict judge_claim(const ErrorClaim& claim, double max_abs_error) {
  const long off = units_off(claim.max_abs_error, max_abs_error);
  if (off == 0 || max_abs_error <= constant<double>(claim.max_abs_error)) return Verdict::confirmed;
  return off == 1 ? Verdict::rounding : Verdict::refuted;
}

}  // namespace shadefit
