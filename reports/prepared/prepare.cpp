#include "reports/prepared/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/study_file.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "fit/verdicts/study_verdict.hpp"
#include "reports/code/study_code.hpp"
#include "reports/studies/study_certificate_json.hpp"

namespace shadefit {
namespace {

/// The study of a file with one value of each given constant.
Study study_of(StudyFile& file, const std::map<std::string, std::string>& given) {
  for (const auto& [name, value] : given) {
    const auto found = std::ranges::find(file.given, name, [](const auto& of) { return of.first; });
    if (found == file.given.end()) throw UserError(fmt::format(": it has no given constant '{}'", name));
    found->second = {value};
  }
  std::vector<Study> studies = combinations(file.study, file.given);
  if (studies.size() > 1)
    throw UserError(fmt::format(": its given constants have {} values: name one of each", studies.size()));
  return std::move(studies.front());
}

/// The fit of the first form of a file.
StudyObjective first_objective(StudyFile file, const std::map<std::string, std::string>& given) {
  if (!file.table.empty()) throw UserError(": it has a table, which a text has no folder for");
  const StudyForm& form = file.forms.front();
  Study study = study_of(file, given);
  take_form(study, form);
  study.starts = published_starts(file, form.id, study);
  try {
    const ReadStudy read = read_formulas(study);
    if (read.residual) require_residual(read);
  } catch (const StudyFault& fault) {
    throw UserError(fault_in(file, fault, form.id));
  }
  return objective_of(study, file.norm, file.constraints);
}

}  // namespace

Prepared::Prepared(const std::string& text, const std::map<std::string, std::string>& given) {
  StudyFile file = read_study_file(text, "text");
  id_ = file.id;
  try {
    objective_ = first_objective(std::move(file), given);
  } catch (const UserError& error) {
    throw UserError(fmt::format("study '{}'{}", id_, error.what()));
  }
}

Prepared::Prepared(const Prepared& other) : id_(other.id_), objective_(other.objective_), fit_(other.fit_) {}

Prepared& Prepared::operator=(Prepared other) {
  std::swap(id_, other.id_);
  std::swap(objective_, other.objective_);
  std::swap(fit_, other.fit_);
  std::swap(squares_, other.squares_);
  return *this;
}

const StudyFit& Prepared::fit() {
  if (!fit_) fit_ = fit_study(objective_);
  return *fit_;
}

StudyFit Prepared::fit(const std::vector<std::vector<double>>& starts) {
  if (objective_.norm != Norm::least_squares || has_constraints(objective_.constraints) ||
      !objective_.study.bounds.empty())
    throw UserError(
        fmt::format("study '{}': starts are for least squares without constraints and bounds", id_));
  if (!squares_) squares_ = std::make_unique<PreparedStudy>(objective_.study);
  return squares_->fit_from(starts);
}

/// With these constants, or those of the fit.
StudySubject Prepared::subject(const Constants& constants) {
  Study study = objective_.study;
  study.residual.clear();  // a proof is of the form and its target
  const std::vector<std::string> names = read_formulas(study).parameters;
  const bool is_fitted = constants.empty() && !names.empty();
  if (is_fitted && fit().status != Status::converged)
    throw UserError(
        fmt::format("study '{}': the fit is {}: {}; give constants", id_, name(fit_->status), fit_->why));
  StudySubject result = subject_of(study, is_fitted ? constants_of(study, *fit_) : constants);
  const std::string fault = fault_of_constants(result.parameters, names, "the form");
  if (!fault.empty()) throw UserError(fmt::format("study '{}': {}", id_, fault));
  return result;
}

CertifiedError Prepared::certify(const Constants& constants) {
  const double width = usual_study_width(objective_.study.over.size());
  const auto [certificate, is_reached] = certify_study(subject(constants), width);
  return {certificate.lower, certificate.upper, is_reached, certificate_text(certificate)};
}

std::string Prepared::emit(Language language, const Constants& constants, ShaderPrecision precision) {
  const StudySubject of = subject(constants);
  const OthersText origin(of.parameters.empty() ? "no constant"
                          : constants.empty()   ? "fitted: " + objective_.words
                                                : "given");
  const auto [function, facts] = study_function(of, function_name(id_), origin);
  return code_below({}, facts, function, language, precision);
}

}  // namespace shadefit
