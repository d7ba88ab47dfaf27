#pragma once

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

/// All sites that nothing pins, by their places, which they do not have yet. The checkpoint is called before
/// each, because a text of a few MiB can have so many that this takes seconds.
std::vector<LintedSite> judge_text(std::string_view text, CommentStyle style, const KnownConstants& known,
                                   const EffectLimits& limits, const Checkpoint& checkpoint);

}  // namespace shadefit::lint
