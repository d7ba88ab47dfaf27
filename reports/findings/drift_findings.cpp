#include "reports/findings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace shadefit {
namespace {

/// The ids stay: dashboards and suppressions name them.
constexpr const char* changed_cell = "changed-cell";
constexpr const char* changed_row = "changed-row";

std::string message_of(const Drift& drift) {
  if (drift.column.empty()) return fmt::format("the row '{}': {}", drift.row, drift.effect);
  return fmt::format("{} of the row '{}' is '{}' in the baseline and '{}' now: {}", drift.column, drift.row,
                     drift.before, drift.after, drift.effect);
}

}  // namespace

bool is_failing(const Drift& drift, const std::optional<double>& fail_above) {
  return !fail_above || !drift.change || *drift.change > *fail_above;
}

findings::FindingReport drift_findings(const std::vector<Drift>& drifts, std::size_t cells,
                                       const std::optional<double>& fail_above) {
  constexpr const char* renewal =
      "If the change is meant, renew the baseline: shadefit run --no-plots --out DIR, for a study "
      "shadefit run STUDY --no-plots --out DIR.";
  findings::FindingReport report{"check",
                                 {{changed_cell, "A cell is not what is computed now", renewal},
                                  {changed_row, "A row is new, or no longer computed", renewal}},
                                 {},
                                 cells,
                                 "cells"};
  for (const Drift& drift : drifts) {
    using findings::FindingLevel;
    const char* rule = drift.column.empty() ? changed_row : changed_cell;
    report.findings.push_back(
        {.rule = rule,
         .level = is_failing(drift, fail_above) ? FindingLevel::error : FindingLevel::note,
         .message = message_of(drift),
         .place = findings::FindingPlace{.path = drift.path, .line = drift.line},
         .fingerprint = fmt::format("{} {} {}{}{}", rule, drift.file, drift.row,
                                    drift.column.empty() ? "" : " ", drift.column)});
  }
  std::ranges::stable_sort(report.findings, [](const auto& a, const auto& b) {
    return std::tie(a.place->path, a.place->line) < std::tie(b.place->path, b.place->line);
  });
  return report;
}

}  // namespace shadefit
