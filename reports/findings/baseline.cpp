#include "reports/findings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "fit/input/bounded_file.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/csv.hpp"
#include "reports/sections/report.hpp"

namespace shadefit {
namespace {

constexpr const char* fits_file = "fits.csv";

/// The size limit of a table; the largest committed one has 70 KB. Even a short cell takes 32 bytes in
/// memory.
constexpr std::uintmax_t most_table_bytes = 4U << 20;

constexpr std::array baseline_files{fits_file,     "normalization.csv", "reflectance.csv",
                                    "fresnel.csv", "claims.csv",        "better.csv"};

constexpr std::array key_columns{"claim",      "constant", "parameter", "exponent",   "measure",
                                 "view_angle", "surface",  "ior",       "wavelength", "curve",
                                 "topic",      "name",     "format",    "interval"};

/// The columns whose words name a row; the n-th row of the same name is matched with the n-th.
std::vector<std::string> keys_of(const CsvTable& table) {
  std::vector<std::string> keys;
  std::map<std::string, int> seen;
  for (const auto& row : table.rows) {
    std::string key;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const auto& column = table.columns[i];
      const bool is_key = std::ranges::find(key_columns, column) != key_columns.end();
      if (is_key && !row[i].empty()) key += (key.empty() ? "" : " ") + row[i];
    }
    const int count = ++seen[key];
    keys.push_back(count == 1 ? key : fmt::format("{} ({})", key, count));
  }
  return keys;
}

/// How much a number changes, as a share of it, infinite from 0; nothing for words.
std::optional<double> change_of(const std::string& before, const std::string& after) {
  const auto old_value = parse_number(before), new_value = parse_number(after);
  if (!old_value || !new_value) return std::nullopt;
  if (*old_value == *new_value) return 0;
  return (*new_value - *old_value) / std::abs(*old_value);
}

std::string plain_effect(const std::optional<double>& change, const std::string& after) {
  if (!change) return "another word";
  if (*change == 0) return "the same number, written differently";
  if (std::isinf(*change)) return fmt::format("from 0 by {:.2g}", *parse_number(after));
  return fmt::format("relative change {:.2g}", *change);
}

/// The effect on the curve if a parameter is `before`, as in the baseline.
std::optional<std::string> curve_effect(const FitRow& origin, const std::string& before) {
  const auto value = parse_number(before);
  if (origin.report == nullptr || origin.report->fit.status != Status::converged || !value)
    return std::nullopt;
  const Fit& fit = origin.report->fit;
  auto from = fit.parameters;
  from[origin.parameter] = *value;
  return sentence(origin.refit->family->effect(setting_of(fit), fit.metric.domain, from, fit.parameters));
}

/// A table of the baseline, as it was read.
struct OldTable {
  std::string file, path;
  CsvTable table;
};

/// Adds what differs in two versions of a table; of fits.csv, `origins` are those of the rows of the newer
/// one.
void compare_tables(const OldTable& old, const CsvTable& after, const std::vector<FitRow>& origins,
                    CheckedTables& checked) {
  const CsvTable& before = old.table;
  constexpr std::size_t header = 1, first = header + 1;  // lines: no cell has line ends
  const auto add = [&](const std::string& row, std::size_t line, const std::string& effect) -> Drift& {
    checked.drifts.push_back(
        {.file = old.file, .row = row, .effect = effect, .path = old.path, .line = static_cast<long>(line)});
    return checked.drifts.back();
  };
  const auto old_keys = keys_of(before), new_keys = keys_of(after);
  for (std::size_t i = 0; i < after.rows.size(); ++i) {
    checked.cells += after.columns.size();
    const auto match = std::ranges::find(old_keys, new_keys[i]);
    if (match == old_keys.end()) {
      add(new_keys[i], header, "the baseline has no such row");
      continue;
    }
    const auto row = static_cast<std::size_t>(match - old_keys.begin());
    for (std::size_t j = 0; j < after.columns.size(); ++j) {
      const std::string &from = before.rows[row][j], &to = after.rows[i][j];
      if (from == to) continue;
      const bool is_of_a_curve = !origins.empty() && after.columns[j] == "fitted";
      const auto change = change_of(from, to);
      const auto effect = is_of_a_curve ? curve_effect(origins[i], from) : std::nullopt;
      Drift& drift = add(new_keys[i], first + row, effect.value_or(plain_effect(change, to)));
      drift.column = after.columns[j];
      drift.before = from;
      drift.after = to;
      if (change) drift.change = std::abs(*change);
    }
  }
  for (std::size_t row = 0; row < old_keys.size(); ++row) {
    if (std::ranges::find(new_keys, old_keys[row]) == new_keys.end())
      add(old_keys[row], first + row, "a row that is no longer computed");
  }
}

/// The table of a file of the baseline, which must have these columns.
OldTable parse_checked(const Baseline& baseline, const std::string& name,
                       const std::vector<std::string>& columns) {
  const auto file = std::ranges::find(baseline.files, name, &File::name);
  const std::filesystem::path path = baseline.directory / name;
  const CsvTable table = parse_csv(file->content, path.string());
  if (table.columns != columns)
    throw UserError(fmt::format("'{}' has other columns ({}): they must be {}", path.string(),
                                fmt::join(table.columns, ","), fmt::join(columns, ",")));
  return {name, path.lexically_normal().generic_string(), table};
}

/// The ids stay: dashboards and suppressions name them.
constexpr const char* changed_cell = "changed-cell";
constexpr const char* changed_row = "changed-row";

std::string message_of(const Drift& drift) {
  if (drift.column.empty()) return fmt::format("the row '{}': {}", drift.row, drift.effect);
  return fmt::format("{} of the row '{}' is '{}' in the baseline and '{}' now: {}", drift.column, drift.row,
                     drift.before, drift.after, drift.effect);
}

}  // namespace

