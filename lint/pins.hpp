#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/grade.hpp"

/// Marks that say which published constant a number is, and how right such a number is.
namespace shadefit::lint {

/// A comment that begins with "shadefit: STUDY.CONSTANT" or "shadefit: STUDY.FORM.CONSTANT".
struct Pin {
  std::size_t offset = 0;  ///< of `name`
  std::string_view name;   ///< "acos-linear.a"
  /// The last number between an earlier mark and the comment in its line; empty: there is none.
  std::size_t number_offset = 0;
  std::string_view number;
};

/// The marks of a text, by their places. A comment begins with //, #, /* or <!-- in every language.
std::vector<Pin> pins_of(std::string_view text);

/// The reason of a comment in a line that begins with "shadefit: ignore REASON".
std::optional<std::string> ignore_reason(std::string_view line);

/// A pinned number is right if it has the published digits, more digits that round to them, or those of the
/// nearest float; signs do not count. Any other number is graded like one that was found, at worst by its
/// effect with the other constants as published. If several sources published the constant, the number of any
/// of them will do. A pin that pins nothing is a fault, of the grade `wrong`.
LintedSite judge_pin(const Pin& pin, const std::vector<KnownSet>& sets, const EffectLimits& limits);

}  // namespace shadefit::lint
