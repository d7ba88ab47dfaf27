#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/commands/commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/better/better_study.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/bounds/family_subject.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/study_code.hpp"
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
  return shadefit::function_name(id);
}

/// The command that generates the file.
std::string command_of(const EmitOptions& options) {
  std::vector<std::string> words = options.words;
  const auto after_id = words.begin() + (options.fit.id.empty() ? 1 : 2);
  words.insert(after_id, {"--lang", std::string(name(*options.language))});
  return command_text(words);
}

/// The proof of the constants over all settings of the code.
struct Proven {
  ChosenSubject chosen;  ///< at the last setting
  double upper = 0;      ///< bounds the error at all settings
  std::string target;
};

/// One set of constants for all settings, and its proof.
Proven proven_at(const std::vector<Setting>& settings, const NamedFit& named, const EmitOptions& options,
                 const Metric& metric, const Checkpoint& checkpoint, const Progress& progress) {
  Proven proven;
  const Checkpoint next = stepping(checkpoint, progress, "emit", settings.size());
  for (const Setting& setting : settings) {
    next();
    proven.chosen = chosen_constants(options.parameters, named, setting, metric, options.fit, checkpoint);
    if (settings.size() > 1 && !options.parameters && proven.chosen.from == "fitted")
      throw UserError(fmt::format(
          "emit '{}' needs --exponent with one exponent: fitted constants are for one", options.fit.id));
    // the fourth digit of a bound is rounded up
    constexpr double width = 1e-6;
    const CertifiedStudy certified = certify_study(in_words(proven.chosen.subject), width, checkpoint);
    proven.upper = std::max(proven.upper, certified.certificate.upper);
    proven.target = target_text(*named.family, setting);
  }
  return proven;
}

/// The form with its constants; the exponent is one of them if it was requested.
ShaderFunction function_of(const Family& family, const EmitOptions& options, const FamilySubject& subject) {
  Constants constants = subject.parameters;
  std::vector<std::string> arguments{"c"};
  if (options.fit.exponents) {
    constants.emplace_back("k", fmt::format("{}", subject.setting.exponent));
  } else if (family.has_exponent()) {
    arguments.emplace_back("k");
  }
  return {function_name(family.id, options), arguments, with_constants(family.form, constants)};
}

/// The origin of the constants: "published: Lagarde 2012, "Spherical Gaussian.."", "given", or how they were
/// fitted.
std::string origin_of(const NamedFit& named, const ChosenSubject& chosen, const Metric& metric,
                      const std::optional<NumberFormat>& round) {
  if (chosen.from == "fitted") return "fitted: " + (round ? words_of_rounding(*round) : headline(metric));
  if (chosen.from == "given") return "given";
  for (const Published& p : published_constants()) {
    const bool is_it = named.published != nullptr ? &p == named.published
                                                  : p.family == named.family->id &&
                                                        p.printed == chosen.subject.parameters.front().second;
    if (is_it) return fmt::format("published: {} {}, \"{}\"", p.source.author, p.source.year, p.source.title);
  }
  return "published";
}

std::string exponents_text(const std::vector<Setting>& settings) {
  if (settings.size() == 1) return fmt::format(", k = {}", settings.front().exponent);
  return fmt::format(", k = {} to {} ({} exponents)", settings.front().exponent, settings.back().exponent,
                     settings.size());
}

/// A function below a comment with the command and these facts.
std::string code_with(const std::vector<OthersText>& facts, const ShaderFunction& function,
                      const EmitOptions& options) {
  const std::vector<OthersText> head{std::string(generated_line), command_of(options), OthersText()};
  return code_below(head, facts, function, *options.language, options.precision);
}

std::string code_of(const EmitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const NamedFit named = find_fit(options.fit.id);
  const Family& family = *named.family;
  function_name(family.id, options);  // refuses a bad name before anything is computed
  const std::vector<Setting> settings = settings_for(family, named.published, options.fit);
  if (options.fit.exponents && settings.size() > 1)
    throw UserError(fmt::format(
        "--exponent names {} exponents: code is for one, or without the option for any", settings.size()));
  const Metric metric = metric_for(options.fit, family, settings);
  const Proven proven = proven_at(settings, named, options, metric, checkpoint, progress);
  const FamilySubject& subject = proven.chosen.subject;

  const std::vector<OthersText> facts{
      fmt::format("{} for {}; {}", to_text(family.form), proven.target, family.variables),
      fmt::format("{} ({})", constants_text(subject.parameters),
                  origin_of(named, proven.chosen, metric, options.fit.round)),
      fmt::format("Proven: {} error at most {} for c in [{}, {}]{}, in exact arithmetic.", name(metric.error),
                  decimal_above(proven.upper, 4), subject.domain.lower, subject.domain.upper,
                  family.has_exponent() ? exponents_text(settings) : ""),
  };
  return code_with(facts, function_of(family, options, subject), options);
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

std::string study_code(const StudyFile& file, const EmitOptions& options, const Checkpoint& checkpoint) {
  const std::string id = file.id.empty() ? "approximation" : file.id;
  const std::string name = function_name(id, options);
  const std::vector<Study> studies = combinations(file.study, file.given);
  if (studies.size() > 1)
    throw UserError(
        fmt::format("'{}' has {} values of its given constants: name one by --given", id, studies.size()));
  const auto [subject, from, origin] =
      options.better
          ? better_subject(file, studies.front(), options, checkpoint)
          : chosen_study_subject(file, studies.front(), options.parameters, options.fit, checkpoint);
  const StudyFunction code = study_function(subject, name, origin, checkpoint);
  return code_with(code.facts, code.function, options);
}

}  // namespace

Outcome emit_command(const EmitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (!options.check.empty()) {
    if (!options.fit.id.empty() || options.language)
      throw UserError(fmt::format("--check '{}' takes no other argument: the file names its own command",
                                  options.check.front()));
    return check_generated_files(options.check, checkpoint);
  }
  if (options.fit.id.empty() && !options.fit.study.form)
    throw UserError("emit needs the id of a form or --form (see 'shadefit list' and 'shadefit help emit')");
  if (!options.language) {
    const auto name_of = [](Language language) { return name(language); };
    throw UserError("emit needs --lang: one of " + joined(languages, ", ", name_of));
  }
  if (options.fit.study.table == "-")
    throw UserError("--table '-' does not go with emit: the code names its table, for --check");
  const auto file = options.out ? std::optional(OutputFile("--out", *options.out, "the code")) : std::nullopt;
  const auto study = chosen_study(options.fit, checkpoint);
  if (options.better && !study)
    throw UserError(fmt::format("--better is for a study: see 'shadefit better {}'", options.fit.id));
  const std::string code =
      study ? study_code(*study, options, checkpoint) : code_of(options, checkpoint, progress);
  if (!file) return {0, code, ""};
  return {0, fmt::format("Code: {}\n", printable(*options.out)), "",
          file->prepare(code, options.force, checkpoint)};
}

}  // namespace shadefit
