#include "app/lint/lint_command.hpp"

#include <fmt/format.h>

#include <set>

#include "app/lint/lint_fix.hpp"
#include "app/options/finding_format.hpp"
#include "app/options/option_values.hpp"
#include "app/studies/find_study.hpp"
#include "fit/support/bounded_file.hpp"
#include "fit/support/json_document.hpp"
#include "fit/support/user_error.hpp"
#include "lint/lint_tree.hpp"
#include "lint/tree/lint_config.hpp"
#include "reports/lint/lint_findings.hpp"
#include "reports/lint/unified_diff.hpp"

namespace shadefit {
namespace {

constexpr std::array failing_grades{lint::Grade::truncated, lint::Grade::outdated, lint::Grade::typo,
                                    lint::Grade::wrong};
constexpr const char* never = "never";

std::vector<std::string> fail_on_words() {
  std::vector<std::string> words{never};
  for (const lint::Grade grade : failing_grades) words.emplace_back(name(grade));
  return words;
}

std::optional<lint::Grade> grade_named(const std::string& word) {
  for (const lint::Grade grade : failing_grades)
    if (word == name(grade)) return grade;
  return std::nullopt;
}

/// Options that are not given, from the file of the project, whose folder `tree.configured` has then.
LintOptions with_config(LintOptions options, lint::TreeOptions& tree) {
  tree.exclude = options.exclude;
  if (const auto config = lint::find_lint_config(fail_on_words())) {
    if (!options.fail_on) options.fail_on = config->fail_on;
    if (!options.max_effect) options.max_effect = config->max_effect;
    if (!options.baseline && config->baseline) options.baseline = config->baseline->string();
    if (options.paths.empty()) options.paths = config->paths;
    if (options.languages.empty()) options.languages = config->languages;
    tree.configured = {config->file.parent_path(), config->exclude};
  }
  tree.languages = options.languages;
  if (options.paths.empty())
    throw UserError("lint needs a PATH, or 'paths' in .shadefit.toml: a file or a folder");
  return options;
}

/// All published sets: those of the studies, and exact constants, which stand in the folder `exact` beside
/// them.
lint::KnownConstants known_constants(const StudyFolders& given) {
  std::vector<std::filesystem::path> folders = study_folders(given);
  const std::size_t count = folders.size();
  for (std::size_t i = 0; i < count; ++i) folders.push_back(folders[i] / "exact");
  std::vector<StudyFile> studies;
  for (const auto& path : study_files(folders)) studies.push_back(load_study(path));
  return lint::KnownConstants(lint::known_sets(studies));
}

/// The fingerprints of an earlier report in JSON.
std::set<std::string> known_fingerprints(const std::string& file) {
  constexpr std::uintmax_t most_bytes = 64 << 20;
  const std::string what = fmt::format("--baseline '{}'", file);
  const auto json = parse_own_json(read_bounded(file, most_bytes), what);
  if (!json.is_object() || !json.contains("findings") || !json["findings"].is_array())
    throw UserError(what + " is not a report of lint: make one with --format json");
  std::set<std::string> known;
  for (const auto& finding : json["findings"]) {
    if (!finding.is_object() || !finding.contains("fingerprint") || !finding["fingerprint"].is_string())
      throw UserError(what + " has a finding without a fingerprint");
    known.insert(finding["fingerprint"].get<std::string>());
  }
  return known;
}

std::string warnings_of(const lint::SkippedFiles& skipped) {
  std::string lines;
  for (const std::string& message : skipped.messages) lines += fmt::format("shadefit: {}\n", message);
  return lines;
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string words_of(const std::vector<FixedFile>& files) {
  std::size_t numbers = 0;
  for (const FixedFile& file : files) numbers += file.numbers;
  return fmt::format("shadefit: rewrote {} in {}\n", counted(numbers, "number"),
                     counted(files.size(), "file"));
}

Outcome report_of(const lint::LintedTree& linted, const LintReportOptions& shown,
                  findings::FindingFormat format) {
  const findings::FindingReport report = lint_findings(linted, shown);
  std::string out = write_findings(report, format);
  std::string warnings = warnings_of(linted.skipped);
  if (const std::string skipped = skipped_words(linted.skipped); !skipped.empty()) {
    // The formats for programs have no place for it.
    if (format == findings::FindingFormat::text)
      out += skipped + "\n";
    else
      warnings += fmt::format("shadefit: {}\n", skipped);
  }
  return {passes(report) ? 0 : 1, out, warnings};
}

}  // namespace

void declare_lint(CLI::App& lint, LintOptions& options) {
  lint.add_option("paths", options.paths, "files and folders (default: `paths` of .shadefit.toml)")
      ->type_name("PATH");
  add_finding_format(lint, options.format, true);
  Choices<std::string> grades;
  for (const std::string& word : fail_on_words()) grades.emplace_back(word, word);
  add_choice(lint, "--fail-on", options.fail_on, grades, "the least grade that fails (default: wrong)");
  const auto effect = [](const std::string& option, const std::string& text) {
    const double value = parse_finite(option, text);
    if (value < 0) throw UserError(fmt::format("{} '{}' must be at least 0", option, text));
    return value;
  };
  add_value(lint, "--max-effect", options.max_effect, effect, "X",
            "a curve that moves by more is wrong (default: 0.001, of a colour half an 8-bit sRGB code)");
  add_value(lint, "--baseline", options.baseline, parse_text, "FILE",
            "do not fail for what this report has, an earlier --format json");
  add_values(lint, "--exclude", options.exclude, parse_text, "GLOB",
             "leave these files out, as .gitignore does; may be repeated");
  const auto language = [](const std::string& option, const std::string& text) {
    if (const auto found = lint::language_named(text)) return *found;
    std::vector<std::string> words;
    for (const lint::SourceLanguage one : lint::source_languages) words.emplace_back(name(one));
    throw UserError(
        fmt::format("{} '{}' is unknown: it must be one of {}", option, text, fmt::join(words, ", ")));
  };
  add_values(lint, "--language", options.languages, language, "NAME",
             "only files of this language; may be repeated");
  add_values(lint, "--studies", options.studies, parse_text, "DIR",
             "also guard the constants of the studies in this folder; may be repeated");
  const auto scope = [](const std::string& option, const std::string& text) {
    std::vector<std::string_view> words;
    for (const lint::FixScope one : lint::fix_scopes) {
      if (text == name(one) || text.empty()) return one;  // the first one without a value
      words.push_back(name(one));
    }
    throw UserError(
        fmt::format("{} '{}' is unknown: it must be one of {}", option, text, fmt::join(words, ", ")));
  };
  add_value(
      lint, "--fix", options.fix, scope, "pins|typo|wrong",
      "write the published digits. pins (also without a value): of pinned numbers; wrong: also of wrong "
      "ones; typo: also of wrong and mistyped ones")
      ->expected(0, 1);
  lint.add_flag("--diff", options.diff,
                "print what --fix would change (alone: --fix pins), and write nothing");
  lint.add_flag("--all", options.all, "also print the constants that are right");
}

Outcome lint_command(const LintOptions& given, const Checkpoint& checkpoint, const Progress& progress) {
  lint::TreeOptions tree;
  const LintOptions options = with_config(given, tree);
  if (options.diff && options.format != findings::FindingFormat::text)
    throw UserError(fmt::format("--diff prints a diff: it takes no --format {}", name(options.format)));
  LintReportOptions shown{.fail_on = grade_named(options.fail_on.value_or("wrong")), .all = options.all};
  if (options.baseline) shown.known = known_fingerprints(*options.baseline);
  if (const auto& folder = tree.configured.folder; !folder.empty())
    shown.project = std::filesystem::absolute(folder).lexically_normal();
  lint::EffectLimits limits;
  limits.of_all = options.max_effect;
  const lint::KnownConstants known = known_constants(options.studies);
  progress("reading the source tree");
  const lint::SourceTree sources = lint::find_sources(options.paths, tree);
  const Checkpoint next = stepping(checkpoint, progress, "lint", lint::count_pieces(sources));
  lint::LintedTree linted =
      lint_tree(sources, known, limits, {.before_each = next, .checkpoint = checkpoint});
  progress("");
  if (!options.fix && !options.diff) return report_of(linted, shown, options.format);
  const std::vector<FixedFile> files = fixed_files(linted, options.fix.value_or(lint::FixScope::pins));
  if (options.diff) {
    std::string diffs;
    for (const FixedFile& file : files) diffs += unified_diff(file.name, file.before, file.after);
    return {diffs.empty() ? 0 : 1, diffs, warnings_of(linted.skipped)};
  }
  judge_again(linted, files, sources, known, limits, checkpoint);
  Outcome outcome = report_of(linted, shown, options.format);
  if (files.empty()) return outcome;
  outcome.err += words_of(files);
  outcome.put = prepare_files(files, checkpoint);
  return outcome;
}

}  // namespace shadefit
