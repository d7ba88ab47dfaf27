#include "reports/findings/unified_diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

/// As diff(1) and git have it.
constexpr std::size_t lines_of_context = 3;

/// With their ends.
std::vector<std::string_view> lines_with_ends(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end == std::string_view::npos ? end : end + 1));
    text.remove_prefix(lines.back().size());
  }
  return lines;
}

void add_line(std::string& diff, char sign, std::string_view line) {
  diff += sign;
  diff += line;
  if (!line.ends_with('\n')) diff += "\n\\ No newline at end of file\n";
}

}  // namespace

std::string unified_diff(const std::string& name, std::string_view before, std::string_view after) {
  const auto old_lines = lines_with_ends(before), new_lines = lines_with_ends(after);
  const std::size_t count = std::min(old_lines.size(), new_lines.size());
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < count; ++i)
    if (old_lines[i] != new_lines[i]) changed.push_back(i);
  if (changed.empty()) return "";
  const bool is_absolute = name.starts_with('/');
  std::string diff = fmt::format("--- {1}{0}\n+++ {2}{0}\n", printable(name), is_absolute ? "" : "a/",
                                 is_absolute ? "" : "b/");
  for (std::size_t i = 0; i < changed.size();) {
    std::size_t last = i;
    while (last + 1 < changed.size() && changed[last + 1] - changed[last] <= 2 * lines_of_context) ++last;
    const std::size_t begin = changed[i] - std::min(changed[i], lines_of_context);
    const std::size_t end = std::min(count, changed[last] + 1 + lines_of_context);
    diff += fmt::format("@@ -{0},{1} +{0},{1} @@\n", begin + 1, end - begin);
    for (std::size_t line = begin; line < end;) {
      std::size_t run = line;
      while (run < end && old_lines[run] != new_lines[run]) ++run;
      for (std::size_t j = line; j < run; ++j) add_line(diff, '-', old_lines[j]);
      for (std::size_t j = line; j < run; ++j) add_line(diff, '+', new_lines[j]);
      if (run < end) add_line(diff, ' ', old_lines[run]);
      line = run + 1;
    }
    i = last + 1;
  }
  return diff;
}

}  // namespace shadefit
