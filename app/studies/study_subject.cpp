#include "app/studies/chosen_study.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "app/options/fit_arguments.hpp"
#include "fit/rounding/round_study.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_verdict.hpp"

namespace shadefit {
namespace {

/// The first option on the command line that counts for a fit alone, or an empty text.
std::string option_of_study_fit(const FitOptions& options) {
  if (const std::string found = option_of_fits(options.present); !found.empty()) return found;
  for (const StudyRange& range : options.study.over) {
    if (range.density != "1") return fmt::format("--over '{}' with a density", range.variable);
  }
  return "";
}

Constants fitted_constants(const StudyObjective& objective, const std::optional<NumberFormat>& round,
                           const Checkpoint& checkpoint) {
  const StudyFit fit = fit_study(objective, checkpoint);
  if (fit.status == Status::converged) {
    Constants constants = constants_of(objective.study, fit);
    if (!round) return constants;
    const std::vector<std::string> texts = round_study(objective, fit, *round, {}, checkpoint).best.texts;
    for (std::size_t i = 0; i < texts.size(); ++i) constants[i].second = texts[i];
    return constants;
  }
  const std::string given = given_text(objective.study);
  throw UserError(fmt::format("the fit{}{} is {}: {}; give --parameters", given.empty() ? "" : " of ", given,
                              name(fit.status), fit.why));
}

}  // namespace

ChosenStudySubject chosen_study_subject(const StudyFile& file, const Study& study,
                                        const std::optional<Constants>& parameters, const FitOptions& options,
                                        const Checkpoint& checkpoint) {
  const StudyForm& form = file.forms.front();
  Study whole = study;
  take_form(whole, form);
  const Study bare = subject_of(whole, {}).study;
  const std::vector<std::string> names = read_formulas(bare).parameters;
  const auto chosen = [&](const Constants& constants, std::string_view from, const OthersText& origin) {
    ChosenStudySubject result{subject_of(whole, constants), from, origin};
    const std::string fault = fault_of_constants(result.subject.parameters, names, "the form");
    if (!fault.empty()) throw UserError(fault);
    return result;
  };
  const std::string asks_for_fit = option_of_study_fit(options);
  if (parameters && !asks_for_fit.empty())
    throw UserError(fmt::format("{} does not go with --parameters: nothing is fitted", asks_for_fit));
  if (parameters) return chosen(*parameters, "given", std::string("given"));
  if (names.empty()) return chosen({}, "given", std::string("no constant"));
  for (const PublishedSet& set : file.published) {
    if (asks_for_fit.empty() && set.form == form.id && is_for(set, study))
      return chosen(set.values, "published", "published: " + set.source);
  }
  const StudyObjective objective = objective_of(whole, file.norm, file.constraints);
  const OthersText words = options.round
                               ? "the smallest largest error of constants in " + to_text(*options.round)
                               : objective.words;
  return chosen(fitted_constants(objective, options.round, checkpoint), "fitted", "fitted: " + words);
}

}  // namespace shadefit
