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
  bool is_negative = false;     ///< '!': keeps what earlier lines ignore
  bool is_for_folders = false;  ///< a '/' at the end
  bool is_for_names = false;    ///< without another '/': compared with the last name of a path
};

/// The verdict of rules on a path.
enum class IgnoreVerdict { none, ignored, kept };

/// Parses the text of a .gitignore. Blank lines and lines that begin with '#' are left out, and so are
/// trailing blanks unless a '\' protects them. Every text is valid. A line longer than the longest path (4096
/// bytes on Linux) is left out. Source: gitignore(5) and dir.c of git 2.39.
std::vector<IgnoreRule> parse_ignore_rules(std::string_view text);

/// The verdict of the last rule that matches a path. The path is relative to the folder of the rules, with
/// '/' between its names and none at its ends. Folders above it are not looked at: a path in an ignored
/// folder is ignored, whatever these rules say.
IgnoreVerdict verdict(std::span<const IgnoreRule> rules, std::string_view path, bool is_folder);

}  // namespace shadefit::lint
