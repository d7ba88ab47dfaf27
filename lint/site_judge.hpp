#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fit/support/memory.hpp"
#include "lint/expression/compare.hpp"
#include "lint/lint_text.hpp"
#include "lint/scan/sites.hpp"

/// Judges one site of a text.
namespace shadefit::lint {

/// What is computed once for a text. Its sets outlive this object.
struct TextMemory {
  Memory<std::pair<CommentStyle, std::string>, std::optional<Symbolic>> expressions;
  /// By the set, the place of the form in the set, the expression without its names, the constants, the
  /// numbers and the missing constants.
  Memory<std::tuple<const KnownSet*, std::size_t, std::string, std::vector<double>, std::vector<double>,
                    std::vector<std::size_t>>,
         std::optional<ExpressionMatch>>
      matches;
  KnownEffects effects;
};

/// How much of its set's form the program around a site contains.
Reading reading_of(const ScannedText& program, const KnownSet& set, const Site& site, TextMemory& memory);

/// The site, or empty if neither its numbers nor the expression around them show that it is one. `program` is
/// the text without its comments, unless the site is in one.
std::optional<LintedSite> judge_site(const ScannedText& text, const ScannedText& program, const KnownSet& set,
                                     const Site& site, const EffectLimits& limits, TextMemory& memory);

}  // namespace shadefit::lint
