#include <fmt/format.h>

#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/output/draw_figures.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/rounding/round_study.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/figures.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/studies/study_extras.hpp"
#include "reports/studies/study_figure.hpp"
#include "reports/studies/study_proof_rows.hpp"
#include "reports/studies/study_rows.hpp"

/// The subcommand `fit`.
namespace shadefit {
namespace {

std::string not_converged_lines(const std::vector<FittedStudy>& studies) {
  std::string lines;
  for (const FittedStudy& study : studies) {
    if (study.fit.status == Status::converged) continue;
    const std::string given = given_text(study.asked());
    lines += fmt::format("shadefit: the fit{}{} is {}: {}", given.empty() ? "" : " of ", given,
                         name(study.fit.status), study.fit.why);
    for (std::size_t i = 0; i < study.fit.other.size(); ++i)
      lines += fmt::format(", {} = {} or {}", study.fit.names[i], to_text(study.fit.parameters[i]),
                           to_text(study.fit.other[i]));
    lines += "\n";
  }
  return lines;
}

/// The standard errors of fits of measured rows.
std::string uncertainty_block(const std::vector<FittedStudy>& studies, const Terminal& terminal) {
  if (studies.front().asked().rows == nullptr) return "";
  const Table table = uncertainty_table(studies);
  return (table.rows.empty() ? "" : "\n" + write_console(table, Precision::report, terminal)) +
         uncertainty_text(studies);
}

/// The verdicts on the sets of the first form.
std::vector<JudgedSet> judged_sets(const StudyFile& file, const StudyObjective& objective,
                                   const Checkpoint& checkpoint) {
  std::vector<JudgedSet> sets;
  for (const PublishedSet& set : file.published) {
    if (set.form != file.forms.front().id || !is_for(set, objective.study)) continue;
    checkpoint();
    // A held constant is not fitted, so it is not judged.
    PublishedSet judged = set;
    for (const Held& held : objective.study.held)
      std::erase_if(judged.values, [&](const auto& value) { return value.first == held.parameter; });
    if (!judged.values.empty()) sets.push_back({judged, judge_set(objective, judged, checkpoint)});
  }
  return sets;
}

/// The fits for a terminal. If the columns of the constants leave no room for the largest error and the
/// verdict, they are one column that can be folded.
Table table_for(const std::vector<FittedStudy>& studies, const Terminal& terminal) {
  constexpr std::size_t rest = 32;
  Table table = study_table(studies);
  const std::size_t first = studies.front().asked().given.size(), count = studies.front().fit.names.size();
  std::size_t taken = rest;
  for (std::size_t i = first; i < first + count; ++i) {
    std::size_t widest = table.columns[i].size();
    for (const auto& row : table.rows) widest = std::max(widest, text(row[i], Precision::report).size());
    taken += widest + 2;
  }
  if (terminal.width == 0 || taken <= terminal.width || count < 2) return table;
  return with_columns_as_one(table, first, count, "constants", Precision::report);
}

std::string console_text(const StudyFile& file, const std::vector<FittedStudy>& studies,
                         const Terminal& terminal) {
  const StudyFit& first = studies.front().fit;
  std::string text = file.id.empty() ? "" : file.id + ": ";
  text += for_terminal(study_headline(studies.front())) + "\n" +
          write_console(table_for(studies, terminal), Precision::report, terminal);
  for (const FittedStudy& study : studies) text += level_text(study);
  text += uncertainty_block(studies, terminal);
  if (first.status != Status::converged) return text;
  if (first.names.empty()) {
    const auto value_of = [](const Held& held) { return fmt::format("{} = {}", held.parameter, held.value); };
    return text + fmt::format("Nothing was fitted: {} are given.\n",
                              joined(studies.front().asked().held, ", ", value_of));
  }
  if (first.is_sampled) text += "The largest error is sampled: between the samples it may be larger.\n";
  if (first.is_global) return text + "The form is linear in its parameters: the best is global.\n";
  const std::string often =
      first.descents == 0 ? "" : fmt::format("; {} of {} descents ended there", first.lowest, first.descents);
  return text + fmt::format("The best of {} starts{}.\n", first.starts, often);
}

/// The fits of the first form, one for each combination of given constants, with the verdicts on the
/// published sets.
std::vector<FittedStudy> fitted_studies(const StudyFile& file, const Watched& work) {
  std::vector<FittedStudy> studies;
  const std::vector<Study> all = combinations(file.study, file.given);
  const Checkpoint next = stepping(work, "fit", all.size());
  for (Study study : all) {
    next();
    take_form(study, file.forms.front());
    if (study.starts.empty()) study.starts = published_starts(file, file.forms.front().id, study);
    StudyObjective objective = objective_of(study, file.norm, file.constraints);
    objective.recompute = file.recompute;
    studies.push_back({objective, read_formulas(study), fit_study(objective, work.checkpoint),
                       judged_sets(file, objective, work.checkpoint)});
  }
  return studies;
}

/// Requested additional results of each fit; empty without a request, and for a fit that did not converge.
struct StudyExtras {
  std::vector<std::optional<ProvenStudy>> proofs;
  std::vector<RoundedFit> rounded;  ///< by --round or --evaluate, which exclude each other
  std::vector<std::optional<Sensitivity>> sensitivities;
};

/// The numbers of the first published set. Empty without a set, and if one of its texts is not a number.
std::vector<double> published_values(const FittedStudy& study) {
  std::vector<double> values;
  if (study.published.empty()) return values;
  for (const std::string& text : values_of(study.published.front().set, study.fit.names)) {
    const auto value = value_of_numbers(text);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

StudyExtras extras_of(const std::vector<FittedStudy>& studies, const FitOptions& options,
                      const Watched& work) {
  StudyExtras extras;
  const char* what = options.certify    ? "certify"
                     : options.round    ? "round"
                     : options.evaluate ? "evaluate"
                                        : "sensitivity";
  const bool is_any = options.certify || options.round || options.evaluate || options.sensitivity;
  const Checkpoint next = stepping(work, what, is_any ? studies.size() : 0);
  for (const FittedStudy& study : studies) {
    next();
    const bool is_answer = study.fit.status == Status::converged;
    const StudyObjective& objective = study.objective;
    extras.proofs.emplace_back();
    if (is_answer && options.certify) {
      const double width = usual_study_width(study.read.axes.size());
      extras.proofs.back() = {certify_study(subject_of(study.asked(), constants_of(study.asked(), study.fit)),
                                            width, work.checkpoint),
                              "fitted"};
    }
    if (const auto& format = options.round ? options.round : options.evaluate)
      extras.rounded.push_back(rounded_fit(study, studies.size() > 1, [&] {
        return (options.round ? round_study : evaluate_study)(objective, study.fit, *format,
                                                              published_values(study), work.checkpoint);
      }));
    extras.sensitivities.emplace_back();
    if (is_answer && options.sensitivity)
      extras.sensitivities.back() = sensitivity_of(objective, study.fit, work.checkpoint);
  }
  return extras;
}

/// A row for each fit. A fit of measured rows has a table of its own, with its errors in a comment.
std::string latex_text(const StudyFile& file, const std::vector<FittedStudy>& studies) {
  const std::vector<std::string> names = formula_inputs(studies.front().read);
  const auto latex = [&](const Table& table) { return write_latex(table, Precision::report, names); };
  if (!file.study.rows) return latex(study_table(studies));
  return joined(studies, "\n", [&](const FittedStudy& study) {
    const std::string given = given_text(study.asked());
    return fmt::format("% {}{}: {}, rms error {:.4g}, largest residual {:.4g}\n",
                       for_comment(study_headline(study)), given.empty() ? "" : ", " + given,
                       name(study.fit.status), study.fit.rms_error, study.fit.max_abs_error.magnitude) +
           latex(parameters_table(study));
  });
}

/// A table of the proofs of those fits that converged.
std::string proofs_block(const std::vector<std::optional<ProvenStudy>>& all, const Terminal& terminal) {
  std::vector<ProvenStudy> proofs;
  for (const auto& proof : all) {
    if (proof) proofs.push_back(*proof);
  }
  if (proofs.empty()) return "";
  const StudyCertificate& first = proofs.front().certified.certificate;
  return fmt::format("\nThe largest {} error, proven in {} bits:\n", name(first.subject.study.error),
                     first.precision) +
         write_console(study_proofs_table(proofs), Precision::full, terminal) + ends_text(first);
}

std::string studies_text(const StudyFile& file, const std::vector<FittedStudy>& studies,
                         const StudyExtras& extras, const FitOptions& options) {
  const auto& [proofs, rounded, sensitivities] = extras;
  if (options.json) {
    auto json = study_json(studies);
    for (std::size_t i = 0; i < studies.size(); ++i) {
      if (proofs[i]) add_study_proof(json[i], *proofs[i]);
      if (!rounded.empty())
        add_rounding(json[i], options.round ? "rounded" : "evaluated", studies[i], rounded[i]);
      if (sensitivities[i]) json[i]["sensitivity"] = sensitivity_json(studies[i], *sensitivities[i]);
    }
    return json_text_of_each(json);
  }
  if (options.csv) {
    Table table = study_table(studies);
    if (file.study.rows) add_uncertainty_columns(table, studies);
    return write_csv(table, Precision::full);
  }
  if (options.latex) return latex_text(file, studies);
  std::string out = console_text(file, studies, options.terminal) + proofs_block(proofs, options.terminal);
  if (!rounded.empty()) out += roundings_text(studies, rounded, options.terminal);
  for (std::size_t i = 0; i < studies.size(); ++i) {
    if (sensitivities[i]) out += sensitivity_text(studies[i], *sensitivities[i], options.terminal);
  }
  return out;
}

}  // namespace

Outcome with_picture(Outcome outcome, const FitOptions& options, const std::function<Figure()>& figure,
                     const Checkpoint& checkpoint) {
  if (!options.plot) return outcome;
  const Figure made = figure();
  const auto output = output_file("--plot", *options.plot, "the picture");
  const Pictures pictures = draw_pictures(*find_gnuplot(), plot_files({made}), {made.name}, checkpoint);
  if (!pictures.failed.empty())
    throw UserError(
        fmt::format("--plot '{}' was not drawn: {}", *options.plot, pictures.failed.front().complaint));
  outcome.put = prepare_output_file(output, pictures.files.front().content, options.force, checkpoint);
  const std::string file = printable(*options.plot);
  if (options.json || options.csv || options.latex)
    outcome.err += fmt::format("shadefit: picture: {}\n", file);
  else
    outcome.out += fmt::format("Picture: {}\n", file);
  return outcome;
}

Outcome fit_command(const FitOptions& options, const Watched& work) {
  const Published* published = find_published(options.id);
  if (published != nullptr && published->statement != Statement::best_fit)
    throw UserError(
        fmt::format("'{0}' is a mean or a limit of fits, no fit: see 'shadefit explain {0}'", published->id));
  const StudyFile file = chosen_study(options, work.checkpoint);
  if (options.certify && file.study.rows)
    throw UserError("--certify does not go with --table: rows have no error between them");
  if (options.plot) require_picture(*options.plot);
  const auto studies = fitted_studies(file, work);
  const std::string err = not_converged_lines(studies);
  const auto extras = extras_of(studies, options, work);
  return with_picture(
      {err.empty() ? 0 : 1, studies_text(file, studies, extras, options), err}, options,
      [&] { return study_figure(studies); }, work.checkpoint);
}

}  // namespace shadefit
