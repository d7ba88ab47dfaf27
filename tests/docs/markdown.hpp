#pragma once

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

/// Reads the commands, links and headings of a page of the documentation.
namespace shadefit::testing {

/// A command that a page shows, and what the page says about it.
struct Example {
  std::size_t line;     ///< of the command in its page, from 1
  std::string command;  ///< for a shell
  int exit_code;        ///< N of a comment "# exit N" behind the command, else 0
  std::string
      not_run;  ///< the reason in "<!-- not run: REASON -->" above the block; empty: the command is run
  std::optional<std::vector<std::string>>
      shown;  ///< the lines below "$ command"; none where the line has no "$"
};

/// A link, or the path of a C++ file in backticks.
struct Link {
  std::size_t line;
  std::string target;
  bool is_source;  ///< a path in backticks, which starts at the root of the repository
};

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::string without_end(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// A block of code: fenced by ```, or indented by four spaces below an empty line.
struct CodeBlock {
  std::size_t first_line;
  std::vector<std::string> lines;
  std::string not_run;
};

inline std::vector<CodeBlock> read_code_blocks(const std::vector<std::string>& page) {
  constexpr std::string_view fence = "```", indent = "    ", mark = "<!-- not run: ", end = " -->";
  std::vector<CodeBlock> blocks;
  std::string reason;
  for (std::size_t i = 0; i < page.size(); ++i) {
    const std::string& line = page[i];
    if (line.starts_with(fence)) {
      blocks.push_back({i + 2, {}, reason});
      while (++i < page.size() && !page[i].starts_with(fence)) blocks.back().lines.push_back(page[i]);
      reason.clear();
    } else if (line.starts_with(indent) && (i == 0 || page[i - 1].empty())) {
      blocks.push_back({i + 1, {}, reason});
      for (; i < page.size() && (page[i].empty() || page[i].starts_with(indent)); ++i)
        blocks.back().lines.push_back(page[i].empty() ? "" : page[i].substr(indent.size()));
      while (blocks.back().lines.back().empty()) blocks.back().lines.pop_back();
      reason.clear();
      --i;
    } else if (line.starts_with(mark) && line.ends_with(end)) {
      reason = line.substr(mark.size(), line.size() - mark.size() - end.size());
    } else if (!line.empty()) {
      reason.clear();
    }
  }
  return blocks;
}

/// The commands of a page: lines of code that begin with ./run or shadefit, with or without "$ ".
inline std::vector<Example> read_examples(const std::vector<std::string>& page) {
  constexpr std::string_view prompt = "$ ", exit = "# exit ";
  std::vector<Example> examples;
  for (const CodeBlock& block : read_code_blocks(page)) {
    bool is_output = false;
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
      const std::string& line = block.lines[i];
      const bool has_prompt = line.starts_with(prompt);
      const std::string command = has_prompt ? line.substr(prompt.size()) : line;
      const bool is_command =
          command == "./run" || command.starts_with("./run ") || command.starts_with("shadefit ");
      if (is_command && (has_prompt || !is_output)) {
        const auto code = command.find(exit);
        examples.push_back({block.first_line + i, command,
                            code == std::string::npos ? 0 : std::stoi(command.substr(code + exit.size())),
                            block.not_run, std::nullopt});
        if (has_prompt) examples.back().shown.emplace();
        is_output = has_prompt;
      } else if (has_prompt) {
        is_output = false;
      } else if (is_output) {
        examples.back().shown->push_back(line);
      }
    }
  }
  for (Example& example : examples)
    while (example.shown && !example.shown->empty() && example.shown->back().empty())
      example.shown->pop_back();
  return examples;
}

/// The commands of a page in backticks in its text: "./run" with arguments. Their output is not shown.
inline std::vector<Example> read_inline_examples(std::vector<std::string> page) {
  for (const CodeBlock& block : read_code_blocks(page))
    std::fill_n(page.begin() + static_cast<std::ptrdiff_t>(block.first_line) - 1, block.lines.size(), "");
  std::vector<Example> examples;
  for (std::size_t i = 0; i < page.size(); ++i) {
    std::istringstream in(page[i]);
    bool is_code = false;
    for (std::string part; std::getline(in, part, '`'); is_code = !is_code)
      if (is_code && part.starts_with("./run ")) examples.push_back({i + 1, part, 0, "", std::nullopt});
  }
  return examples;
}

/// Whether the shown lines match the printed ones. "..." at the end of a line stands for the rest of it,
/// alone on a line for any number of lines. Spaces at the end of a line do not count.
inline bool stands_for(const std::vector<std::string>& shown, const std::vector<std::string>& printed,
                       std::size_t i = 0, std::size_t j = 0) {
  constexpr std::string_view elided = "...";
  for (; i < shown.size(); ++i, ++j) {
    if (shown[i] == elided) {
      for (; j <= printed.size(); ++j)
        if (stands_for(shown, printed, i + 1, j)) return true;
      return false;
    }
    if (j == printed.size()) return false;
    const bool is_cut = shown[i].ends_with(elided);
    const std::string kept = shown[i].substr(0, shown[i].size() - elided.size() * is_cut);
    if (is_cut ? !printed[j].starts_with(kept) : without_end(kept) != without_end(printed[j])) return false;
  }
  return j == printed.size();
}

/// The links of a page, and the C++ files that it names in backticks; code blocks have none.
inline std::vector<Link> read_links(std::vector<std::string> page) {
  for (const CodeBlock& block : read_code_blocks(page))
    std::fill_n(page.begin() + static_cast<std::ptrdiff_t>(block.first_line) - 1, block.lines.size(), "");
  std::vector<Link> links;
  for (std::size_t i = 0; i < page.size(); ++i) {
    std::string text;
    std::istringstream in(page[i]);
    bool is_code = false;
    for (std::string part; std::getline(in, part, '`'); is_code = !is_code) {
      const bool is_path =
          part.find('/') != std::string::npos && part.find_first_of(" *<") == std::string::npos;
      if (!is_code)
        text += part;
      else if (is_path && (part.ends_with(".hpp") || part.ends_with(".cpp")))
        links.push_back({i + 1, part, true});
    }
    for (std::size_t at = 0; (at = text.find("](", at)) != std::string::npos;) {
      at += 2;
      const std::string target = text.substr(at, text.find(')', at) - at);
      if (!target.starts_with("https://") && !target.starts_with("http://"))
        links.push_back({i + 1, target, false});
    }
  }
  return links;
}

/// The anchors that GitHub gives to the headings of a page.
inline std::set<std::string> read_anchors(std::vector<std::string> page) {
  for (const CodeBlock& block : read_code_blocks(page))
    std::fill_n(page.begin() + static_cast<std::ptrdiff_t>(block.first_line) - 1, block.lines.size(), "");
  std::set<std::string> anchors;
  for (const std::string& line : page) {
    const auto marks = line.find_first_not_of('#');
    if (marks == 0 || marks == std::string::npos || line[marks] != ' ') continue;
    std::string anchor;
    for (const char character : line.substr(marks + 1)) {
      const auto code = static_cast<unsigned char>(character);
      if (character == ' ')
        anchor += '-';
      else if (std::isalnum(code) || character == '-' || character == '_')
        anchor += static_cast<char>(std::tolower(code));
    }
    anchors.insert(anchor);
  }
  return anchors;
}

}  // namespace shadefit::testing
