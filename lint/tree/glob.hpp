#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Globs as git has them in .gitignore.
namespace shadefit::lint {

/// One step of a glob.
struct GlobStep {
  enum class Kind : std::uint8_t {
    byte,      ///< one byte of the set
    star,      ///< any bytes but '/'
    stars,     ///< any bytes
    optional,  ///< before `stars` and a '/': all three, or none
  };
  Kind kind;
  std::bitset<256> bytes = {};
};

/// A parsed glob: `start`, then the steps, then `end`. Most names already differ in the start or the end.
struct Glob {
  std::string start, end;
  std::vector<GlobStep> steps;
  bool is_valid = true;  ///< false: a set without its ']', an unknown class, a last '\'; matches nothing
};

/// Parses a glob. `*` and `?` do not match '/'; `**` between slashes matches folders, and at the end
/// everything. `[..]` is a set with ranges, '!' or '^', and classes such as [:alpha:]. A '\' makes the next
/// byte literal. Bytes are compared, not letters. Source: gitignore(5) and wildmatch.c of git 2.39. As there,
/// `**` directly after a start without wildcards counts as after a slash: `a**` matches a/b.
Glob parse_glob(std::string_view pattern);

/// Whether a glob matches all of a text. Takes time in proportion to the length of the glob times that of the
/// text.
bool matches(const Glob& glob, std::string_view text);

}  // namespace shadefit::lint
