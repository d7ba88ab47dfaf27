#include <fmt/format.h>

#include <algorithm>

#include "reports/findings/finding_texts.hpp"
#include "reports/io/utf8.hpp"

/// Findings as XML of JUnit, which has no standard: the elements and attributes that Jenkins, GitLab, Azure
/// and others read. A finding is a test of the class of its rule. A rule without findings is a test that
/// passed, as dashboards take a file without tests for a failure. Times are 0: the same findings give the
/// same bytes.
namespace shadefit::findings {
namespace {

/// The replacement character U+FFFD, instead of what XML cannot hold.
constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Whether XML 1.0 can hold a character (W3C 2008, section 2.2, Char).
bool is_xml(char32_t point) {
  return point == 0x9 || point == 0xA || point == 0xD || (point >= 0x20 && point <= 0xD7FF) ||
         (point >= 0xE000 && point <= 0xFFFD) || point >= 0x10000;
}

/// A text for an attribute or an element. Ends of lines and tabs are written as references, because a parser
/// makes spaces of them in attributes.
std::string xml_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const auto [length, point] = first_code_point(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(length, 1));
    text.remove_prefix(bytes.size());
    const bool is_referred = point == '&' || point == '<' || point == '>' || point == '"' || point == '\t' ||
                             point == '\n' || point == '\r';
    if (length == 0 || !is_xml(point)) {
      xml += replacement;
    } else if (point > 0x7F && is_unshown(point)) {
      xml += fmt::format("&#{};", static_cast<unsigned>(point));
    } else if (is_referred) {
      xml += fmt::format("&#{};", static_cast<unsigned>(point));
    } else {
      xml += bytes;
    }
  }
  return xml;
}

/// Whether a finding is counted as skipped: it is set aside, and fails nothing.
bool is_skipped(const Finding& finding) {
  return finding.suppressed || finding.is_known;
}

/// What stands in the test of a finding.
std::string outcome_of(const Finding& finding, const FindingRule* rule) {
  if (finding.suppressed)
    return fmt::format("      <skipped message=\"suppressed: {}\"/>\n", xml_text(*finding.suppressed));
  if (finding.is_known) return "      <skipped message=\"in the baseline\"/>\n";
  const std::string place = finding.place ? place_text(*finding.place) + ": " : "";
  const std::string help = rule == nullptr ? "" : "\n" + rule->help;
  const std::string words = xml_text(place + finding.message + help);
  if (!is_failure(finding))
    return fmt::format("      <system-out>{}: {}</system-out>\n", name(finding.level), words);
  return fmt::format("      <failure message=\"{}\" type=\"{}\">{}</failure>\n", xml_text(finding.message),
                     xml_text(finding.rule), words);
}

std::string test_of(const std::string& suite, const Finding& finding, const FindingRule* rule) {
  // The place makes the name unique: dashboards take tests of one name for one test.
  const std::string place = finding.place ? place_text(*finding.place) + ": " : "";
  const std::string file =
      finding.place ? fmt::format(" file=\"{}\"", xml_text(finding.place->path)) : std::string();
  return fmt::format("    <testcase classname=\"{}\" name=\"{}\"{} time=\"0\">\n{}    </testcase>\n",
                     xml_text(suite + "." + finding.rule), xml_text(place + finding.message), file,
                     outcome_of(finding, rule));
}

}  // namespace

std::string findings_junit(const FindingReport& report) {
  const std::string suite = "shadefit." + report.command;
  std::size_t tests = report.findings.size();
  std::string cases;
  for (const FindingRule& rule : report.rules) {
    const bool is_broken =
        std::ranges::find(report.findings, rule.id, &Finding::rule) != report.findings.end();
    if (is_broken) continue;
    ++tests;
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"/>\n",
                         xml_text(suite + "." + rule.id), xml_text(rule.title));
  }
  for (const Finding& finding : report.findings) cases += test_of(suite, finding, rule_of(report, finding));
  const auto failures = std::ranges::count_if(report.findings, is_failure);
  const auto skipped = std::ranges::count_if(report.findings, is_skipped);
  const std::string counts =
      fmt::format(R"(name="{}" tests="{}" failures="{}" errors="0" skipped="{}" time="0")", xml_text(suite),
                  tests, failures, skipped);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n  <testsuite {}>\n{}  </testsuite>\n"
      "</testsuites>\n",
      counts, counts, cases);
}

}  // namespace shadefit::findings
