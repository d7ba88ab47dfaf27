#include "fit/better/better_study.hpp"

#include <algorithm>
#include <string_view>

#include "approx/scalar.hpp"
#include "fit/study/largest_error.hpp"

namespace shadefit {
namespace {

Study with_form(const Study& study, const StudyForm& form) {
  Study result = study;
  result.form = form.formula;
  return result;
}

Symbolic form_with(const ReadStudy& study, const std::vector<double>& values) {
  return evaluate<Symbolic>(study.form, [&](const std::string& name) {
    const auto& all = study.parameters;
    const auto found = std::find(all.begin(), all.end(), name);
    return found == all.end()
               ? Symbolic::variable(name)
               : Symbolic::number(to_text(values[static_cast<std::size_t>(found - all.begin())]));
  });
}

/// The name of the error by which contenders are compared.
std::string_view error_of(const Study& study) {
  if (study.rows) return "max_abs_error";
  if (study.weight != "1") return "max_weighted_error";
  return study.error == Error::relative ? "max_rel_error" : "max_abs_error";
}

StudyContender contender_of(const StudyForm& form, const Study& study, std::string origin,
                            std::vector<double> values) {
  const ReadStudy read = read_study(study);
  const bool is_plain = error_of(study) == "max_abs_error";
  const StudyExtremum largest = is_plain ? largest_error(read, values) : largest_weighted_error(read, values);
  const Symbolic code = form_with(read, values);
  return {.form = form.id,
          .formula = form.formula,
          .origin = std::move(origin),
          .names = read.parameters,
          .values = std::move(values),
          .code = code,
          .operations = count_operations(code),
          .max_error = largest};
}

void append_published(StudyComparison& comparison, const StudyFile& file, const StudyForm& form,
                      const Checkpoint& checkpoint) {
  const Study study = with_form(comparison.study, form);
  const ReadStudy read = read_study(study);
  for (const PublishedSet& set : file.published) {
    if (set.form != form.id || !is_for(set, study)) continue;
    const std::vector<std::string> printed = values_of(set, read.parameters);
    std::vector<double> values;
    for (const std::string& text : printed) values.push_back(constant<double>(text));
    StudyContender contender = contender_of(form, study, set.source, values);
    contender.published = &set;
    contender.printed = printed;
    contender.judgement = judge_set(objective_of(study, file.norm, file.constraints), set, checkpoint);
    for (const ErrorClaim& claim : set.claims) contender.claims.push_back(judge_error(claim, study, values));
    comparison.contenders.push_back(contender);
  }
}

/// What the file asks for, least squares, and minimax if the target is a formula.
std::vector<StudyObjective> objectives_of(const StudyFile& file, const Study& study, const ReadStudy& read) {
  std::vector<StudyObjective> objectives{objective_of(study, file.norm, file.constraints)};
  for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
    const StudyObjective other = objective_of(study, norm, {});
    const bool is_possible = norm == Norm::least_squares || can_be_minimax(read);
    if (is_possible && other.words != objectives.front().words) objectives.push_back(other);
  }
  return objectives;
}

void append_fits(StudyComparison& comparison, const StudyFile& file, const StudyForm& form,
                 const Checkpoint& checkpoint) {
  const Study study = with_form(comparison.study, form);
  const ReadStudy read = read_study(study);
  for (StudyObjective& objective : objectives_of(file, study, read)) {
    checkpoint();
    if (study.starts.empty()) objective.study.starts = published_starts(file, form.id, study);
    const StudyFit fit = fit_study(objective, checkpoint);
    if (fit.status == Status::converged) {
      comparison.contenders.push_back(contender_of(form, study, objective.words, fit.parameters));
    } else {
      comparison.left_out.push_back(form.id + ", " + objective.words + ": " + std::string(name(fit.status)) +
                                    ", " + fit.why);
    }
  }
}

bool is_better(const StudyContender& contender, const StudyContender& published) {
  return contender.max_error.magnitude < published.max_error.magnitude &&
         contender.operations.total() <= published.operations.total();
}

}  // namespace

ReadStudy formulas_of(const StudyComparison& comparison, const StudyContender& contender) {
  Study study = comparison.study;
  study.form = contender.formula;
  return read_formulas(study);
}

StudyComparison compare_study(const StudyFile& file, const Study& study, const Checkpoint& checkpoint) {
  StudyComparison comparison{.study = study, .error = error_of(study), .variables = {}};
  for (const StudyRange& range : study.over) comparison.variables.push_back(range.variable);
  for (const StudyForm& form : file.forms) {
    append_published(comparison, file, form, checkpoint);
    append_fits(comparison, file, form, checkpoint);
  }
  auto& contenders = comparison.contenders;
  std::stable_sort(
      contenders.begin(), contenders.end(), [](const StudyContender& a, const StudyContender& b) {
        const bool is_first = a.published != nullptr, is_other_first = b.published != nullptr;
        return is_first != is_other_first ? is_first : a.max_error.magnitude < b.max_error.magnitude;
      });
  for (StudyContender& contender : contenders) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      if (contenders[i].published != nullptr && is_better(contender, contenders[i]))
        contender.beats.push_back(i);
    }
  }
  return comparison;
}

}  // namespace shadefit
