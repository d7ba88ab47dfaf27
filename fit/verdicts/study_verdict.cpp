#include "fit/verdicts/study_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "approx/scalar.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The fit under an objective. Empty if there is none, such as for a relative error if the target is 0
/// somewhere.
std::optional<StudyFit> fit_if_any(const StudyObjective& objective, const Checkpoint& checkpoint) {
  try {
    StudyFit fit = fit_study(objective, checkpoint);
    return fit.status == Status::converged ? std::optional(std::move(fit)) : std::nullopt;
  } catch (const UserError&) {
    return std::nullopt;
  }
}

bool is_decimal_digit(char c) {
  return '0' <= c && c <= '9';
}

/// A fit has so many digits, and this is the unit of the last of them, relative to a constant.
constexpr int digits_of_a_fit = 14;
constexpr double unit_of_a_fit = 1e-14;

/// The significant digits of a printed number.
int significant_digits(std::string_view printed) {
  const std::string_view mantissa = printed.substr(0, printed.find_first_of("eE"));
  const std::size_t first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  return static_cast<int>(std::ranges::count_if(mantissa.substr(first), is_decimal_digit));
}

/// How far the worst constant is off, in units of its last printed digit. Digits beyond those of a fit are
/// ignored.
long worst_units_off(const std::vector<std::string>& printed, const std::vector<double>& computed) {
  long worst = 0;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const double difference = std::abs(constant<double>(printed[i]) - computed[i]);
    if (difference > unit_of_a_fit * std::abs(computed[i]))
      worst = std::max(worst, units_off(printed[i], computed[i]));
  }
  return worst;
}

/// The share of the tried values of a parameter that some units of its last printed digit cover. Half of the
/// values lie between their quartiles; if there are only a few, all lie in their range; a single one might as
/// well be 0 or twice as large.
double share_in(std::vector<double> values, double units) {
  std::ranges::sort(values);
  constexpr std::size_t few = 4;
  const double width = values.size() == 1 ? 2 * std::abs(values.front())
                       : values.size() < few
                           ? values.back() - values.front()
                           : 2 * (values[values.size() * 3 / 4] - values[values.size() / 4]);
  return width > units ? units / width : 1;
}

/// The chance that one trial has all printed digits, off by `most_off` at most, if the digits were drawn from
/// where the trials lie that hold the same constant, or none.
double chance_of_one(const std::vector<TriedFit>& trials, const std::vector<std::string>& printed,
                     std::optional<std::size_t> held, long most_off) {
  double chance = 1;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    std::vector<double> values;
    for (const TriedFit& trial : trials)
      if (trial.held == held) values.push_back(trial.values[i]);
    // Digits that no fit has are no evidence.
    const double unit =
        std::max(last_unit(printed[i]), unit_of_a_fit * std::abs(constant<double>(printed[i])));
    const double units = static_cast<double>(1 + 2 * most_off) * unit;
    if (held != i) chance *= share_in(std::move(values), units);
  }
  return chance;
}

/// The expected number of trials that hold the same constant, or none, and have all printed digits by chance.
double expected_chance_hits(const std::vector<TriedFit>& trials, const std::vector<std::string>& printed,
                            std::optional<std::size_t> held) {
  const auto count = std::ranges::count(trials, held, &TriedFit::held);
  return static_cast<double>(count) * chance_of_one(trials, printed, held, 0);
}

/// Whether a part of the ranges of two studies differs: their densities, or an end.
bool have_other(std::string StudyRange::*part, const Study& study, const Study& asked) {
  return !std::ranges::equal(study.over, asked.over, {}, part, part);
}

bool has_other_ranges(const Study& study, const Study& asked) {
  return have_other(&StudyRange::lower, study, asked) || have_other(&StudyRange::upper, study, asked);
}

/// Each objective with each parameter in turn held at its printed value. Objectives that are exact at a place
/// are left out, because they hold a constant already; those on samples are left out, because they are close
/// to the integral; those on parts of the range, and with other densities of two variables, because there are
/// many and they take long.
std::vector<StudyObjective> with_one_held(const std::vector<StudyObjective>& all, const PublishedSet& set) {
  std::vector<StudyObjective> objectives;
  if (set.values.size() < 2) return objectives;
  for (const StudyObjective& objective : all) {
    const bool is_sampled = objective.study.rows != all.front().study.rows;
    const bool is_of_two = objective.study.over.size() == 2 &&
                           have_other(&StudyRange::density, objective.study, all.front().study);
    const bool is_on_part = !is_sampled && has_other_ranges(objective.study, all.front().study);
    if (!objective.constraints.exact_at.empty() || is_sampled || is_of_two || is_on_part) continue;
    for (const auto& [parameter, printed] : set.values) {
      StudyObjective held = holding(objective, parameter, constant<double>(printed));
      held.words += " with " + parameter + " = " + printed;
      objectives.push_back(held);
    }
  }
  return objectives;
}

