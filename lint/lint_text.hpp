#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "lint/grade.hpp"
#include "lint/scan/digit_index.hpp"
#include "lint/scan/known_set.hpp"
#include "lint/scan/literals.hpp"

/// Finds and judges the published constants of one source text.
namespace shadefit::lint {

/// Everything that does not depend on the text.
struct KnownConstants {
  std::vector<KnownSet> sets;
  DigitIndex index;

  explicit KnownConstants(std::vector<KnownSet> known) : sets(std::move(known)), index(sets) {}
};

/// The bytes of a number in a text.
struct NumberPlace {
  std::size_t offset = 0, length = 0;
};

/// A number of a site.
struct JudgedNumber : NumberPlace {
  std::size_t constant = 0;  ///< of the set
  Grade grade = Grade::right;
  std::vector<NumberPlace> copies = {};  ///< the other components of a vector of this number
  /// False: another number near it may be the constant, another source may be meant, or other units.
  bool is_certain = true;
};

/// Constants of a set in a text.
struct JudgedSite {
  std::size_t set = 0;
  std::vector<JudgedNumber> numbers;  ///< by their places
  GradedSite graded;
  std::string slip = {};       ///< of the expression: see ExpressionMatch
  std::string replaced = {};   ///< why the source replaced a value that is found here
  bool is_in_comment = false;  ///< whether all numbers are
  bool is_in_table = false;    ///< the set is a small part of a table of numbers
};

/// All sites, by their places. The checkpoint is called before each, because a text of a few MiB can have so
/// many that this takes seconds.
std::vector<JudgedSite> judge_text(std::string_view text, CommentStyle style, const KnownConstants& known,
                                   const EffectLimits& limits, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::lint
