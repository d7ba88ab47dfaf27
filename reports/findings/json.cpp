#include <nlohmann/json.hpp>

#include "reports/findings/finding_texts.hpp"
#include "reports/io/escape.hpp"

/// Findings as JSON of our own; docs/output-formats.md has the fields.
namespace shadefit::findings {
namespace {

/// The version of the object; it grows when a field changes its meaning, not when one is added.
constexpr int findings_schema = 1;

using FindingJson = nlohmann::ordered_json;

/// A number from 1, or null.
FindingJson known_number(long number) {
  return number > 0 ? FindingJson(number) : FindingJson();
}

FindingJson finding_json(const Finding& finding) {
  const FindingPlace place = finding.place.value_or(FindingPlace{});
  return {{"rule", finding.rule},
          {"level", name(finding.level)},
          {"message", finding.message},
          {"path", finding.place ? FindingJson(place.path) : FindingJson()},
          {"line", known_number(place.line)},
          {"column", known_number(place.column)},
          {"end_line", known_number(place.end_line)},
          {"end_column", known_number(place.end_column)},
          {"fingerprint", finding.fingerprint},
          {"suppressed", finding.suppressed ? FindingJson(*finding.suppressed) : FindingJson()},
          {"known", finding.is_known}};
}

}  // namespace

std::string findings_json(const FindingReport& report) {
  const FindingCounts counts = count(report);
  FindingJson json{{"schema", findings_schema},
                   {"command", report.command},
                   {"passed", passes(report)},
                   {"checked", report.checked},
                   {"checked_words", report.checked_words},
                   {"counts",
                    {{"errors", counts.errors},
                     {"warnings", counts.warnings},
                     {"notes", counts.notes},
                     {"suppressed", counts.suppressed},
                     {"known", counts.known}}},
                   {"rules", FindingJson::array()},
                   {"findings", FindingJson::array()}};
  for (const FindingRule& rule : report.rules)
    json["rules"].push_back({{"id", rule.id}, {"title", rule.title}, {"help", rule.help}});
  for (const Finding& finding : report.findings) json["findings"].push_back(finding_json(finding));
  return json_text(json);
}

}  // namespace shadefit::findings
