#include "lint/tree/folder_rules.hpp"

#include <string>
#include <system_error>
#include <utility>

#include "fit/support/bounded_file.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;

/// About 30 000 lines: nobody writes more.
constexpr std::uintmax_t most_rule_bytes = 1 << 20;

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(fs::symlink_status(path, none));
}

/// Links are not followed, as in git.
void add_rules(const fs::path& file, const fs::path& folder, RuleLists& lists) {
  std::error_code none;
  if (!fs::is_regular_file(fs::symlink_status(file, none))) return;
  try {
    auto rules = parse_ignore_rules(read_bounded(file, most_rule_bytes));
    if (!rules.empty()) lists.push_back(rules_of(folder, std::move(rules)));
  } catch (const UserError&) {
    // Without its rules more files are read, as in git.
  }
}

}  // namespace

std::shared_ptr<const FolderRules> rules_of(const fs::path& folder, std::vector<IgnoreRule> rules) {
  return std::make_shared<const FolderRules>(
      FolderRules{folder == "/" ? "" : folder.string(), std::move(rules)});
}

std::optional<fs::path> repository_of(const fs::path& folder) {
  for (fs::path at = folder;; at = at.parent_path()) {
    if (is_there(at / ".git")) return at;
    if (at == at.parent_path()) return std::nullopt;
  }
}

IgnoreVerdict verdict(const RuleLists& lists, std::string_view path, bool is_folder) {
  for (auto list = lists.rbegin(); list != lists.rend(); ++list) {
    const std::size_t length = (*list)->folder.size();
    if (path.size() <= length + 1 || !path.starts_with((*list)->folder) || path[length] != '/') continue;
    const IgnoreVerdict said = verdict((*list)->rules, path.substr(length + 1), is_folder);
    if (said != IgnoreVerdict::none) return said;
  }
  return IgnoreVerdict::none;
}

void enter(const fs::path& folder, RuleLists& lists) {
  if (is_there(folder / ".git")) {
    lists.clear();
    // In a work tree or a submodule .git is a file. The list that it refers to is not read.
    add_rules(folder / ".git/info/exclude", folder, lists);
  }
  add_rules(folder / ".gitignore", folder, lists);
}

RuleLists rules_above(const fs::path& folder) {
  const auto repository = repository_of(folder);
  RuleLists lists;
  if (!repository || *repository == folder) return lists;
  fs::path at = *repository;
  for (const fs::path& part : folder.lexically_relative(*repository)) {
    enter(at, lists);
    at /= part;
    if (verdict(lists, at.string(), true) == IgnoreVerdict::ignored) return {};
  }
  return lists;
}

}  // namespace shadefit::lint
