#include "app/lint/lint_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <system_error>

#include "app/options/declare_options.hpp"
#include "app/options/option_values.hpp"
#include "app/studies/find_study.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/input/json_document.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "lint/fixes.hpp"
#include "lint/lint_tree.hpp"
#include "lint/tree/lint_config.hpp"
#include "reports/findings/lint_findings.hpp"
#include "reports/findings/unified_diff.hpp"
#include "reports/io/output.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

constexpr std::array failing_grades{lint::Grade::truncated, lint::Grade::outdated, lint::Grade::typo,
                                    lint::Grade::wrong};
constexpr const char* never = "never";

std::vector<std::string> fail_on_words() {
  std::vector<std::string> words{never};
  for (const lint::Grade grade : failing_grades) words.emplace_back(name(grade));
  return words;
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

/// The fingerprints of an earlier report in JSON.
std::set<std::string> known_fingerprints(const std::string& file) {
  constexpr std::uintmax_t most_bytes = 64 << 20;
  const std::string what = fmt::format("--baseline '{}'", file);
  const auto json = parse_own_json(read_bounded(file, most_bytes), what);
  std::set<std::string> known;
  try {
    for (const auto& finding : json.at("findings"))
      known.insert(finding.at("fingerprint").get<std::string>());
  } catch (const nlohmann::json::exception&) {
    throw UserError(what + " is not a report of lint: make one with --format json");
  }
  return known;
}

std::string warnings_of(const lint::SkippedFiles& skipped) {
  std::string lines;
  for (const std::string& message : skipped.messages)
    lines += fmt::format("shadefit: {}\n", one_line(message));
  return lines;
}

/// A file that fixes change.
struct FixedFile {
  std::string name;           ///< as in `LintedSite::file`
  std::string before, after;  ///< its bytes
  long numbers = 0;           ///< that are rewritten
};

/// The files that fixes change, each read and judged once more. Of these the tree gets the sites that are
/// left once they are written.
std::vector<FixedFile> fixed_files(
    lint::LintedTree& tree, const lint::SourceTree& sources, lint::FixScope scope,
    const std::function<std::vector<lint::LintedSite>(const lint::SourceFile&, const std::string&)>& judge) {
  std::set<std::string> faulty;
  for (const lint::LintedSite& site : tree.sites)
    if (site.grade != lint::Grade::right) faulty.insert(site.file);
  std::vector<FixedFile> files;
  for (const lint::SourceFile& source : sources.files) {
    if (!faulty.contains(source.name)) continue;
    FixedFile file{source.name, read_bounded(source.path, lint::largest_source), {}};
    const std::vector<lint::Fix> fixes = lint::fixes_of(judge(source, file.before), file.before, scope);
    if (fixes.empty()) continue;
    file.after = lint::fixed_text(file.before, fixes);
    file.numbers = std::ssize(fixes);
    std::erase_if(tree.sites, [&](const lint::LintedSite& site) { return site.file == source.name; });
    std::ranges::move(judge(source, file.after), std::back_inserter(tree.sites));
    files.push_back(std::move(file));
  }
  std::ranges::stable_sort(tree.sites, {}, &lint::LintedSite::file);
  return files;
}

/// The returned call writes the files, with their permissions; of a link, the file that it leads to.
std::function<void()> prepare_files(const std::vector<FixedFile>& files) {
  std::map<fs::path, std::vector<File>> by_folder;
  for (const FixedFile& file : files) {
    std::error_code error;
    const fs::path path = fs::canonical(file.name, error);
    if (error) throw UserError(fmt::format("cannot write '{}': {}", file.name, error.message()));
    by_folder[path.parent_path()].push_back({path.filename().string(), file.after});
  }
  for (const auto& [folder, of_folder] : by_folder) require_writable(folder);
  return [by_folder] {
    for (const auto& [folder, of_folder] : by_folder) write_files(folder, of_folder);
  };
}

lint::LintedTree lint_standard_input(const LintOptions& options, const lint::KnownConstants& known,
                                     const lint::EffectLimits& limits, const Checkpoint& checkpoint) {
  if (options.paths.size() > 1)
    throw UserError("'-' reads standard input: it goes with no other PATH (a file of this name is './-')");
  if (options.fix || options.diff)
    throw UserError("--fix and --diff change files: they do not go with '-', standard input");
  if (options.languages.size() > 1) throw UserError("'-' has one --language");
  const lint::SourceLanguage language =
      options.languages.empty() ? lint::SourceLanguage::glsl : options.languages.front();
  const std::string text = read_standard_input(lint::largest_source, checkpoint);
  lint::LintedTree linted;
  linted.files = 1;
  linted.sites = lint_source("<stdin>", text, language, known, limits, checkpoint, &linted.skipped);
  return linted;
}

/// What a reader may do about the findings: commands to copy. `paths` are those of the command line.
std::string next_steps(const LintAdvice& advice, const std::vector<std::string>& paths,
                       const StudyFolders& studies) {
  if (advice.id.empty()) return "";
  std::string text = fmt::format("Next: shadefit explain {}\n", advice.id);
  if (!advice.fix.empty() && paths != std::vector<std::string>{"-"}) {
    std::vector<std::string> words{"lint"};
    words.insert(words.end(), paths.begin(), paths.end());
    words.insert(words.end(), {"--fix", advice.fix});
    text += fmt::format("      {} (with --diff it only shows the change)\n", shell_text(words));
  }
  const bool is_exact = std::ranges::any_of(study_folders(studies), [&](const fs::path& folder) {
    return fs::exists(folder / "exact" / (advice.id + ".toml"));
  });
  return is_exact ? text : text + fmt::format("      shadefit better {}\n", advice.id);
}

Outcome report_of(const lint::LintedTree& linted, const LintReportOptions& shown, const LintOptions& given) {
  const findings::FindingFormat format = given.format;
  const findings::FindingReport report = lint_findings(linted, shown);
  std::string out = write_findings(report, format);
  if (format == findings::FindingFormat::text)
    out += next_steps(lint_advice(linted, shown, report), given.paths, given.studies);
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

lint::KnownConstants known_constants(const StudyFolders& given, std::vector<std::string>* refused) {
  LoadedStudies studies = load_studies(known_study_files(study_folders(given)));
  if (refused != nullptr) *refused = std::move(studies.refused);
  return lint::KnownConstants(lint::known_sets(studies.files));
}

void declare_lint(CLI::App& lint, LintOptions& options) {
  lint.add_option("paths", options.paths,
                  "files and folders (default: `paths` of .shadefit.toml); '-' reads standard input")
      ->type_name("PATH");
  add_finding_format(lint, options.format);
  Choices<std::string> grades;
  for (const std::string& word : fail_on_words()) grades.emplace_back(word, word);
  add_choice(lint, "--fail-on", options.fail_on, grades, "the mildest grade that fails (default: wrong)");
  const auto effect = parse_finite_with([](double value) { return value >= 0; }, "must be at least 0");
  add_value(
      lint, "--max-effect", options.max_effect, effect, "X",
      "a number that moves its curve by more is wrong (default: 0.001; for a colour half an 8-bit sRGB code)");
  add_value(lint, "--baseline", options.baseline, parse_text, "FILE",
            "do not fail for findings that are in FILE, the output of an earlier --format json");
  add_values(lint, "--exclude", options.exclude, parse_text, "GLOB",
             "leave out files and folders that match, as a line of .gitignore without '!'; may be repeated");
  add_values(lint, "--language", options.languages, parse_choice(by_name(lint::source_languages)), "NAME",
             "only files of this language; may be repeated; of standard input its language (default: glsl)");
  add_values(lint, "--studies", options.studies, parse_text, "DIR",
             "also guard the constants of the studies in this folder; may be repeated");
  const auto scope = [parse = parse_choice(by_name(lint::fix_scopes))](const std::string& option,
                                                                       const std::string& text) {
    return text.empty() ? lint::FixScope::pins : parse(option, text);
  };
  add_value(
      lint, "--fix", options.fix, scope, "pins|typo|wrong",
      "replace numbers by the published digits. pins (also without a value): pinned numbers; wrong: also those "
      "of the grade wrong; typo: also those of the grades wrong and typo")
      ->expected(0, 1);
  lint.add_flag("--diff", options.diff,
                "print what --fix would change (alone: --fix pins), and write nothing");
  lint.add_flag("--all", options.all, "also print the constants that are right");
}

Outcome lint_command(const LintOptions& given, const Watched& work) {
  lint::TreeOptions tree;
  const LintOptions options = with_config(given, tree);
  if (options.diff && options.format != findings::FindingFormat::text)
    throw UserError(fmt::format("--diff prints a diff: it takes no --format {}", name(options.format)));
  LintReportOptions shown{.fail_on = {}, .all = options.all};
  for (const lint::Grade grade : failing_grades)
    if (options.fail_on.value_or("wrong") == name(grade)) shown.fail_on = grade;
  if (options.baseline) shown.known = known_fingerprints(*options.baseline);
  if (const auto& folder = tree.configured.folder; !folder.empty())
    shown.project = fs::absolute(folder).lexically_normal();
  lint::EffectLimits limits;
  limits.of_all = options.max_effect;
  std::vector<std::string> refused;
  const lint::KnownConstants known = known_constants(options.studies, &refused);
  if (std::ranges::find(options.paths, "-") != options.paths.end())
    return report_of(lint_standard_input(options, known, limits, work.checkpoint), shown, given);
  work.progress("reading the source tree");
  const lint::SourceTree sources = lint::find_sources(options.paths, tree);
  const Checkpoint next = stepping(work, "lint", sources.files.size());
  lint::LintedTree linted =
      lint_tree(sources, known, limits, {.before_each = next, .checkpoint = work.checkpoint});
  work.progress("");
  linted.skipped.messages.insert(linted.skipped.messages.begin(), refused.begin(), refused.end());
  if (!options.fix && !options.diff) return report_of(linted, shown, given);
  const auto judge = [&](const lint::SourceFile& file, const std::string& text) {
    return lint_source(file.name, text, file.language, known, limits, work.checkpoint);
  };
  const std::vector<FixedFile> files =
      fixed_files(linted, sources, options.fix.value_or(lint::FixScope::pins), judge);
  if (options.diff) {
    std::string diffs;
    for (const FixedFile& file : files) diffs += unified_diff(file.name, file.before, file.after);
    return {diffs.empty() ? 0 : 1, diffs, warnings_of(linted.skipped)};
  }
  std::set<fs::path> folders;
  for (const lint::SourceFile& file : sources.files) folders.insert(fs::path(file.path).parent_path());
  for (const fs::path& folder : folders) remove_leftovers(folder.empty() ? "." : folder);
  Outcome outcome = report_of(linted, shown, given);
  if (files.empty()) return outcome;
  long numbers = 0;
  for (const FixedFile& file : files) numbers += file.numbers;
  outcome.err += fmt::format("shadefit: rewrote {} in {}\n", counted(numbers, "number"),
                             counted(std::ssize(files), "file"));
  outcome.put = prepare_files(files);
  return outcome;
}

}  // namespace shadefit
