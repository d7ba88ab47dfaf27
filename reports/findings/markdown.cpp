#include <fmt/format.h>

#include <algorithm>

#include "reports/findings/finding_texts.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

/// Findings as a summary for people, such as the job summary of GitHub ($GITHUB_STEP_SUMMARY).
namespace shadefit::findings {
namespace {

/// The most rows of a table: a job summary may have 1 MiB, and a row has at most 4 KiB: two texts of
/// `one_line`, of 600 characters of up to 4 bytes, half as much again for escapes, and less for the rest.
constexpr std::size_t most_rows = 200;

/// A cell of bounded size.
OthersText short_cell(std::string_view text) {
  return one_line(text);
}

/// A table of findings, with what is left out.
std::string finding_table(const std::vector<const Finding*>& findings, bool has_reasons) {
  if (findings.empty()) return "";
  Table table{{"level", "place", "rule", "finding"}};
  if (has_reasons) table.columns.emplace_back("reason");
  for (std::size_t i = 0; i < std::min(findings.size(), most_rows); ++i) {
    const Finding& finding = *findings[i];
    auto& row = table.rows.emplace_back();
    row = {std::string(name(finding.level)), short_cell(finding.place ? place_text(*finding.place) : ""),
           short_cell(finding.rule), short_cell(finding.message)};
    if (has_reasons) row.emplace_back(short_cell(*finding.suppressed));
  }
  std::string text = "\n" + write_markdown(table, Precision::report);
  if (findings.size() > most_rows)
    text += fmt::format("\n{} more are not shown.\n", findings.size() - most_rows);
  return text;
}

}  // namespace

std::string findings_markdown(const FindingReport& report) {
  std::vector<const Finding*> found, suppressed;
  for (const Finding& finding : report.findings) {
    if (finding.suppressed) {
      suppressed.push_back(&finding);
    } else if (!finding.is_known) {
      found.push_back(&finding);
    }
  }
  const std::string reasons = finding_table(suppressed, true);
  return fmt::format("### shadefit {}\n{}{}{}", summary_of(report), finding_table(found, false),
                     reasons.empty() ? "" : "\nSuppressed:\n", reasons);
}

}  // namespace shadefit::findings
