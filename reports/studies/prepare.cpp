#include "reports/studies/prepare.hpp"

#include <fmt/format.h>

#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/study_file.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "fit/verdicts/study_verdict.hpp"
#include "reports/code/study_code.hpp"
#include "reports/studies/study_certificate_json.hpp"

namespace shadefit {

Prepared::Prepared(const std::string& text) {
  const StudyFile file = read_study_file(text, "text");
  const StudyForm& form = file.forms.front();
  id_ = file.id;
  try {
    if (!file.table.empty()) throw UserError(": it has a table, which a text has no folder for");
    const std::vector<Study> studies = combinations(file.study, file.given);
    if (studies.size() > 1)
      throw UserError(fmt::format(": its given constants have {} values: leave one of each", studies.size()));
    Study study = studies.front();
    take_form(study, form);
    study.starts = published_starts(file, form.id, study);
    read_ = read_formulas(study);
    if (read_->residual) require_residual(*read_);
    objective_ = objective_of(study, file.norm, file.constraints);
  } catch (const StudyFault& fault) {
    throw UserError(fmt::format("study '{}'{}", id_, fault_in(file, fault, form.id)));
  } catch (const UserError& error) {
    throw UserError(fmt::format("study '{}'{}", id_, error.what()));
  }
}

Prepared::Prepared(const Prepared& other)
    : id_(other.id_), objective_(other.objective_), read_(other.read_), fit_(other.fit_) {}

const StudyFit& Prepared::fit() {
  if (!fit_) fit_ = fit_study(objective_, *read_);
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
  const Study& study = objective_.study;
  const std::vector<std::string>& names = read_->parameters;
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
  const auto [function, facts] = study_function({of.study}, of.parameters, function_name(id_), origin);
  return code_below({}, facts, function, language, precision);
}

}  // namespace shadefit
