#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/findings/finding_texts.hpp"
#include "reports/io/escape.hpp"

/// Findings as SARIF. Source: OASIS 2020, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0";
/// the numbers in comments are its sections.
namespace shadefit::findings {
namespace {

using SarifJson = nlohmann::ordered_json;

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

SarifJson location_json(const FindingPlace& place) {
  SarifJson artifact{{"uri", uri_of(place.path)}};
  // 3.4.4: the consumer knows the folder of a relative URI; this is the name that code hosts expect.
  if (!place.path.starts_with('/')) artifact["uriBaseId"] = "%SRCROOT%";
  SarifJson region{{"startLine", std::max(place.line, 1L)}};
  if (place.column > 0) region["startColumn"] = place.column;
  if (place.end_line > 0) region["endLine"] = place.end_line;
  if (place.end_column > 0) region["endColumn"] = place.end_column;
  return {{"physicalLocation", {{"artifactLocation", artifact}, {"region", region}}}};
}

SarifJson result_json(const FindingReport& report, const Finding& finding) {
  SarifJson result{{"ruleId", finding.rule}};
  if (const FindingRule* rule = rule_of(report, finding)) result["ruleIndex"] = rule - report.rules.data();
  result["level"] = name(finding.level);
  result["message"] = {{"text", finding.message}};
  result["locations"] = SarifJson::array();
  if (finding.place) result["locations"].push_back(location_json(*finding.place));
  if (!finding.fingerprint.empty()) result["partialFingerprints"] = {{"shadefit/v1", finding.fingerprint}};
  result["baselineState"] = finding.is_known ? "unchanged" : "new";
  // 3.27.23: either all results have the list, or none.
  result["suppressions"] = SarifJson::array();
  if (finding.suppressed)
    result["suppressions"].push_back({{"kind", "inSource"}, {"justification", *finding.suppressed}});
  return result;
}

}  // namespace

std::string findings_sarif(const FindingReport& report) {
  SarifJson rules = SarifJson::array(), results = SarifJson::array();
  for (const FindingRule& rule : report.rules) {
    rules.push_back(
        {{"id", rule.id}, {"shortDescription", {{"text", rule.title}}}, {"help", {{"text", rule.help}}}});
  }
  for (const Finding& finding : report.findings) results.push_back(result_json(report, finding));
  const SarifJson driver{{"name", "shadefit"}, {"version", SHADEFIT_VERSION}, {"rules", rules}};
  const SarifJson run{
      {"tool", {{"driver", driver}}},
      // 3.17.3: a name that ends in '/' is a kind of run, so that `lint` does not replace `check`.
      {"automationDetails", {{"id", fmt::format("shadefit/{}/", report.command)}}},
      {"columnKind", "unicodeCodePoints"},
      {"results", results}};
  const SarifJson log{
      {"$schema",
       "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"},
      {"version", "2.1.0"},
      {"runs", SarifJson::array({run})}};
  return json_text(log);
}

}  // namespace shadefit::findings
