#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/tree/ignore_rules.hpp"

/// Which rules of which folders are in force where.
namespace shadefit::lint {

/// The folder of the repository that a folder belongs to: the nearest with a .git, from itself up. Needs an
/// absolute path.
std::optional<std::filesystem::path> repository_of(const std::filesystem::path& folder);

/// Rules, and the folder that their paths are relative to.
struct FolderRules {
  std::string folder;  ///< absolute, without a '/' at its end
  std::vector<IgnoreRule> rules;
};

/// The last has the last word. Folders share those of the folders above.
using RuleLists = std::vector<std::shared_ptr<const FolderRules>>;

/// Rules that count from a folder, given by its absolute path.
std::shared_ptr<const FolderRules> rules_of(const std::filesystem::path& folder,
                                            std::vector<IgnoreRule> rules);

/// What the last list of rules that says something says about an absolute path. A path outside of the folder
/// of a list is not its matter.
IgnoreVerdict verdict(const RuleLists& lists, std::string_view path, bool is_folder);

/// Adds the rules that git has in a folder: of .git/info/exclude and of .gitignore. Where a repository
/// begins, the rules from outside end.
void enter(const std::filesystem::path& folder, RuleLists& lists);

/// The rules of all folders above one in its repository; none if they ignore it. Needs an absolute path
/// without links.
RuleLists rules_above(const std::filesystem::path& folder);

}  // namespace shadefit::lint
