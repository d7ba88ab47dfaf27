#include "reports/findings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "fit/input/bounded_file.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/csv.hpp"
#include "reports/rows/tables.hpp"
#include "reports/sections/report.hpp"
#include "reports/table/writers.hpp"

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

std::string plain_effect(const std::string& before, const std::string& after) {
  const auto old_value = parse_number(before), new_value = parse_number(after);
  if (!old_value || !new_value) return "another word";
  if (*old_value == *new_value) return "the same number, written differently";
  if (*old_value == 0) return fmt::format("from 0 by {:.2g}", *new_value);
  return fmt::format("relative change {:.2g}", (*new_value - *old_value) / std::abs(*old_value));
}

/// How much a number changes, as a share of it; empty for words.
std::optional<double> change_of(const std::string& before, const std::string& after) {
  const auto old_value = parse_number(before), new_value = parse_number(after);
  if (!old_value || !new_value) return std::nullopt;
  if (*old_value == *new_value) return 0;
  return std::abs(*new_value - *old_value) / std::abs(*old_value);
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

/// The line of a row: no cell has line ends.
long line_of(std::size_t row) {
  constexpr long first = 2;  // after the header
  return first + static_cast<long>(row);
}

/// Compares two versions of a table; of fits.csv, `origins` are those of the rows of the newer one.
std::vector<Drift> compare_tables(const OldTable& old, const CsvTable& after,
                                  const std::vector<FitRow>& origins = {}) {
  const CsvTable& before = old.table;
  std::vector<Drift> drifts;
  const auto add = [&](const std::string& row, const std::string& column, const std::string& from,
                       const std::string& to, const std::string& effect, long line) {
    drifts.push_back({old.file, row, column, from, to, effect, old.path, line, change_of(from, to)});
  };
  const auto old_keys = keys_of(before), new_keys = keys_of(after);
  for (std::size_t i = 0; i < after.rows.size(); ++i) {
    const auto match = std::ranges::find(old_keys, new_keys[i]);
    if (match == old_keys.end()) {
      add(new_keys[i], "", "", "", "the baseline has no such row", 1);
      continue;
    }
    const auto row = static_cast<std::size_t>(match - old_keys.begin());
    const auto& old_row = before.rows[row];
    for (std::size_t j = 0; j < after.columns.size(); ++j) {
      if (old_row[j] == after.rows[i][j]) continue;
      const bool is_of_a_curve = !origins.empty() && after.columns[j] == "fitted";
      const auto effect = is_of_a_curve ? curve_effect(origins[i], old_row[j]) : std::nullopt;
      add(new_keys[i], after.columns[j], old_row[j], after.rows[i][j],
          effect.value_or(plain_effect(old_row[j], after.rows[i][j])), line_of(row));
    }
  }
  for (std::size_t row = 0; row < old_keys.size(); ++row) {
    if (std::ranges::find(new_keys, old_keys[row]) != new_keys.end()) continue;
    add(old_keys[row], "", "", "", "a row that is no longer computed", line_of(row));
  }
  return drifts;
}

/// The computed table as a reader of its CSV sees it.
CsvTable as_csv(const Table& table, const std::string& name) {
  return parse_csv(write_csv(table, Precision::report), name);
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

std::vector<Drift> compare(const Baseline& baseline, const Results& results) {
  const FitsTable fits = fits_table(results.refits);
  auto drifts = compare_tables(parse_checked(baseline, fits_file, fits.table.columns),
                               as_csv(fits.table, fits_file), fits.origins);
  for (const auto& [file, table] : plain_tables(results)) {
    const auto others = compare_tables(parse_checked(baseline, file, table.columns), as_csv(table, file));
    drifts.insert(drifts.end(), others.begin(), others.end());
  }
  return drifts;
}

std::vector<Drift> compare_files(const Baseline& tables, const std::vector<File>& now) {
  std::vector<Drift> drifts;
  for (const File& file : now) {
    const CsvTable after = parse_csv(file.content, file.name);
    const auto others = compare_tables(parse_checked(tables, file.name, after.columns), after);
    drifts.insert(drifts.end(), others.begin(), others.end());
  }
  return drifts;
}

std::size_t count_cells(const std::vector<File>& files) {
  std::size_t sum = 0;
  for (const File& file : files) {
    const CsvTable table = parse_csv(file.content, file.name);
    sum += table.rows.size() * table.columns.size();
  }
  return sum;
}

std::size_t count_cells(const Results& results) {
  const auto cells = [](const Table& table) { return table.rows.size() * table.columns.size(); };
  std::size_t sum = cells(fits_table(results.refits).table);
  for (const auto& [file, table] : plain_tables(results)) sum += cells(table);
  return sum;
}

}  // namespace shadefit
