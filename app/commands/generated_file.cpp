#include "app/commands/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <sstream>
#include <string_view>

#include "app/commands/command_line.hpp"
#include "app/options/option_values.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

constexpr std::string_view line_prefix = "// shadefit ";

/// Splits a line into words like a shell: quoted text is one word, and \\ before a quote outside quotes is a
/// quote.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  bool is_quoted = false, is_open = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ' ' && !is_quoted) {
      is_open = false;
      continue;
    }
    if (!is_open) words.emplace_back();
    is_open = true;
    const bool is_escape = !is_quoted && line.substr(i).starts_with("\\'");
    if (is_escape) ++i;
    if (line[i] == '\'' && !is_escape) {
      is_quoted = !is_quoted;
    } else {
      words.back() += line[i];
    }
  }
  return words;
}

/// The first command that prints code and neither writes nor checks a file.
std::vector<std::string> command_in(const std::string& code, const std::string& file) {
  const auto is_forbidden = [](const std::string& word) {
    return word.starts_with("--check") || word.starts_with("--out");
  };
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(line_prefix)) continue;
    std::vector<std::string> words = words_of(std::string_view(line).substr(line_prefix.size()));
    const bool prints_code = !words.empty() && (words.front() == "emit" || words.front() == "scene");
    if (prints_code && std::ranges::none_of(words, is_forbidden)) return words;
  }
  throw UserError(fmt::format("--check '{}' names no command '{}emit ..' or '{}scene ..'", file, line_prefix,
                              line_prefix));
}

/// The number, from 1, of the first line in which two texts differ.
int first_difference(const std::string& a, const std::string& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return 1 + static_cast<int>(std::count(a.begin(), end, '\n'));
}

}  // namespace

std::string command_text(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (printable(word) != word)
      throw UserError(
          fmt::format("'{}' cannot stand in a comment of code: it has control characters", printable(word)));
  }
  return shell_text(words);
}

Outcome check_generated_files(const std::vector<std::string>& files, const Checkpoint& checkpoint) {
  Outcome all;
  for (const std::string& file : files) {
    // A checkout may have changed the line ends.
    const std::string code = boost::replace_all_copy(read_file(file), "\r\n", "\n");
    const Outcome now = run_command_line(command_in(code, file), checkpoint);
    all.exit_code = std::max(all.exit_code, now.exit_code);
    all.err += now.err;
    if (!now.err.empty()) continue;
    if (now.out == code) {
      all.out += fmt::format("{} is what would be generated now\n", printable(file));
      continue;
    }
    all.exit_code = std::max(all.exit_code, 1);
    all.err += fmt::format("shadefit: {} is out of date: line {} is not what shadefit generates now\n",
                           printable(file), first_difference(code, now.out));
  }
  return all;
}

}  // namespace shadefit
