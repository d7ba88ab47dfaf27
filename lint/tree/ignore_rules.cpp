#include "lint/tree/ignore_rules.hpp"

#include <algorithm>
#include <cstddef>

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

}  // namespace shadefit::lint
