#include <fmt/format.h>

#include <algorithm>

#include "reports/findings/finding_texts.hpp"
#include "reports/io/utf8.hpp"

/// Findings as workflow commands of GitHub Actions, which shows them at their lines.
/// Source: GitHub, "Workflow commands for GitHub Actions"; for the escapes actions/toolkit,
/// packages/core/src/command.ts.
namespace shadefit::findings {
namespace {

/// A text in a command. A property also ends at ',' and at ':'. Other control characters are shown, as they
/// would colour or hide lines of the log.
std::string command_data(std::string_view text, bool is_property) {
  std::string data;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(first_code_point(text).length, 1);
    const char c = text.front();
    const bool is_escaped = c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ','));
    data += is_escaped ? fmt::format("%{:02X}", static_cast<unsigned char>(c))
                       : printable(text.substr(0, length));
    text.remove_prefix(length);
  }
  return data;
}

std::string command_of(const FindingReport& report, const Finding& finding) {
  std::string properties;
  const auto add = [&](const char* key, const std::string& value) {
    properties += fmt::format("{}{}={}", properties.empty() ? " " : ",", key, command_data(value, true));
  };
  const auto add_number = [&](const char* key, long value) {
    if (value > 0) add(key, fmt::format("{}", value));
  };
  if (finding.place) {
    add("file", finding.place->path);
    add_number("line", finding.place->line);
    add_number("endLine", finding.place->end_line);
    add_number("col", finding.place->column);
    add_number("endColumn", finding.place->end_column);
  }
  const FindingRule* rule = rule_of(report, finding);
  add("title", rule == nullptr ? finding.rule : rule->title);
  const std::string_view level = finding.level == FindingLevel::note ? "notice" : name(finding.level);
  return fmt::format("::{}{}::{} [{}]\n", level, properties, command_data(finding.message, false),
                     command_data(finding.rule, false));
}

}  // namespace

std::string findings_github(const FindingReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) {
    if (!finding.suppressed && !finding.is_known) text += command_of(report, finding);
  }
  return text + summary_of(report) + "\n";
}

}  // namespace shadefit::findings
