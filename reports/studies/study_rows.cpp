#include "reports/studies/study_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/scalars/symbolic.hpp"
#include "fit/support/decimal.hpp"
#include "reports/io/joined.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

bool is_answer(const FittedStudy& study) {
  return study.fit.status == Status::converged;
}

/// "converged"; "given" where nothing was fitted.
std::string status_of(const FittedStudy& study) {
  return is_answer(study) && study.fit.names.empty() ? "given" : std::string(name(study.fit.status));
}

/// Whether a weight says which error counts.
bool is_weighted(const FittedStudy& study) {
  return !study.asked().rows && study.asked().weight != "1";
}

/// The last columns: the largest error and its place; of measured rows its row, and how large the noise is.
std::vector<std::string> last_columns(const std::vector<FittedStudy>& studies) {
  if (!studies.front().asked().rows) {
    std::vector<std::string> columns;
    if (is_weighted(studies.front())) columns.emplace_back("max weighted error");
    columns.emplace_back("max abs error");
    for (const StudyAxis& axis : studies.front().read.axes) columns.push_back("at " + axis.variable);
    return columns;
  }
  const bool is_absolute = std::ranges::any_of(studies, [](const FittedStudy& study) {
    return study.fit.statistics && study.fit.statistics->is_absolute;
  });
  return {"largest residual", "row", is_absolute ? "reduced chi-square" : "s"};
}

std::vector<Cell> last_cells(const FittedStudy& study) {
  const StudyExtremum& largest = study.fit.max_abs_error;
  std::vector<Cell> cells;
  if (is_weighted(study)) cells.emplace_back(Number{study.fit.max_weighted_error.value(), 4});
  cells.emplace_back(Number{largest.magnitude, 4});
  if (!study.asked().rows) {
    for (const double place : largest.at) cells.emplace_back(Number{place, 6});
    return cells;
  }
  cells.emplace_back(static_cast<long>(largest.row));
  const auto& statistics = study.fit.statistics;
  const auto size = [&] {
    return statistics->is_absolute ? statistics->variance : std::sqrt(statistics->variance);
  };
  cells.push_back(statistics ? Cell(Number{size(), 6}) : Cell());
  return cells;
}

OthersText target_text(const Study& study) {
  if (!study.rows) return study.target;
  return "'" + study.rows->file + "', " + counted(static_cast<long>(study.rows->value.size()), "row");
}

std::string range_text(const StudyRange& range) {
  if (range.lower.empty()) return "over " + range.variable;
  const std::string text = fmt::format("{} in {}:{}", range.variable, range.lower, range.upper);
  return range.density == "1" ? text : fmt::format("{}, density {}", text, range.density);
}

/// "a in 0:1", "a >= 0".
std::string bounds_text(const ParameterBounds& of) {
  if (std::isinf(of.upper)) return fmt::format("{} >= {}", of.parameter, to_text(of.lower));
  if (std::isinf(of.lower)) return fmt::format("{} <= {}", of.parameter, to_text(of.upper));
  return fmt::format("{} in {}:{}", of.parameter, to_text(of.lower), to_text(of.upper));
}

Json published_json(const FittedStudy& study) {
  return json_array(study.published, [](const JudgedSet& judged) -> Json {
    const auto& [set, judgement] = judged;
    return {{"values", json_object(set.values)},
            {"source", set.source},
            {"verdict", name(judgement.verdict)},
            {"objective", judgement.objective.empty() ? Json() : Json(judgement.objective)},
            {"fits_tried", judgement.tried}};
  });
}

/// Digits of an uncertainty: more would be noise.
constexpr int shown_digits = 6;

Cell end_cell(const std::optional<double>& end) {
  return end ? Cell(Number{*end, shown_digits}) : word("open");
}

/// The standard error and the ends of the interval of a parameter; empty cells where there are none.
std::vector<Cell> cells_of(const FittedStudy& study, std::size_t parameter) {
  if (!study.fit.statistics) return std::vector<Cell>(3);
  const RowStatistics& statistics = *study.fit.statistics;
  const ProfileInterval& profile = statistics.profiles[parameter];
  return {Number{statistics.standard_errors[parameter], shown_digits}, end_cell(profile.lower),
          end_cell(profile.upper)};
}

/// Adds what only fits of measured rows have.
void add_row_fields(Json& object, const FittedStudy& study) {
  const bool has_answer = study.fit.status == Status::converged;
  const auto& statistics = study.fit.statistics;
  object["table"] = study.read.rows->file;
  object["rows"] = study.read.rows->value.size();
  object["row"] = has_answer ? Json(study.fit.max_abs_error.row) : Json();
  object["degrees_of_freedom"] = statistics ? Json(statistics->freedom) : Json();
  object["reduced_chi_square"] = statistics && statistics->is_absolute ? Json(statistics->variance) : Json();
  object["residual_deviation"] =
      statistics && !statistics->is_absolute ? Json(std::sqrt(statistics->variance)) : Json();
  Json errors = Json::object(), covariance = Json::object(), profile = Json::object();
  const std::vector<std::string>& names = study.fit.names;
  for (std::size_t i = 0; statistics && i < names.size(); ++i) {
    errors[names[i]] = statistics->standard_errors[i];
    for (std::size_t j = 0; j < names.size(); ++j)
      covariance[names[i]][names[j]] = statistics->covariance[i][j];
    profile[names[i]] = {optional_json(statistics->profiles[i].lower),
                         optional_json(statistics->profiles[i].upper)};
  }
  object["standard_error"] = statistics ? errors : Json();
  object["covariance"] = statistics ? covariance : Json();
  object["profile"] = statistics ? profile : Json();
}

}  // namespace