/// Whether a fit is its target but for rounding.
bool has_no_error(const StudyFit& fit) {
  constexpr double rounding = 1e-12;
  return fit.rms_error < rounding;
}

/// Whether a fit has no error although it sees only a part of the target: samples, or a part of the range.
/// Then it cannot tell objectives apart: the target is the form except where the fit does not see it.
bool meets_a_part(const StudyObjective& objective, const StudyObjective& asked, const StudyFit& fit) {
  return (objective.study.rows != asked.study.rows || has_other_ranges(objective.study, asked.study)) &&
         has_no_error(fit);
}

/// Whether the constant that an objective holds is near the best one when it is free. That is so for a
/// constant that was rounded and then held. Others prove nothing: the best constants for one density, with
/// one of them held, may be the best for another density too.
bool is_held_nearby(const StudyObjective& held, const std::vector<TriedFit>& trials,
                    const std::vector<std::string>& parameters) {
  constexpr double near = 0.1;  // relative
  const Held& added = held.study.held.back();
  const auto i = std::ranges::find(parameters, added.parameter) - parameters.begin();
  return std::ranges::any_of(trials, [&](const TriedFit& trial) {
    const double best = trial.values[static_cast<std::size_t>(i)];
    return !trial.held && held.words.starts_with(trial.words + " with ") &&
           std::abs(best - added.value) <= near * std::abs(best);
  });
}

/// The parameter that an objective holds and the asked one does not.
std::optional<std::size_t> held_of(const StudyObjective& objective, const StudyObjective& asked,
                                   const std::vector<std::string>& parameters) {
  if (objective.study.held.size() == asked.study.held.size()) return std::nullopt;
  const auto found = std::ranges::find(parameters, objective.study.held.back().parameter);
  return static_cast<std::size_t>(found - parameters.begin());
}

