#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fit/support/parallel.hpp"
#include "lint/lint_text.hpp"
#include "lint/tree/source_tree.hpp"

/// Judges the published constants of source trees.
namespace shadefit::lint {

/// A place in a text. Lines and columns count from 1, columns in code points.
struct TextPlace {
  long line = 0, column = 0;
  auto operator<=>(const TextPlace&) const = default;
};

/// A number as it stands in a file.
struct NumberCopy {
  std::size_t offset = 0;  ///< in bytes
  std::string text;
};

/// A number of a site and the published one.
struct LintedNumber {
  std::string constant, published;  ///< name and digits
  std::string text;                 ///< as found
  Grade grade = Grade::right;
  std::size_t offset = 0;  ///< in the file, in bytes
  /// Whether the published number belongs there: no other number near it may be the constant, no other source
  /// may be meant, and the numbers are in the published units.
  bool is_certain = false;
  std::vector<NumberCopy> copies = {};  ///< the other components of a vector of this number
};

/// A site in a file, or a number that a mark pins to a constant (lint/pins.hpp).
struct LintedSite {
  std::string file;
  TextPlace begin, end;  ///< of its first number, and after its last
  std::string id, form;  ///< of the set
  std::string source;
  std::vector<LintedNumber> numbers;
  Grade grade = Grade::right;
  Effect effect = {};
  bool is_shown = false;
  bool is_encoded = false;               ///< see `KnownSet`
  std::string slip = {}, replaced = {};  ///< see JudgedSite
  bool is_in_comment = false;
  std::optional<std::string> ignored = {};  ///< the reason of a mark "shadefit: ignore REASON"
  bool is_pinned = false;
  std::string fault = {};  ///< why a mark pins nothing; then there are no numbers
};

struct LintedTree {
  std::vector<LintedSite> sites;  ///< by file, then by place
  std::size_t files = 0;          ///< that were read
  SkippedFiles skipped;
};

/// How many pieces of work a tree is: `before_each` of `lint_tree` is called once for each.
std::size_t count_pieces(const SourceTree& tree);

/// Reads and judges each file, on all cores. A site with a comment "shadefit: ignore REASON" in its line or
/// in the line above keeps its grade and gets the reason. A pinned number is judged by its pin alone: the
/// other sites with this number are left out if the rest of their numbers are right.
LintedTree lint_tree(const SourceTree& tree, const KnownConstants& known, const EffectLimits& limits,
                     const InParallel& how = {});

/// The sites of one text; those inside tables of numbers are only counted, in `skipped`. The checkpoint is
/// that of `judge_text`.
std::vector<LintedSite> lint_source(const std::string& file, std::string_view text, SourceLanguage language,
                                    const KnownConstants& known, const EffectLimits& limits,
                                    const Checkpoint& checkpoint = keep_going,
                                    SkippedFiles* skipped = nullptr);

}  // namespace shadefit::lint
