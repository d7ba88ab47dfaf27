#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "lint/lint_tree.hpp"
#include "reports/findings/finding.hpp"

/// What `lint` found, as findings.
namespace shadefit {

/// Which sites are shown, and which of them fail.
struct LintReportOptions {
  /// The least grade that fails; empty: none does.
  std::optional<lint::Grade> fail_on = lint::Grade::wrong;
  bool all = false;                  ///< also those that are right
  std::set<std::string> known = {};  ///< fingerprints of a baseline
  /// From where fingerprints name the files, so that a baseline holds wherever one stands in the project;
  /// empty: the current folder.
  std::filesystem::path project = {};
};

/// A finding for each site that is not right. The levels: error from `fail_on` on, else warning for `wrong`,
/// `typo` and `outdated`, else note. A comment is a note.
findings::FindingReport lint_findings(const lint::LintedTree& tree, const LintReportOptions& options);

/// What to look at first of these findings of the tree: the id of the worst site that is shown, and the value
/// of --fix that rewrites numbers. Empty where there is nothing to do.
struct LintAdvice {
  std::string id, fix;
};
LintAdvice lint_advice(const lint::LintedTree& tree, const LintReportOptions& options,
                       const findings::FindingReport& report);

/// "not read: 1 folder of others, 2 minified". Empty if nothing was left out.
std::string skipped_words(const lint::SkippedFiles& skipped);

}  // namespace shadefit
