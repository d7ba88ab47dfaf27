#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/commands/commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/better/better_study.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/better/results.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/rows/statement.hpp"

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

std::string function_name(std::string_view id, const EmitOptions& options) {
  if (options.name) return parse_function_name(*options.name);
  std::string text(id);
  std::ranges::replace(text, '-', '_');
  return text;
}

/// The command that generates the file.
std::string command_of(const EmitOptions& options) {
  std::vector<std::string> words = options.fit.words;
  const auto after_id = words.begin() + (options.fit.id.empty() ? 1 : 2);
  words.insert(after_id, {"--lang", std::string(name(*options.language))});
  return command_text(words);
}

/// "a = -5.5, b = -7"
std::string constants_text(const Constants& constants) {
  return joined(constants, ", ", [](const auto& constant) {
    return fmt::format("{} = {}", constant.first, decimal_of(constant.second));
  });
}

/// A function below a comment with the command and these facts, which are about numbers that are not rounded.
std::string code_with(const std::vector<OthersText>& facts, const ShaderFunction& function,
                      const EmitOptions& options) {
  std::vector<OthersText> comment{std::string(generated_line), command_of(options), OthersText()};
  comment.insert(comment.end(), facts.begin(), facts.end());
  if (options.precision == ShaderPrecision::float16)
    comment.emplace_back("The rounding of constants and operations to half comes on top.");
  return shader_code({&function, 1}, *options.language, options.precision, comment);
}

/// What is known of the largest error of a curve: a proven bound, or a sampled one.
struct KnownError {
  bool is_proven;
  double magnitude;
};

KnownError known_error(const StudySubject& subject, const Checkpoint& checkpoint) {
  const Study& study = subject.study;
  const ReadStudy read = read_formulas(study);
  std::vector<double> values;
  for (const auto& [name, text] : subject.parameters) values.push_back(constant<double>(decimal_of(text)));
  const auto sampled = [&] { return largest_error(read, values).magnitude; };
  if (study.rows || integral_depth(error_formula(read)) > 1) return {false, sampled()};
  try {
    // the fourth digit of a bound is rounded up
    const double width = std::max(1e-6, usual_study_width(study.over.size()));
    return {true, certify_study(subject, width, checkpoint).certificate.upper};
  } catch (const CheckFailed&) {
    // The formulas have no finite bound in intervals. Samples say what they can, unless the error is infinite.
    const double magnitude = sampled();
    if (!std::isfinite(magnitude) || pole_of(read, values)) throw;
    return {false, magnitude};
  }
}

/// "k = 5", "k = 3 to 15 (13 values)": the given constants of all studies.
std::string given_of(const std::vector<Study>& studies) {
  return joined(studies.front().given, "", [&](const auto& given) {
    const auto& [name, first] = given;
    const std::string& last = studies.back().given.at(name);
    return ", " + name + " = " + first +
           (last == first ? "" : fmt::format(" to {} ({} values)", last, studies.size()));
  });
}

/// What is known of the largest error of the code, for all studies with these constants.
std::string error_line(const std::vector<Study>& studies, const Constants& constants,
                       const Checkpoint& checkpoint) {
  bool is_proven = true;
  double most = 0;
  for (const Study& study : studies) {
    const auto [is_bound, magnitude] = known_error({study, constants}, checkpoint);
    is_proven = is_proven && is_bound;
    most = std::max(most, magnitude);
  }
  const Study& study = studies.front();
  const std::string ranges = joined(read_formulas(study).axes, ", ", [](const StudyAxis& axis) {
    return fmt::format("{} in [{}, {}]", axis.variable, axis.lower, axis.upper);
  });
  const std::string places = ranges + given_of(studies);
  if (!is_proven)
    return fmt::format("Sampled: absolute error at most {:.4g} for {}, in exact arithmetic.", most, places);
  return fmt::format("Proven: {}{} error at most {} for {}, in exact arithmetic.",
                     study.weight == "1" ? "" : "weighted ", name(study.error), decimal_above(most, 4),
                     places);
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
                                  const EmitOptions& options, const Checkpoint& checkpoint,
                                  const Progress& progress) {
  if (options.better && is_known_id(file.id))
    throw UserError(fmt::format("--better is for a study: see 'shadefit better {}'", options.fit.id));
  if (options.better && studies.size() == 1) {
    ChosenStudySubject better = better_subject(file, studies.front(), options, checkpoint);
    studies.front() = better.subject.study;
    return better;
  }
  std::optional<ChosenStudySubject> first;
  const Checkpoint next = stepping(checkpoint, progress, "emit", studies.size());
  for (Study& study : studies) {
    next();
    auto chosen = chosen_study_subject(file, study, options.parameters, options.fit, checkpoint);
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

/// The form with its constants. A given constant of several values is an argument.
ShaderFunction function_of(const std::string& name, const Study& study, const Constants& constants,
                           bool is_for_several) {
  Study free = study;
  if (is_for_several) {
    for (const auto& [given, value] : study.given) free.over.push_back({given, "0", "1"});
    free.given.clear();
  }
  const ReadStudy read = read_formulas(free);
  if (integral_depth(read.form) > 0)
    throw UserError(fmt::format("emit has no code for 'integral' in the form '{}'", study.form));
  return {name, variables_of(read.axes), with_constants(read.form, constants)};
}

std::string study_code(const StudyFile& file, const EmitOptions& options, const Checkpoint& checkpoint,
                       const Progress& progress) {
  const std::string name = function_name(file.id.empty() ? "approximation" : file.id, options);
  std::vector<Study> studies = combinations(file.study, file.given);
  const auto [subject, from, origin] = chosen_for_all(file, studies, options, checkpoint, progress);
  const Study& study = subject.study;
  const ShaderFunction function = function_of(name, study, subject.parameters, studies.size() > 1);
  const std::vector<OthersText> facts{
      study.form + " for " + OthersText(study.rows ? "the rows of " + study.rows->file : study.target) +
          (file.about.empty() || !is_known_id(file.id) ? OthersText() : "; " + file.about),
      constants_text(subject.parameters) + " (" + origin + ")",
      error_line(studies, subject.parameters, checkpoint),
  };
  return code_with(facts, function, options);
}

}  // namespace

Outcome emit_command(const EmitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (!options.check.empty()) {
    if (!options.fit.id.empty() || options.language)
      throw UserError(fmt::format("--check '{}' takes no other argument: the file names its own command",
                                  options.check.front()));
    return check_generated_files(options.check, checkpoint);
  }
  if (!options.language) {
    const auto name_of = [](Language language) { return name(language); };
    throw UserError("emit needs --lang: one of " + joined(languages, ", ", name_of));
  }
  if (options.fit.study.table == "-")
    throw UserError("--table '-' does not go with emit: the code names its table, for --check");
  const auto file = options.out ? std::optional(OutputFile("--out", *options.out, "the code")) : std::nullopt;
  const StudyFile study = chosen_study(options.fit, checkpoint);
  const std::string code = study_code(study, options, checkpoint, progress);
  if (!file) return {0, code, ""};
  return {0, fmt::format("Code: {}\n", printable(*options.out)), "",
          file->prepare(code, options.force, checkpoint)};
}

}  // namespace shadefit
