#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lint/lint_tree.hpp"

/// Replaces wrong digits by the published ones.
namespace shadefit::lint {

/// What is rewritten. Pinned numbers always are.
enum class FixScope {
  pins,   ///< nothing else
  typo,   ///< also the numbers of sites graded typo or wrong
  wrong,  ///< also those graded wrong
};
inline constexpr std::array fix_scopes{FixScope::pins, FixScope::typo, FixScope::wrong};

std::string_view name(FixScope scope);

/// A number and its replacement, in its own notation.
struct Fix {
  std::size_t offset = 0;  ///< in the file, in bytes
  std::string before, after;
};

/// The fixes of the sites of one text, by rising place. These numbers stay: those that a mark ignores; those
/// in a comment, unless pinned; those of a site whose expression has a slip; those that are not certain;
/// those before a factor 10^n; those that two sites would rewrite differently; and those with fewer digits
/// than published beside a worse one. `text` is the one with the sites.
std::vector<Fix> fixes_of(const std::vector<LintedSite>& sites, std::string_view text, FixScope scope);

/// The text with the fixes; no other byte changes.
std::string fixed_text(std::string_view text, const std::vector<Fix>& fixes);

}  // namespace shadefit::lint
