#include "lint/tree/ignore_rules.hpp"

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <utility>

#include "fit/support/bounded_file.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::lint {
namespace {

constexpr std::size_t longest_rule = 4096;

/// The line without trailing blanks, unless a '\' protects them.
std::string_view without_blanks(std::string_view line) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
      end = std::min(i + 1, line.size());
    } else if (line[i] != ' ') {
      end = i + 1;
    }
  }
  return line.substr(0, end);
}

IgnoreRule parse_rule(std::string_view line) {
  IgnoreRule rule;
  rule.is_negative = line.starts_with('!');
  if (rule.is_negative) line.remove_prefix(1);
  rule.is_for_folders = line.ends_with('/');
  if (rule.is_for_folders) line.remove_suffix(1);
  rule.is_for_names = line.find('/') == std::string_view::npos;
  if (line.starts_with('/')) line.remove_prefix(1);
  rule.glob = parse_glob(line);
  return rule;
}

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

std::vector<IgnoreRule> parse_ignore_rules(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  std::vector<IgnoreRule> rules;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    // As in git, a byte 0 ends a line.
    line = without_blanks(line.substr(0, line.find('\0')));
    if (!line.empty() && line.front() != '#' && line.size() <= longest_rule)
      rules.push_back(parse_rule(line));
  }
  return rules;
}

IgnoreVerdict verdict(std::span<const IgnoreRule> rules, std::string_view path, bool is_folder) {
  const std::string_view last_name = path.substr(path.rfind('/') + 1);  // npos + 1 is 0
  for (auto rule = rules.rbegin(); rule != rules.rend(); ++rule) {
    if (rule->is_for_folders && !is_folder) continue;
    if (!matches(rule->glob, rule->is_for_names ? last_name : path)) continue;
    return rule->is_negative ? IgnoreVerdict::kept : IgnoreVerdict::ignored;
  }
  return IgnoreVerdict::none;
}

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
