#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/tree/ignore_rules.hpp"

/// Which ignore rules of which folders apply where.
namespace shadefit::lint {

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
