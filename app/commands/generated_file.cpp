#include "app/commands/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/commands/command_line.hpp"
#include "app/options/option_values.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

constexpr std::string_view line_prefix = "// shadefit ";

/// The commands that print code.
constexpr std::array<std::string_view, 2> generators{"emit", "scene"};

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

/// The command of a line, if it is one that prints code and neither writes nor checks a file.
std::optional<std::vector<std::string>> command_of_line(const std::string& line) {
  if (!line.starts_with(line_prefix)) return {};
  std::vector<std::string> words = words_of(std::string_view(line).substr(line_prefix.size()));
  const bool is_generator =
      !words.empty() && std::ranges::find(generators, words.front()) != generators.end();
  const auto is_forbidden = [](const std::string& word) {
    return word.starts_with("--check") || word.starts_with("--out");
  };
  if (!is_generator || std::ranges::any_of(words, is_forbidden)) return {};
  return words;
}

std::vector<std::string> command_in(const std::string& code, const std::string& file) {
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (auto command = command_of_line(line)) return *command;
  }
  throw UserError(fmt::format("--check '{}' names no command '{}emit ..' or '{}scene ..'", file, line_prefix,
                              line_prefix));
}

/// The number, from 1, of the first line in which two texts differ.
int first_difference(const std::string& a, const std::string& b) {
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return 1 + static_cast<int>(std::count(a.begin(), end, '\n'));
}

/// The check as findings: one, if a line differs.
findings::FindingReport code_findings(const std::string& file, std::optional<int> line) {
  return one_check(
      "emit",
      {"outdated-code", "The code is not what shadefit generates now",
       "Generate the file again by the command in its comment, or take back the change of the file."},
      "files", line ? fmt::format("line {} is not what shadefit generates now", *line) : "",
      {.path = std::filesystem::path(file).lexically_normal().generic_string(), .line = line.value_or(0)});
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

/// Code with the line that names its command replaced.
std::string with_command_of(std::string code, const std::string& other) {
  const auto place = [](const std::string& text) {
    const std::size_t begin = text.find("\n" + std::string(line_prefix)) + 1;
    return std::pair(begin, text.find('\n', begin) - begin);
  };
  const auto [begin, length] = place(code);
  const auto [other_begin, other_length] = place(other);
  return code.replace(begin, length, other, other_begin, other_length);
}

/// The command of a file in `folder`, to be run from the current folder. A scene's files, the words up to the
/// first option, are relative to `folder`; printed messages then show their full paths.
std::vector<std::string> from_here(std::vector<std::string> words, const std::filesystem::path& folder) {
  if (words.front() != "scene") return words;
  for (std::size_t i = 1; i < words.size() && !words[i].starts_with("--"); ++i)
    words[i] = (folder / words[i]).string();  // an absolute path replaces all of it
  return words;
}

Outcome check_generated_files(const std::vector<std::string>& files, FindingFormat format,
                              const Checkpoint& checkpoint) {
  Outcome all;
  std::optional<findings::FindingReport> report;
  for (const std::string& file : files) {
    // A checkout may have changed the line ends.
    const std::string code = boost::replace_all_copy(read_file(file), "\r\n", "\n");
    const std::vector<std::string> command = command_in(code, file);
    Outcome now = run_command_line(from_here(command, std::filesystem::path(file).parent_path()), checkpoint);
    all.exit_code = std::max(all.exit_code, now.exit_code);
    all.err += now.err;
    if (!now.err.empty()) continue;
    if (command.front() == "scene") now.out = with_command_of(now.out, code);
    const auto line = now.out == code ? std::nullopt : std::optional(first_difference(code, now.out));
    if (line) all.exit_code = std::max(all.exit_code, 1);
    if (format != FindingFormat::text) {
      const findings::FindingReport one = code_findings(file, line);
      if (!report) report = findings::FindingReport{one.command, one.rules, {}, 0, one.checked_words};
      report->findings.insert(report->findings.end(), one.findings.begin(), one.findings.end());
      ++report->checked;
    } else if (line) {
      all.err += fmt::format("shadefit: {} is out of date: line {} is not what shadefit generates now\n",
                             printable(file), *line);
    } else {
      all.out += fmt::format("{} is what would be generated now\n", printable(file));
    }
  }
  if (report) all.out = findings::write_findings(*report, format);
  return all;
}

}  // namespace shadefit
