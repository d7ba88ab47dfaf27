#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "reports/findings/finding_texts.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit::findings {
namespace {

/// "1 file", "2 files".
std::string counted(std::size_t count, std::string_view plural) {
  if (count == 1 && plural.ends_with('s')) plural.remove_suffix(1);
  return fmt::format("{} {}", count, plural);
}

/// A line for each finding, as compilers write them: an editor can jump to its place.
std::string findings_text(const FindingReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) {
    if (finding.suppressed || finding.is_known) continue;
    const std::string place = finding.place ? place_text(*finding.place) + ": " : "";
    text += fmt::format("{}{}: {} [{}]\n", printable(place), name(finding.level), one_line(finding.message),
                        finding.rule);
  }
  return text + summary_of(report) + "\n";
}

}  // namespace

bool passes(const FindingReport& report) {
  return std::ranges::none_of(report.findings, is_failure);
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

std::string place_text(const FindingPlace& place) {
  std::string text = place.path;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  return text;
}

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

const FindingRule* rule_of(const FindingReport& report, const Finding& finding) {
  const auto found = std::ranges::find(report.rules, finding.rule, &FindingRule::id);
  return found == report.rules.end() ? nullptr : &*found;
}

std::string write_findings(const FindingReport& report, FindingFormat format) {
  // In the order of `finding_formats`.
  constexpr std::array writers{findings_text, findings_json, findings_sarif, findings_github,
                               findings_markdown};
  static_assert(writers.size() == finding_formats.size());
  return writers.at(static_cast<std::size_t>(format))(report);
}

}  // namespace shadefit::findings
