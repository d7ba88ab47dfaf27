#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/options/study_options.hpp"
#include "fit/study/minimax_study.hpp"
#include "fit/support/user_error.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/study_rows.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

/// Options that belong to built-in families, or that studies do not have yet.
void refuse_others(const FitOptions& options) {
  const auto refuse = [](const std::string& option, const std::string& why) {
    throw UserError(fmt::format("{} does not go with --form: {}", option, why));
  };
  if (!options.id.empty()) refuse(fmt::format("'{}'", options.id), "leave the family out");
  if (options.exponents) refuse("--exponent", "name it in the formulas and give it by --given");
  if (options.ior || options.extinction || options.f0)
    refuse(options.ior          ? "--ior"
           : options.extinction ? "--extinction"
                                : "--f0",
           "write the reflectance of the surface as the --target");
  if (options.metric.domain != Domain{}) refuse("--domain", "give the range by --over");
  if (options.metric.measure != Measure::cosine)
    refuse("--measure", "give the density by --over x=0:1:angle");
  if (options.metric.norm == Norm::least_squares) refuse_minimax_constraints(options.metric.constraints);
  if (options.certify || options.round || options.sensitivity || options.plot)
    refuse(options.certify       ? "--certify"
           : options.round       ? "--round"
           : options.sensitivity ? "--sensitivity"
                                 : "--plot",
           "only the constants are computed");
}

std::string not_converged_lines(const std::vector<FittedStudy>& studies) {
  std::string lines;
  for (const FittedStudy& study : studies) {
    if (study.fit.status == Status::converged) continue;
    std::string given;
    for (const auto& [constant, value] : study.asked.given) given += fmt::format(" {} = {}", constant, value);
    lines += fmt::format("shadefit: the fit{}{}: {}, {}\n", given.empty() ? "" : " of", given,
                         name(study.fit.status), study.fit.why);
    for (std::size_t i = 0; i < study.fit.other.size(); ++i)
      lines += fmt::format("shadefit: {} = {} or {}\n", study.fit.names[i], to_text(study.fit.parameters[i]),
                           to_text(study.fit.other[i]));
  }
  return lines;
}

}  // namespace

Outcome study_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  refuse_others(options);
  if (options.study.target.empty()) throw UserError("--form needs a --target: the formula to approximate");
  const std::vector<Study> asked = studies_of(options.study, options.metric);
  std::vector<FittedStudy> studies;
  const Checkpoint next = stepping(checkpoint, progress, "fit", asked.size());
  for (const Study& study : asked) {
    next();
    const ReadStudy read = read_study(study);
    const StudyFit fit = options.metric.norm == Norm::minimax
                             ? solve_minimax_study(read, options.metric.constraints, study.starts, checkpoint)
                             : solve_study(read, study.starts, checkpoint);
    studies.push_back({study, read, fit});
  }
  const std::string err = not_converged_lines(studies);
  const int code = err.empty() ? 0 : 1;
  if (options.json) return {code, json_text_of_each(study_json(studies)), err};
  const Table table = study_table(studies);
  if (options.csv) return {code, write_csv(table, Precision::full), err};
  if (options.latex) return {code, write_latex(with_digits(table, options.digits), Precision::report), err};
  const StudyFit& first = studies.front().fit;
  const std::string search = first.status != Status::converged ? ""
                             : first.is_global ? "The form is linear in its parameters: the best is global.\n"
                                               : fmt::format("The best of {} starts.\n", first.starts);
  std::string levels;
  for (const FittedStudy& study : studies) levels += level_text(study);
  return {code,
          study_headline(studies.front()) + "\n" + write_console(table, Precision::report, options.terminal) +
              levels + search,
          err};
}

}  // namespace shadefit