std::string verdict_in_words(const StudyJudgement& judgement) {
  std::string verdict(name(judgement.verdict));
  if (judgement.compared_digits) verdict += fmt::format(" to {} digits", *judgement.compared_digits);
  const bool has_objective =
      judgement.verdict == Verdict::other_objective || judgement.verdict == Verdict::undecidable;
  return has_objective ? verdict + ": " + judgement.objective : verdict;
}

std::string verdict_text(const StudyJudgement& judgement) {
  return fmt::format("{} ({} fits tried)", verdict_in_words(judgement), judgement.tried);
}

OthersText short_source(const OthersText& of) {
  constexpr std::size_t year = 4;
  const std::string& source = of.unescaped();
  for (std::size_t at = 0; at + year <= source.size(); ++at) {
    const std::string_view word = std::string_view(source).substr(at, year);
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    if (std::ranges::all_of(word, is_digit)) return source.substr(0, at + year);
  }
  return source.substr(0, source.find_first_of(",:"));
}

Table study_table(const std::vector<FittedStudy>& studies) {
  const FittedStudy& first = studies.front();
  Table table;
  for (const auto& [name, value] : first.asked().given) table.columns.push_back(name);
  for (const std::string& name : first.fit.names) table.columns.push_back(name);
  for (const char* column : {"status", "digits", "rms error"}) table.columns.emplace_back(column);
  for (const std::string& column : last_columns(studies)) table.columns.push_back(column);
  const bool has_published =
      std::ranges::any_of(studies, [](const FittedStudy& study) { return !study.published.empty(); });
  if (has_published) table.columns.insert(table.columns.end(), {"published", "verdict"});
  for (const FittedStudy& study : studies) {
    std::vector<Cell>& row = table.rows.emplace_back();
    for (const auto& [name, value] : study.asked().given) row.emplace_back(value);
    for (std::size_t i = 0; i < study.fit.names.size(); ++i)
      row.push_back(is_answer(study) ? Cell(Number{study.fit.parameters[i], all_digits}) : Cell());
    row.emplace_back(status_of(study));
    if (is_answer(study)) {
      row.insert(row.end(), {study.fit.names.empty() ? Cell() : Cell(static_cast<long>(study.fit.digits)),
                             Number{study.fit.rms_error, 4}});
      for (const Cell& cell : last_cells(study)) row.push_back(cell);
    }
    row.resize(table.columns.size() - (has_published ? 2 : 0));
    if (has_published) {
      row.emplace_back(
          joined(study.published, "; ", [](const JudgedSet& j) { return equations(j.set.values); }));
      row.emplace_back(
          joined(study.published, "; ", [](const JudgedSet& j) { return verdict_text(j.judgement); }));
    }
  }
  return table;
}

std::string definition_text(const StudyDefinition& definition) {
  const std::string arguments =
      definition.arguments.empty() ? "" : fmt::format("({})", fmt::join(definition.arguments, ", "));
  return fmt::format("{}{} = {}", definition.name, arguments, definition.formula);
}

OthersText formulas_text(const Study& study) {
  return study.form + " ~ " + target_text(study) +
         joined(study.over, "", [](const StudyRange& range) { return ", " + range_text(range); });
}

OthersText study_headline(const FittedStudy& study) {
  const std::string weight = study.asked().weight == "1" ? "" : ", weight " + study.asked().weight;
  return formulas_text(study.asked()) + ", " + study.objective.words + weight +
         joined(study.read.bounds, "", [](const ParameterBounds& of) { return ", " + bounds_text(of); });
}

Table uncertainty_table(const std::vector<FittedStudy>& studies) {
  Table table;
  for (const auto& [name, value] : studies.front().asked().given) table.columns.push_back(name);
  for (const char* column : {"parameter", "value", "standard error", "profile from", "profile to"})
    table.columns.emplace_back(column);
  for (const FittedStudy& study : studies) {
    for (std::size_t i = 0; study.fit.statistics && i < study.fit.names.size(); ++i) {
      std::vector<Cell>& row = table.rows.emplace_back();
      for (const auto& [name, value] : study.asked().given) row.emplace_back(value);
      row.emplace_back(study.fit.names[i]);
      row.emplace_back(Number{study.fit.parameters[i], shown_digits});
      const std::vector<Cell> cells = cells_of(study, i);
      row.insert(row.end(), cells.begin(), cells.end());
    }
  }
  return table;
}

