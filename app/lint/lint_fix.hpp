#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "lint/fix/fixes.hpp"
#include "lint/lint_tree.hpp"

/// `lint --fix` and `lint --diff`: files with the published digits.
namespace shadefit {

/// A file that fixes change.
struct FixedFile {
  std::string name;           ///< as in `LintedSite::file`
  std::string before, after;  ///< its bytes
  std::size_t numbers = 0;    ///< that are rewritten
};

/// The files of the tree that fixes change, read once more. Throws UserError for a file that has changed
/// since it was judged.
std::vector<FixedFile> fixed_files(const lint::LintedTree& tree, lint::FixScope scope);

/// The sites that are left once the files are written.
void judge_again(lint::LintedTree& tree, const std::vector<FixedFile>& files, const lint::SourceTree& sources,
                 const lint::KnownConstants& known, const lint::EffectLimits& limits,
                 const Checkpoint& checkpoint);

/// Writes the files beside the old ones, with their permissions; of a link, the file that it leads to. The
/// returned call moves them to their places. Throws UserError like `Output::prepare`.
std::function<void()> prepare_files(const std::vector<FixedFile>& files, const Checkpoint& checkpoint);

}  // namespace shadefit
