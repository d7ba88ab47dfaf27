#pragma once

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
};

/// A finding for each site that is not right. The levels: error from `fail_on` on, else warning for `wrong`,
/// `typo` and `outdated`, else note. A comment is a note.
findings::FindingReport lint_findings(const lint::LintedTree& tree, const LintReportOptions& options);

/// "3 files were not read: 2 minified, 1 too large. 1 folder of others". Empty if nothing was left out.
std::string skipped_words(const lint::SkippedFiles& skipped);

}  // namespace shadefit
