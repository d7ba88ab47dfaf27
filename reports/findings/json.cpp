#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/findings/finding.hpp"
#include "reports/io/escape.hpp"

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
  const FindingPlace& place = finding.place;
  return {{"rule", finding.rule},
          {"level", name(finding.level)},
          {"message", finding.message},
          {"path", place.path},
          {"line", known_number(place.line)},
          {"column", known_number(place.column)},
          {"end_line", known_number(place.end_line)},
          {"end_column", known_number(place.end_column)},
          {"fingerprint", finding.fingerprint},
          {"suppressed", finding.suppressed ? FindingJson(*finding.suppressed) : FindingJson()},
          {"known", finding.is_known}};
}

/// A path as a URI reference: all but unreserved characters and '/' as %NN (RFC 3986, section 2.3). A colon
/// in the first folder would read as a scheme.
std::string uri_of(std::string_view path) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    uri += plain.find(c) != std::string_view::npos ? std::string(1, c)
                                                   : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

FindingJson location_json(const FindingPlace& place) {
  FindingJson artifact{{"uri", uri_of(place.path)}};
  // 3.4.4: the consumer knows the folder of a relative URI; this is the name that code hosts expect.
  if (!place.path.starts_with('/')) artifact["uriBaseId"] = "%SRCROOT%";
  FindingJson region{{"startLine", std::max(place.line, 1L)}};
  if (place.column > 0) region["startColumn"] = place.column;
  if (place.end_line > 0) region["endLine"] = place.end_line;
  if (place.end_column > 0) region["endColumn"] = place.end_column;
  return {{"physicalLocation", {{"artifactLocation", artifact}, {"region", region}}}};
}

FindingJson result_json(const FindingReport& report, const Finding& finding) {
  FindingJson result{{"ruleId", finding.rule},
                     {"ruleIndex", &rule_of(report, finding) - report.rules.data()},
                     {"level", name(finding.level)},
                     {"message", {{"text", finding.message}}},
                     {"locations", FindingJson::array({location_json(finding.place)})}};
  if (!finding.fingerprint.empty()) result["partialFingerprints"] = {{"shadefit/v1", finding.fingerprint}};
  result["baselineState"] = finding.is_known ? "unchanged" : "new";
  // 3.27.23: either all results have the list, or none.
  result["suppressions"] = FindingJson::array();
  if (finding.suppressed)
    result["suppressions"].push_back({{"kind", "inSource"}, {"justification", *finding.suppressed}});
  return result;
}

}  // namespace

/// JSON of our own; docs/output-formats.md has the fields.
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

/// Source: OASIS 2020, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0"; the numbers in
/// comments are its sections.
std::string findings_sarif(const FindingReport& report) {
  FindingJson rules = FindingJson::array(), results = FindingJson::array();
  for (const FindingRule& rule : report.rules) {
    rules.push_back(
        {{"id", rule.id}, {"shortDescription", {{"text", rule.title}}}, {"help", {{"text", rule.help}}}});
  }
  for (const Finding& finding : report.findings) results.push_back(result_json(report, finding));
  const FindingJson driver{{"name", "shadefit"}, {"version", SHADEFIT_VERSION}, {"rules", rules}};
  const FindingJson run{
      {"tool", {{"driver", driver}}},
      // 3.17.3: a name that ends in '/' is a kind of run, so that `lint` does not replace `check`.
      {"automationDetails", {{"id", fmt::format("shadefit/{}/", report.command)}}},
      {"columnKind", "unicodeCodePoints"},
      {"results", results}};
  const FindingJson log{
      {"$schema",
       "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"},
      {"version", "2.1.0"},
      {"runs", FindingJson::array({run})}};
  return json_text(log);
}

}  // namespace shadefit::findings
