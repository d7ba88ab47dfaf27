#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lint/tree/glob.hpp"

/// The rules of a .gitignore.
namespace shadefit::lint {

/// One line of a .gitignore.
struct IgnoreRule {
  Glob glob;
  bool is_negative = false;     ///< '!': takes back what lines before it ignore
  bool is_for_folders = false;  ///< a '/' at the end
  bool is_for_names = false;    ///< without another '/': it is held against the last name of a path
};

/// What rules say about a path.
enum class IgnoreVerdict { none, ignored, kept };

/// The rules in the text of a .gitignore: blank lines and those that begin with '#' are left out, blanks at
/// the end of a line too unless a '\' stands before them. Every text is valid. A line longer than the longest
/// path (4096 bytes on Linux) is left out. Source: gitignore(5) and dir.c of git 2.39.
std::vector<IgnoreRule> parse_ignore_rules(std::string_view text);

/// What the last rule that matches says about a path relative to the folder of the rules, with '/' between
/// its names and none at its ends. Folders above it are not looked at: a path in an ignored folder is
/// ignored, whatever these rules say.
IgnoreVerdict verdict(std::span<const IgnoreRule> rules, std::string_view path, bool is_folder);

}  // namespace shadefit::lint
