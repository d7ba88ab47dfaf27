#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/support/parallel.hpp"
#include "lint/lint_text.hpp"
#include "lint/tree/source_tree.hpp"

/// Judges the published constants of source trees.
namespace shadefit::lint {

struct LintedTree {
  std::vector<LintedSite> sites;  ///< by file, then by place
  std::size_t files = 0;          ///< that were read
  SkippedFiles skipped;
};

/// Reads and judges each file as a piece of work of its own, on all cores. A site with a comment "shadefit:
/// ignore REASON" in its line or in the line above keeps its grade and gets the reason. A pinned number is
/// judged by its pin alone: the other sites with this number are left out if the rest of their numbers are
/// right.
LintedTree lint_tree(const SourceTree& tree, const KnownConstants& known, const EffectLimits& limits,
                     const InParallel& how = {});

/// The sites of one text; those inside tables of numbers are only counted, in `skipped`. The checkpoint is
/// that of `judge_text`.
std::vector<LintedSite> lint_source(const std::string& file, std::string_view text, SourceLanguage language,
                                    const KnownConstants& known, const EffectLimits& limits,
                                    const Checkpoint& checkpoint = keep_going,
                                    SkippedFiles* skipped = nullptr);

}  // namespace shadefit::lint