/// The values of all parameters in their order: fitted, or printed if held.
std::vector<double> all_values(const StudyFit& fit, const StudyObjective& objective,
                               const std::vector<std::string>& parameters) {
  std::vector<double> values;
  for (const std::string& name : parameters) {
    const auto found = std::ranges::find(fit.names, name);
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

std::vector<Held> starts_at(const PublishedSet& set, const std::vector<Held>& held) {
  std::vector<Held> starts;
  for (const auto& value : set.values) {
    if (std::ranges::find(held, value.first, &Held::parameter) == held.end())
      starts.push_back({value.first, constant<double>(value.second)});
  }
  return starts;
}

std::vector<Held> published_starts(const StudyFile& file, const std::string& form, const Study& study) {
  for (const PublishedSet& set : file.published) {
    if (set.form == form && is_for(set, study)) return starts_at(set, study.held);
  }
  return {};
}

std::vector<std::string> values_of(const PublishedSet& set, const std::vector<std::string>& parameters) {
  std::vector<std::string> values;
  for (const std::string& name : parameters) {
    const auto found = std::ranges::find(set.values, name, [](const auto& value) { return value.first; });
    if (found == set.values.end())
      throw UserError("published values of '" + set.form + "' lack the parameter '" + name + "'");
    if (!parse_number(found->second))
      throw UserError("published value '" + found->second + "' of '" + name + "' is not a number");
    values.push_back(found->second);
  }
  for (const auto& [name, value] : set.values) {
    if (std::ranges::find(parameters, name) == parameters.end())
      throw UserError("published value '" + name + "' is not a parameter of the form '" + set.form + "'");
  }
  return values;
}

TriedFits tried_fits(StudyObjective asked, const PublishedSet& set, const Checkpoint& checkpoint) {
  if (asked.target_cuts) {
    asked.study.cuts = asked.target_cuts;
  } else {
    asked.study = with_cuts(asked.study);
  }
  const std::vector<std::string> parameters = read_study(asked.study).parameters;
  const std::vector<std::string> printed = values_of(set, parameters);
  TriedFits tried{.is_stated = set.is_stated_fit};
  // Returns how far the worst constant is off; empty if there is no such fit.
  const auto attempt = [&](const StudyObjective& objective) -> std::optional<long> {
    checkpoint();
    ++tried.attempts;
    const auto fit = fit_if_any(objective, checkpoint);
    if (!fit || meets_a_part(objective, asked, *fit)) return std::nullopt;
    const std::vector<double> values = all_values(*fit, objective, parameters);
    tried.fits.push_back(
        {objective.words, values, held_of(objective, asked, parameters), has_no_error(*fit)});
    return worst_units_off(printed, values);
  };
  // Another objective counts if it has an optimum near the printed constants.
  const auto hits_nearby = [&](StudyObjective objective) {
    objective.study.has_only_starts = true;
    objective.study.starts = starts_at(set, objective.study.held);
    return attempt(objective) == 0;
  };
  StudyObjective usual = asked;
  usual.study.starts = starts_at(set, asked.study.held);
  const auto off = attempt(usual);
  tried.has_asked = off.has_value();
  if (off && *off <= 1) {
    for (const StudyObjective& other : plain_objectives(asked)) hits_nearby(other);
    return tried;
  }

  // All are tried, even after one has the right digits: chance is counted among all.
  const std::vector<StudyObjective> others = other_objectives(asked);
  bool is_hit = false;
  for (const StudyObjective& other : others) is_hit = hits_nearby(other) || is_hit;
  if (is_hit) return tried;
  std::vector<StudyObjective> all{asked};
  all.insert(all.end(), others.begin(), others.end());
  for (const StudyObjective& held : with_one_held(all, set)) {
    if (is_held_nearby(held, tried.fits, parameters)) is_hit = hits_nearby(held) || is_hit;
  }
  if (is_hit) return tried;
  for (const StudyObjective& exact : exact_least_squares(asked, printed)) hits_nearby(exact);
  return tried;
}

StudyJudgement judge_digits(const TriedFits& tried, const std::vector<std::string>& printed) {
  if (tried.fits.empty()) return {Verdict::refuted, "", {}, tried.attempts};
  std::vector<long> off;  // for each fit
  for (const TriedFit& fit : tried.fits) off.push_back(worst_units_off(printed, fit.values));
  const bool is_asked = tried.has_asked && off.front() <= 1;
  const auto chance_of = [&](std::size_t i) {
    const TriedFit& fit = tried.fits[i];
    if (is_asked && tried.is_stated) return 0.0;
    if (!is_asked) return expected_chance_hits(tried.fits, printed, fit.held);
    return fit.has_no_error ? 0.0 : chance_of_one(tried.fits, printed, fit.held, off[i]);
  };
  const auto judgement = [&](Verdict verdict, std::size_t i) {
    StudyJudgement found{verdict, tried.fits[i].words, tried.fits[i].values, tried.attempts, chance_of(i), {},
                         off[i]};
    if (verdict == Verdict::refuted) return found;
    if (std::ranges::any_of(printed,
                            [](const std::string& p) { return significant_digits(p) > digits_of_a_fit; }))
      found.compared_digits = digits_of_a_fit;
    for (std::size_t k = 0; k < off.size(); ++k)
      if (off[k] == 0 && k != i) found.also.push_back(tried.fits[k].words);
    if (found.chance >= most_chance_hits) found.verdict = Verdict::undecidable;
    return found;
  };
  if (is_asked) return judgement(off.front() == 0 ? Verdict::confirmed : Verdict::rounding, 0);
  const auto nearest = static_cast<std::size_t>(std::ranges::min_element(off) - off.begin());
  if (off[nearest] != 0) return judgement(Verdict::refuted, nearest);
  // Of the fits that have all digits, the first of those with the least chance.
  std::size_t best = nearest;
  for (std::size_t i = nearest + 1; i < off.size(); ++i)
    if (off[i] == 0 && chance_of(i) < chance_of(best)) best = i;
  return judgement(Verdict::other_objective, best);
}

StudyJudgement judge_set(const StudyObjective& asked, const PublishedSet& set, const Checkpoint& checkpoint) {
  return judge_digits(tried_fits(asked, set, checkpoint), values_of(set, read_study(asked.study).parameters));
}

}  // namespace shadefit
