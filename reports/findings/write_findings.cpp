#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "reports/findings/finding.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"

namespace shadefit::findings {
namespace {

/// "1 file", "2 files".
std::string counted(std::size_t count, std::string_view plural) {
  if (count == 1 && plural.ends_with('s')) plural.remove_suffix(1);
  return fmt::format("{} {}", count, plural);
}

/// Where a finding is, as "tables/fits.csv:12:5". A line or column that is not known is left out.
std::string place_text(const FindingPlace& place) {
  std::string text = place.path;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  return text;
}

/// "check failed: 3 errors, 1 warning in 3812 cells; 2 suppressed, 1 known". Without a line end.
std::string summary_of(const FindingReport& report) {
  const FindingCounts counts = count(report);
  const auto listed = [](const std::vector<std::pair<std::size_t, std::string_view>>& numbers) {
    std::vector<std::string> parts;
    for (const auto& [number, words] : numbers) {
      if (number > 0) parts.push_back(counted(number, words));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  };
  const std::string found =
      listed({{counts.errors, "errors"}, {counts.warnings, "warnings"}, {counts.notes, "notes"}});
  const std::string set_aside = listed({{counts.suppressed, "suppressed"}, {counts.known, "known"}});
  return fmt::format("{} {}: {} in {}{}", report.command, passes(report) ? "passed" : "failed",
                     found.empty() ? "nothing found" : found, counted(report.checked, report.checked_words),
                     set_aside.empty() ? "" : "; " + set_aside);
}

/// What is neither suppressed nor in the baseline.
std::vector<const Finding*> found(const FindingReport& report) {
  std::vector<const Finding*> findings;
  for (const Finding& finding : report.findings) {
    if (!finding.suppressed && !finding.is_known) findings.push_back(&finding);
  }
  return findings;
}

/// A line for each finding, as compilers write them: an editor can jump to its place.
std::string findings_text(const FindingReport& report) {
  std::string text;
  for (const Finding* finding : found(report)) {
    text += fmt::format("{}: {}: {} [{}]\n", printable(place_text(finding->place)), name(finding->level),
                        one_line(finding->message), finding->rule);
  }
  return text + summary_of(report) + "\n";
}

/// A text in a workflow command of GitHub Actions. Source: GitHub, "Workflow commands for GitHub Actions";
/// for the escapes actions/toolkit, packages/core/src/command.ts. A property also ends at ',' and at ':'.
/// Other control characters are shown, as they would colour or hide lines of the log.
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
  add("file", finding.place.path);
  add_number("line", finding.place.line);
  add_number("endLine", finding.place.end_line);
  add_number("col", finding.place.column);
  add_number("endColumn", finding.place.end_column);
  add("title", rule_of(report, finding).title);
  const std::string_view level = finding.level == FindingLevel::note ? "notice" : name(finding.level);
  return fmt::format("::{}{}::{} [{}]\n", level, properties, command_data(finding.message, false),
                     command_data(finding.rule, false));
}

/// Workflow commands, which GitHub shows at their lines: the most severe ones, as it takes ten errors and ten
/// warnings of a step.
std::string findings_github(const FindingReport& report) {
  constexpr std::size_t most = 10;
  std::vector<const Finding*> findings = found(report);
  std::ranges::stable_sort(findings, {}, &Finding::level);
  std::string text;
  for (std::size_t i = 0; i < std::min(findings.size(), most); ++i) text += command_of(report, *findings[i]);
  if (findings.size() > most) text += fmt::format("{} more have no annotation\n", findings.size() - most);
  return text + summary_of(report) + "\n";
}

/// A cell of bounded size.
OthersText short_cell(std::string_view text) {
  return one_line(text);
}

/// The most bytes of a table: the summary of a job has two, and may have 1 MiB.
constexpr std::size_t most_bytes = 500'000;

/// A table of findings, with how many are left out.
std::string finding_table(const std::vector<const Finding*>& findings, bool has_reasons) {
  if (findings.empty()) return "";
  Table table{{"level", "place", "rule", "finding"}};
  if (has_reasons) table.columns.emplace_back("reason");
  for (const Finding* finding : findings) {
    auto& row = table.rows.emplace_back();
    row = {std::string(name(finding->level)), short_cell(place_text(finding->place)),
           short_cell(finding->rule), short_cell(finding->message)};
    if (has_reasons) row.emplace_back(short_cell(*finding->suppressed));
  }
  std::string text = write_markdown(table, Precision::report);
  // All rows are as wide as the widest.
  if (text.size() > most_bytes) {
    table.rows.resize(table.rows.size() * most_bytes / text.size());
    text = write_markdown(table, Precision::report) +
           fmt::format("\n{} more are not shown.\n", findings.size() - table.rows.size());
  }
  return "\n" + text;
}

/// A summary for people, such as the job summary of GitHub ($GITHUB_STEP_SUMMARY).
std::string findings_markdown(const FindingReport& report) {
  std::vector<const Finding*> suppressed;
  for (const Finding& finding : report.findings) {
    if (finding.suppressed) suppressed.push_back(&finding);
  }
  const std::string reasons = finding_table(suppressed, true);
  return fmt::format("### shadefit {}\n{}{}{}", summary_of(report), finding_table(found(report), false),
                     reasons.empty() ? "" : "\nSuppressed:\n", reasons);
}

}  // namespace

bool passes(const FindingReport& report) {
  return count(report).errors == 0;
}

FindingCounts count(const FindingReport& report) {
  FindingCounts counts;
  for (const Finding& finding : report.findings) {
    if (finding.suppressed) {
      ++counts.suppressed;
    } else if (finding.is_known) {
      ++counts.known;
    } else {
      ++(finding.level == FindingLevel::error     ? counts.errors
         : finding.level == FindingLevel::warning ? counts.warnings
                                                  : counts.notes);
    }
  }
  return counts;
}

const FindingRule& rule_of(const FindingReport& report, const Finding& finding) {
  return *std::ranges::find(report.rules, finding.rule, &FindingRule::id);
}

std::string write_findings(const FindingReport& report, FindingFormat format) {
  // In the order of `finding_formats`.
  constexpr std::array writers{findings_text, findings_json, findings_sarif, findings_github,
                               findings_markdown};
  static_assert(writers.size() == finding_formats.size());
  return writers.at(static_cast<std::size_t>(format))(report);
}

}  // namespace shadefit::findings
