#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "lint/fixes.hpp"
#include "lint/grade.hpp"
#include "lint/lint_text.hpp"
#include "lint/tree/source_language.hpp"
#include "reports/findings/finding.hpp"

/// `shadefit lint PATH..`, or '-' for standard input: finds published constants in source trees and grades
/// them.
namespace shadefit {

/// What is not given comes from .shadefit.toml, then from these defaults.
struct LintOptions {
  std::vector<std::string> paths;  ///< files and folders
  findings::FindingFormat format = findings::FindingFormat::text;
  std::optional<std::string> fail_on;  ///< a grade, or "never"; else "wrong"
  std::optional<double> max_effect;    ///< instead of the limits of `EffectLimits`
  std::optional<std::string> baseline;
  std::vector<std::string> exclude;
  std::vector<lint::SourceLanguage> languages;
  StudyFolders studies;
  bool all = false;
  std::optional<lint::FixScope> fix;
  bool diff = false;  ///< of the files, in place of writing them
};

/// All published sets: those of the studies, of exact constants, and of the built-in families. `refused` gets
/// a line for each study that cannot be read.
lint::KnownConstants known_constants(const StudyFolders& given, std::vector<std::string>* refused = nullptr);

void declare_lint(CLI::App& lint, LintOptions& options);

/// Exit code 1 if a site has a grade that fails: with `fix`, after it; with `diff`, if there is one. Throws
/// UserError for bad paths, a bad configuration and a bad baseline.
Outcome lint_command(const LintOptions& options, const Watched& work);

/// `shadefit explain 5.55473`: the constants with these digits that `lint` knows, and the claims that print
/// them. Without any: the constants that differ by a digit. Empty if the text of the options is not a number.
/// Throws UserError if no constant has it.
std::optional<Outcome> explain_number(const ExplainOptions& options);

}  // namespace shadefit
