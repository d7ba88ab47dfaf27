#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a check found, as plain data, and its texts for terminals, scripts and code hosts. They have
/// a namespace of their own, because the ledger has a `Finding` too.
namespace shadefit::findings {

enum class FindingLevel { error, warning, note };

/// A region of a file. Lines and columns count from 1; 0: not known. A column counts code points.
/// `end_column` is one past the last character.
struct FindingPlace {
  std::string path;  ///< relative to the folder of the call, '/' between folders; or absolute
  long line = 0, column = 0, end_line = 0, end_column = 0;
};

struct Finding {
  std::string rule;  ///< the id of a `FindingRule`
  FindingLevel level = FindingLevel::error;
  std::string message;  ///< one sentence
  FindingPlace place = {};
  std::string fingerprint = {};                ///< the same for the same finding when lines move
  std::optional<std::string> suppressed = {};  ///< the reason; such a finding fails nothing
  bool is_known = false;                       ///< in the baseline: "unchanged", else "new"
};

struct FindingRule {
  std::string id;  ///< stable, such as "wrong-constant"
  std::string title, help;
};

struct FindingReport {
  std::string command;  ///< "lint", "check"
  std::vector<FindingRule> rules;
  std::vector<Finding> findings;  ///< in order of place
  std::size_t checked = 0;
  std::string checked_words;  ///< what was checked: 812 "files", 38000 "numbers"
};

enum class FindingFormat { text, json, sarif, github, markdown };
inline constexpr std::array finding_formats{FindingFormat::text, FindingFormat::json, FindingFormat::sarif,
                                            FindingFormat::github, FindingFormat::markdown};

constexpr std::string_view name(FindingFormat format) {
  constexpr std::array<std::string_view, finding_formats.size()> names{"text", "json", "sarif", "github",
                                                                       "markdown"};
  return names[static_cast<std::size_t>(format)];
}

/// Whether no finding fails the check: an error that is neither suppressed nor in the baseline.
bool passes(const FindingReport& report);

/// The report in one of the formats, with a line end at its end where it is not empty:
/// - text: a line for each finding, as compilers write them, and a line that counts;
/// - json: an object of our own, docs/output-formats.md;
/// - sarif: SARIF 2.1.0 (OASIS, 2020);
/// - github: workflow commands of GitHub Actions;
/// - markdown: a summary for $GITHUB_STEP_SUMMARY.
std::string write_findings(const FindingReport& report, FindingFormat format);

/// What the writers of findings share. How many findings there are. A suppressed or known one counts as that
/// alone.
struct FindingCounts {
  std::size_t errors = 0, warnings = 0, notes = 0, suppressed = 0, known = 0;
};
FindingCounts count(const FindingReport& report);

/// "error", "warning", "note": the words of compilers and of SARIF.
constexpr std::string_view name(FindingLevel level) {
  constexpr std::array<std::string_view, 3> names{"error", "warning", "note"};
  return names[static_cast<std::size_t>(level)];
}

/// The rule of a finding, which the report has.
const FindingRule& rule_of(const FindingReport& report, const Finding& finding);

std::string findings_json(const FindingReport& report);
std::string findings_sarif(const FindingReport& report);

}  // namespace shadefit::findings
