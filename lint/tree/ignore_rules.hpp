#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lint/tree/glob.hpp"

/// The rules of a .gitignore, and which rules of which folders apply where.
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

/// The folder of the repository that a folder belongs to: the nearest folder with a .git, from itself up. The
/// path must be absolute.
std::optional<std::filesystem::path> repository_of(const std::filesystem::path& folder);

/// Rules, and the folder that their paths are relative to.
struct FolderRules {
  std::string folder;  ///< absolute, without a '/' at its end
  std::vector<IgnoreRule> rules;
};

/// The last list wins. Folders share the lists of the folders above.
using RuleLists = std::vector<std::shared_ptr<const FolderRules>>;

/// Rules relative to a folder, which is given by its absolute path.
std::shared_ptr<const FolderRules> rules_of(const std::filesystem::path& folder,
                                            std::vector<IgnoreRule> rules);

/// The verdict on an absolute path by the last list that has one. A list does not apply to paths outside of
/// its folder.
IgnoreVerdict verdict(const RuleLists& lists, std::string_view path, bool is_folder);

/// Adds the rules that git has in a folder: those of .git/info/exclude and of .gitignore. At the start of a
/// repository the rules from outside are dropped.
void enter(const std::filesystem::path& folder, RuleLists& lists);

/// The rules of all folders above one in its repository; none if they ignore it. The path must be absolute
/// and without links.
RuleLists rules_above(const std::filesystem::path& folder);

}  // namespace shadefit::lint