Table parameters_table(const FittedStudy& study) {
  constexpr std::size_t most_columns = 6;  // with more, a page is too narrow
  const std::vector<std::string>& names = study.fit.names;
  const bool has_errors = study.fit.statistics.has_value();
  Table table{{"parameter", "fitted"}};
  if (has_errors) table.columns.insert(table.columns.end(), {"standard error", "profile from", "profile to"});
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& row = table.rows.emplace_back(
        std::vector<Cell>{names[i], is_answer(study) ? Cell(converged(study.fit.parameters[i])) : Cell()});
    const std::vector<Cell> cells = has_errors ? cells_of(study, i) : std::vector<Cell>{};
    row.insert(row.end(), cells.begin(), cells.end());
  }
  return names.size() <= most_columns ? transposed(table) : table;
}

void add_uncertainty_columns(Table& table, const std::vector<FittedStudy>& studies) {
  for (const std::string& name : studies.front().fit.names) {
    table.columns.push_back("standard error of " + name);
    table.columns.push_back("profile of " + name + " from");
    table.columns.push_back("profile of " + name + " to");
  }
  for (std::size_t row = 0; row < studies.size(); ++row) {
    for (std::size_t i = 0; i < studies[row].fit.names.size(); ++i) {
      const std::vector<Cell> cells = cells_of(studies[row], i);
      table.rows[row].insert(table.rows[row].end(), cells.begin(), cells.end());
    }
  }
}

std::string uncertainty_text(const std::vector<FittedStudy>& studies) {
  const auto found = std::ranges::find_if(
      studies, [](const FittedStudy& study) { return study.fit.statistics.has_value(); });
  if (found == studies.end()) {
    const FittedStudy& first = studies.front();
    if (first.fit.names.empty()) return "";
    if (first.fit.status != Status::converged || first.fit.level) return "";
    if (!first.fit.at_bounds.empty()) return "No standard errors: a parameter is at its bound.\n";
    return first.read.rows->value.size() == first.fit.names.size()
               ? "No standard errors: there are as many rows as parameters.\n"
               : "No standard errors: the residuals are rounding.\n";
  }
  const RowStatistics& statistics = *found->fit.statistics;
  return fmt::format(
      "The standard errors follow from {}, with {} of freedom.\n"
      "Within a profile interval the sum of squares grows by at most {}.\n",
      statistics.is_absolute ? "sigma" : "the size s of the residuals",
      counted(static_cast<long>(statistics.freedom), "degree"), statistics.is_absolute ? "1" : "s^2");
}

nlohmann::ordered_json study_json(const std::vector<FittedStudy>& studies) {
  Json array = Json::array();
  for (const FittedStudy& study : studies) {
    Json over = Json::object();
    for (const StudyRange& range : study.asked().over)
      over[range.variable] = {{"range", {range.lower, range.upper}}, {"density", range.density}};
    for (const StudyAxis& axis : study.read.axes) {
      if (study.asked().rows)
        over[axis.variable] = {{"range", {to_text(axis.lower), to_text(axis.upper)}}, {"density", Json()}};
    }
    const bool has_answer = is_answer(study);
    const auto& rows = study.asked().rows;
    Json bounds = Json::object();
    for (const Held& at : study.fit.at_bounds) bounds[at.parameter] = at.value;
    array.push_back(
        {{"schema", fit_json_schema},
         {"target", rows ? Json() : Json(study.asked().target)},
         {"form", study.asked().form},
         {"over", over},
         {"given", json_object(study.asked().given)},
         {"norm", study.fit.level ? "minimax" : "least-squares"},
         {"error", name(study.asked().error)},
         {"weight", study.asked().weight},
         {"status", status_of(study)},
         {"why", study.fit.why.empty() ? Json() : Json(study.fit.why)},
         {"starts", study.fit.starts},
         {"global", study.fit.is_global},
         {"unique", has_answer ? Json(study.fit.is_unique) : Json()},
         {"parameters", has_answer ? json_object(study.fit.names, study.fit.parameters) : Json()},
         {"at_bounds", has_answer ? bounds : Json()},
         {"digits", has_answer ? Json(study.fit.digits) : Json()},
         {"rms_error", has_answer ? Json(study.fit.rms_error) : Json()},
         {"max_weighted_error", has_answer ? optional_json(study.fit.max_weighted_error) : Json()},
         {"max_abs_error", has_answer ? Json(study.fit.max_abs_error.magnitude) : Json()},
         {"at", has_answer ? place_json(study, study.fit.max_abs_error.at) : Json()},
         {"sampled", study.fit.is_sampled},
         {"level", has_answer ? optional_json(study.fit.level) : Json()},
         {"alternation", alternation_json(study)},
         {"published", published_json(study)}});
    if (rows) add_row_fields(array.back(), study);
  }
  return array;
}

}  // namespace shadefit
