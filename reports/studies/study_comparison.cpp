#include "reports/studies/study_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// "a = 1.5707963, b = -0.156583": as printed, or to ten digits.
std::string constants_text(const StudyContender& contender) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < contender.names.size(); ++i) {
    const std::string value = contender.printed.empty()
                                  ? text(converged(contender.values[i]), Precision::report)
                                  : contender.printed[i];
    parts.push_back(contender.names[i] + " = " + value);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string origin_of(const StudyContender& contender) {
  return contender.published != nullptr ? short_source(contender.origin) : contender.origin;
}

std::string_view short_name(StatedError error) {
  switch (error) {
    case StatedError::max_abs_error:
      return "";
    case StatedError::max_rel_error:
      return " relative";
    case StatedError::mean_abs_error:
      return " mean";
    case StatedError::mean_rel_error:
      return " mean relative";
    case StatedError::rms_error:
      return " rms";
    case StatedError::mean_square_error:
      return " mean square";
  }
  return "";
}

std::string claim_text(const StudyContender& contender) {
  std::vector<std::string> parts;
  for (const JudgedError& judged : contender.claims)
    parts.push_back(fmt::format("{}{}{}: {}", judged.claim.printed, short_name(judged.claim.error),
                                ranges_text(judged.claim), name(judged.verdict)));
  return fmt::format("{}", fmt::join(parts, "; "));
}

Json ranges_json(const ErrorClaim& claim) {
  Json ranges = Json::object();
  for (const StudyRange& range : claim.over) ranges[range.variable] = {range.lower, range.upper};
  return ranges;
}

std::string beaten(const StudyContender& contender) {
  std::vector<std::size_t> numbers;
  for (const std::size_t i : contender.beats) numbers.push_back(i + 1);
  return fmt::format("{}", fmt::join(numbers, ", "));
}

/// The cells of a contender that tables share: from its form to what it beats.
std::vector<Cell> cells_of(const StudyContender& contender) {
  std::vector<Cell> cells{contender.form, constants_text(contender), origin_of(contender),
                          Number{contender.max_error.magnitude, 4}};
  for (const double x : contender.max_error.at) cells.push_back(Number{x, 4});
  cells.insert(cells.end(), {to_text(contender.operations), static_cast<long>(contender.operations.total()),
                             contender.judgement ? verdict_text(*contender.judgement) : "",
                             claim_text(contender), beaten(contender)});
  return cells;
}

std::vector<std::string> columns_of(const StudyComparison& comparison) {
  std::vector<std::string> columns{"form", "constants", "from", error_in_words(comparison.error)};
  for (const std::string& variable : comparison.variables) columns.push_back("at " + variable);
  columns.insert(columns.end(), {"operations", "instructions", "verdict", "claimed error", "beats"});
  return columns;
}

/// The table without the columns that have nothing to say.
Table without_empty_columns(const Table& table) {
  Table result{{}, std::vector<std::vector<Cell>>(table.rows.size())};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const bool is_empty = std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
      return text(row[i], Precision::report).empty();
    });
    if (is_empty) continue;
    result.columns.push_back(table.columns[i]);
    for (std::size_t j = 0; j < table.rows.size(); ++j) result.rows[j].push_back(table.rows[j][i]);
  }
  return result;
}

}  // namespace

std::string ranges_text(const ErrorClaim& claim) {
  std::string text;
  for (const StudyRange& range : claim.over)
    text += fmt::format(", {} in {}:{}", range.variable, range.lower, range.upper);
  return text;
}

std::string error_in_words(std::string_view key) {
  std::string words(key);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string curve_in_words(std::string_view key) {
  return key == "max_abs_error"   ? "form − target"
         : key == "max_rel_error" ? "relative error"
                                  : "weighted error";
}

std::string target_of(const StudyComparison& comparison) {
  const auto& rows = comparison.study.rows;
  if (rows) return rows->file + (comparison.study.given.empty() ? "" : ", " + given_text(comparison.study));
  std::string out = comparison.study.target;
  for (const StudyRange& range : comparison.study.over)
    out += fmt::format(", {} in {}:{}", range.variable, range.lower, range.upper);
  const std::string given = given_text(comparison.study);
  return given.empty() ? out : out + ", " + given;
}

Table study_comparison_table(const StudyComparison& comparison) {
  Table table{{"row"}, {}};
  const auto columns = columns_of(comparison);
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  for (std::size_t i = 0; i < comparison.contenders.size(); ++i) {
    std::vector<Cell> row{static_cast<long>(i + 1)};
    for (Cell& cell : cells_of(comparison.contenders[i])) row.push_back(std::move(cell));
    table.rows.push_back(row);
  }
  return without_empty_columns(table);
}

Table study_comparisons_table(const std::vector<StudyComparison>& comparisons) {
  Table table{{"name", "curve"}, {}};
  const auto columns = columns_of(comparisons.front());
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  for (const StudyComparison& comparison : comparisons) {
    for (const StudyContender& contender : comparison.contenders) {
      std::vector<Cell> row{given_text(comparison.study), contender.form + ", " + origin_of(contender)};
      for (Cell& cell : cells_of(contender)) row.push_back(std::move(cell));
      table.rows.push_back(row);
    }
  }
  return table;
}

Json study_comparison_json(const StudyComparison& comparison) {
  Json contenders = Json::array();
  for (const StudyContender& contender : comparison.contenders) {
    Json parameters = Json::object(), printed, at = Json::object();
    for (std::size_t i = 0; i < contender.names.size(); ++i) {
      parameters[contender.names[i]] = contender.values[i];
      if (!contender.printed.empty()) printed[contender.names[i]] = contender.printed[i];
    }
    for (std::size_t i = 0; i < comparison.variables.size(); ++i)
      at[comparison.variables[i]] = contender.max_error.at[i];
    const auto& judgement = contender.judgement;
    Json claims = Json::array();
    for (const JudgedError& judged : contender.claims)
      claims.push_back({{"error", name(judged.claim.error)},
                        {"over", ranges_json(judged.claim)},
                        {"printed", judged.claim.printed},
                        {"computed", judged.computed},
                        {"verdict", name(judged.verdict)}});
    contenders.push_back(
        {{"kind", contender.published != nullptr ? "published" : "fitted"},
         {"form", contender.form},
         {"formula", contender.formula},
         {"from", contender.origin},
         {"parameters", parameters},
         {"printed", printed},
         {comparison.error, contender.max_error.magnitude},
         {"at", at},
         {"operations", to_text(contender.operations)},
         {"instructions", contender.operations.total()},
         {"verdict", judgement ? Json(name(judgement->verdict)) : Json()},
         {"objective", judgement && !judgement->objective.empty() ? Json(judgement->objective) : Json()},
         {"fits_tried", judgement ? Json(judgement->tried) : Json()},
         {"chance_hits", judgement ? Json(judgement->chance) : Json()},
         {"units_off", judgement ? Json(judgement->units_off) : Json()},
         {"claims", claims},
         {"beats", contender.beats}});
  }
  Json given = Json::object();
  for (const auto& [name, value] : comparison.study.given) given[name] = value;
  return {{"target", comparison.study.target},
          {"given", given},
          {"contenders", contenders},
          {"left_out", comparison.left_out}};
}

std::string left_out_lines(const StudyComparison& comparison) {
  std::string lines;
  for (const std::string& line : comparison.left_out) lines += "Left out: " + line + "\n";
  return lines;
}

}  // namespace shadefit
