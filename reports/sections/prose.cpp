#include "reports/sections/prose.hpp"

#include <fmt/format.h>

#include <cctype>
#include <sstream>

#include "reports/sections/text_files.hpp"

namespace shadefit {
namespace {

/// Longer lines are hard to read in a difference between two reports.
constexpr std::size_t longest_line = 400;

/// The parts of a text that end with `end` and a space. A double `end` does not end a part.
std::vector<std::string> parts_of(std::string_view text, char end) {
  std::vector<std::string> found;
  const std::string stop{end, ' '};
  for (std::size_t from = 0;;) {
    const std::size_t at = text.find(stop, from);
    if (at == std::string_view::npos) break;
    from = at + 1;
    if (at > 0 && text[at - 1] == end) continue;
    found.emplace_back(text.substr(0, from));
    text.remove_prefix(from + 1);
    from = 0;
  }
  found.emplace_back(text);
  return found;
}

/// The text without its leading `letter`s, and their number.
std::size_t leading(std::string_view text, char letter) {
  return std::min(text.find_first_not_of(letter), text.size());
}

std::string short_lines_of(const std::string& line) {
  if (line.starts_with('|') || line.starts_with('#') || line.starts_with('!')) return line + "\n";
  const std::size_t spaces = leading(line, ' ');
  const bool is_item = std::string_view(line).substr(spaces).starts_with("- ");
  const std::string indentation(spaces + (is_item ? 2 : 0), ' ');
  std::string out;
  for (const std::string& sentence : sentences_of(line)) {
    const char end = sentence.find("; ") != std::string::npos ? ';' : ':';
    for (const std::string& part :
         sentence.size() > longest_line ? parts_of(sentence, end) : std::vector{sentence})
      out += (out.empty() ? "" : indentation) + part + "\n";
  }
  return out;
}

}  // namespace

std::string section_text(std::string_view name) {
  return std::string(embedded_text(text_files, name)) + "\n";
}

std::vector<std::string> sentences_of(std::string_view text) {
  return parts_of(text, '.');
}

std::string with_short_lines(std::string_view markdown) {
  std::string out, line;
  for (std::istringstream lines{std::string(markdown)}; std::getline(lines, line);)
    out += short_lines_of(line);
  return out;
}

std::string anchor(std::string_view heading) {
  std::string out;
  for (const char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || c == '-' || c == '_') out += static_cast<char>(std::tolower(letter));
    if (c == ' ') out += '-';
  }
  return out;
}

std::string contents(std::string_view markdown) {
  std::string out, line;
  for (std::istringstream lines{std::string(markdown)}; std::getline(lines, line);) {
    const std::size_t level = leading(line, '#');
    if (level != 2 && level != 3) continue;
    const std::string heading = line.substr(level + 1);
    out += fmt::format("{}- [{}](#{})\n", level == 3 ? "  " : "", heading, anchor(heading));
  }
  return out + "\n";
}

}  // namespace shadefit
