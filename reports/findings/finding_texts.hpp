#pragma once

#include <string>
#include <string_view>

#include "reports/findings/finding.hpp"

/// What the writers of findings share.
namespace shadefit::findings {

/// How many findings there are. A suppressed or known one counts as that alone.
struct FindingCounts {
  std::size_t errors = 0, warnings = 0, notes = 0, suppressed = 0, known = 0;
};
FindingCounts count(const FindingReport& report);

/// "error", "warning", "note": the words of compilers and of SARIF.
constexpr std::string_view name(FindingLevel level) {
  constexpr std::array<std::string_view, 3> names{"error", "warning", "note"};
  return names[static_cast<std::size_t>(level)];
}

/// The rule of a finding, or null.
const FindingRule* rule_of(const FindingReport& report, const Finding& finding);

std::string findings_json(const FindingReport& report);
std::string findings_sarif(const FindingReport& report);

}  // namespace shadefit::findings