Baseline read_baseline(const std::filesystem::path& directory) {
  std::error_code error;
  if (!std::filesystem::exists(directory, error)) {
    throw UserError(
        fmt::format("baseline '{}' is missing: name the directory with --baseline, or make one with "
                    "'shadefit run --out DIR'",
                    directory.string()));
  }
  if (!std::filesystem::is_directory(directory, error)) {
    throw UserError(fmt::format("baseline '{}' is not a directory: it must hold {}", directory.string(),
                                fmt::join(baseline_files, ", ")));
  }
  return read_tables(directory, {baseline_files.begin(), baseline_files.end()});
}

Baseline read_tables(const std::filesystem::path& directory, const std::vector<std::string>& names) {
  Baseline tables{directory, {}};
  for (const std::string& name : names) {
    tables.files.push_back({name, read_bounded(directory / name, most_table_bytes)});
    parse_csv(tables.files.back().content, (directory / name).string());
  }
  return tables;
}

CheckedTables compare_files(const Baseline& tables, const std::vector<File>& now,
                            const std::vector<FitRow>& origins) {
  CheckedTables checked;
  for (const auto& [name, content] : now) {
    const CsvTable table = parse_csv(content, name);
    compare_tables(parse_checked(tables, name, table.columns), table,
                   name == fits_file ? origins : std::vector<FitRow>{}, checked);
  }
  return checked;
}

CheckedTables compare(const Baseline& baseline, const Results& results) {
  return compare_files(baseline, table_files(results), fits_table(results.refits).origins);
}

bool is_failing(const Drift& drift, const std::optional<double>& fail_above) {
  return !fail_above || !drift.change || *drift.change > *fail_above;
}

findings::FindingReport drift_findings(const CheckedTables& checked,
                                       const std::optional<double>& fail_above) {
  constexpr const char* renewal =
      "If the change is meant, renew the baseline: shadefit run --no-plots --out DIR, for a study "
      "shadefit run STUDY --no-plots --out DIR.";
  findings::FindingReport report{"check",
                                 {{changed_cell, "A cell is not what is computed now", renewal},
                                  {changed_row, "A row is new, or no longer computed", renewal}},
                                 {},
                                 checked.cells,
                                 "cells"};
  for (const Drift& drift : checked.drifts) {
    using findings::FindingLevel;
    const char* rule = drift.column.empty() ? changed_row : changed_cell;
    report.findings.push_back(
        {.rule = rule,
         .level = is_failing(drift, fail_above) ? FindingLevel::error : FindingLevel::note,
         .message = message_of(drift),
         .place = {.path = drift.path, .line = drift.line},
         .fingerprint = fmt::format("{} {} {}{}{}", rule, drift.file, drift.row,
                                    drift.column.empty() ? "" : " ", drift.column)});
  }
  std::ranges::stable_sort(report.findings, [](const auto& a, const auto& b) {
    return std::tie(a.place.path, a.place.line) < std::tie(b.place.path, b.place.line);
  });
  return report;
}

}  // namespace shadefit
