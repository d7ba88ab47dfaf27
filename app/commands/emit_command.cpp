#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/commands/commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/better/better_study.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/better/results.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/study_code.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"

/// The subcommand `emit`.
namespace shadefit {
namespace {

std::string parse_function_name(const std::string& text) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const bool is_name = !text.empty() && std::ranges::all_of(text, is_letter) &&
                       std::isdigit(static_cast<unsigned char>(text.front())) == 0;
  if (!is_name)
    throw UserError(fmt::format(
        "--name '{}' is not the name of a function: letters, digits and '_', no digit first", text));
  if (const std::string_view reason = reason_to_refuse_name(text); !reason.empty())
    throw UserError(fmt::format("--name '{}' cannot be a function's name: {}", text, reason));
  return text;
}

/// The command that generates the file.
std::string command_of(const EmitOptions& options) {
  std::vector<std::string> words = options.fit.words;
  const auto after_id = words.begin() + (options.fit.id.empty() ? 1 : 2);
  words.insert(after_id, {"--lang", std::string(name(*options.language))});
  return command_text(words);
}

/// The set that `better` says to use in place of the first published one.
ChosenStudySubject better_subject(const StudyFile& file, const Study& study, const EmitOptions& options,
                                  const Checkpoint& checkpoint) {
  const std::string asks_for_fit = option_of_fits(options.fit.present);
  if (options.parameters || !asks_for_fit.empty())
    throw UserError(fmt::format("--better does not go with {}: it names the constants",
                                options.parameters ? "--parameters" : asks_for_fit));
  const StudyComparison comparison = compare_study(file, study, checkpoint, keep_going, Judged::no);
  const StudyContender* published = first_published(comparison);
  if (published == nullptr)
    throw UserError("--better needs a published set to start from: the study has none");
  const StudyContender* best = better_at_the_same_cost(comparison, *published);
  if (best == nullptr)
    throw UserError(fmt::format(
        "--better: no set of '{0}' errs less than the published one at no more cost and keeps its properties: see 'shadefit better {0}'",
        options.fit.id));
  return {subject_of(study, *best), "fitted",
          "fitted: " + best->origin + "; better than " + published->origin};
}

/// The same constants for all studies, and the origin of those of the first.
ChosenStudySubject chosen_for_all(const StudyFile& file, std::vector<Study>& studies,
                                  const EmitOptions& options, const Watched& work) {
  if (options.better && studies.size() == 1) {
    ChosenStudySubject better = better_subject(file, studies.front(), options, work.checkpoint);
    studies.front() = better.subject.study;
    return better;
  }
  std::optional<ChosenStudySubject> first;
  const Checkpoint next = stepping(work, "emit", studies.size());
  for (Study& study : studies) {
    next();
    auto chosen = chosen_study_subject(file, study, options.parameters, options.fit, work.checkpoint);
    const bool is_for_one = options.better || chosen.from == "fitted" ||
                            (first && first->subject.parameters != chosen.subject.parameters);
    if (studies.size() > 1 && is_for_one)
      throw UserError(fmt::format(
          "'{}' has {} values of its given constants, and these constants are for one: name it by {}",
          file.id, studies.size(), has_peak(file.study) ? "--exponent" : "--given"));
    study = chosen.subject.study;
    if (!first) first = std::move(chosen);
  }
  return *std::move(first);
}

std::string study_code(const StudyFile& file, const EmitOptions& options, const Watched& work) {
  const std::string name = options.name ? parse_function_name(*options.name)
                                        : function_name(file.id.empty() ? "approximation" : file.id);
  std::vector<Study> studies = combinations(file.study, file.given);
  const auto [subject, from, origin] = chosen_for_all(file, studies, options, work);
  StudyFunction code = study_function(studies, subject.parameters, name, origin, work.checkpoint);
  if (is_known_id(file.id) && !options.better) code.facts.front() = code.facts.front() + "; " + file.about;
  const std::vector<OthersText> head{std::string(generated_line), command_of(options), OthersText()};
  return code_below(head, code.facts, code.function, *options.language, options.precision);
}

}  // namespace

Outcome emit_command(const EmitOptions& options, const Watched& work) {
  if (!options.check.empty()) {
    if (!options.fit.id.empty() || options.language)
      throw UserError(fmt::format("--check '{}' takes no other argument: the file names its own command",
                                  options.check.front()));
    return check_generated_files(options.check, work.checkpoint);
  }
  if (!options.language) {
    const auto name_of = [](Language language) { return name(language); };
    throw UserError("emit needs --lang: one of " + joined(languages, ", ", name_of));
  }
  if (options.fit.study.table == "-")
    throw UserError("--table '-' does not go with emit: the code names its table, for --check");
  const auto file =
      options.out ? std::optional(output_file("--out", *options.out, "the code")) : std::nullopt;
  const StudyFile study = options.better ? compared_study(options.fit, work.checkpoint)
                                         : chosen_study(options.fit, work.checkpoint);
  const std::string code = study_code(study, options, work);
  if (!file) return {0, code, ""};
  return {0, fmt::format("Code: {}\n", printable(*options.out)), "",
          prepare_output_file(*file, code, options.fit.force, work.checkpoint)};
}

}  // namespace shadefit
