#include "reports/studies/study_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reports/io/joined.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// "a = 1.5707963, b = -0.156583": as printed. Of a fit ten digits, or six where it has fewer. Nothing
/// between: how many it has varies by one with the libraries.
std::string constants_text(const StudyContender& contender) {
  if (!contender.printed.empty()) return equations(contender.names, contender.printed);
  return equations(contender.names, contender.values, [&](double value) {
    const Number number = converged(value);
    return text(contender.digits < number.digits ? Number{value, 6} : number, Precision::report);
  });
}

OthersText origin_of(const StudyContender& contender) {
  return contender.published != nullptr ? short_source(contender.origin) : contender.origin;
}

std::string_view short_name(StatedError error) {
  constexpr std::array<std::string_view, stated_errors.size()> names{
      "", " relative", " mean", " mean relative", " rms", " mean square"};
  return names.at(static_cast<std::size_t>(error));
}

std::string claim_text(const StudyContender& contender) {
  return joined(contender.claims, "; ", [](const JudgedError& judged) {
    return fmt::format("{}{}{}: {}", judged.claim.printed, short_name(judged.claim.error),
                       ranges_text(judged.claim.over), name(judged.verdict));
  });
}

Json ranges_json(const ErrorClaim& claim) {
  Json ranges = Json::object();
  for (const StudyRange& range : claim.over) ranges[range.variable] = {range.lower, range.upper};
  return ranges;
}

/// These cells, and then those of a contender that tables share: from its form to what it beats.
std::vector<Cell> with_contender(std::vector<Cell> cells, const StudyContender& contender) {
  cells.insert(cells.end(), {contender.form, constants_text(contender), origin_of(contender),
                             Number{contender.max_error.magnitude, 4}});
  for (const double x : contender.max_error.at) cells.push_back(Number{x, 4});
  cells.insert(cells.end(),
               {to_text(contender.operations), static_cast<long>(contender.operations.total()),
                contender.judgement ? verdict_text(*contender.judgement) : "", claim_text(contender),
                joined(contender.beats, ", ", [](std::size_t place) { return fmt::to_string(place + 1); })});
  return cells;
}

std::vector<std::string> with_columns_of(std::vector<std::string> columns,
                                         const StudyComparison& comparison) {
  columns.insert(columns.end(), {"form", "constants", "from", error_in_words(comparison.error)});
  for (const std::string& variable : comparison.variables) columns.push_back("at " + variable);
  columns.insert(columns.end(), {"operations", "instructions", "verdict", "claimed error", "beats"});
  return columns;
}

std::size_t place_of(const StudyComparison& comparison, const StudyContender& contender) {
  return static_cast<std::size_t>(&contender - comparison.contenders.data());
}

/// "2.11 times as accurate as row 1".
std::string gain_text(const StudyComparison& comparison, const StudyContender& published,
                      const StudyContender& better) {
  const std::size_t row = place_of(comparison, published) + 1;
  const double least = better.max_error.magnitude;
  if (least < rounding_alone) return fmt::format("exact, unlike row {}", row);
  return fmt::format("{} times as accurate as row {}", in_digits(published.max_error.magnitude / least, 3),
                     row);
}

std::string cost_text(const StudyContender& published, const StudyContender& better) {
  const int before = published.operations.total(), now = better.operations.total();
  return now == before ? "same cost" : fmt::format("{} instead of {} instructions", now, before);
}

/// The table without the columns that have nothing to say.
Table without_empty_columns(const Table& table) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto has_text = [&](const auto& row) { return !text(row[i], Precision::report).empty(); };
    if (std::ranges::any_of(table.rows, has_text)) shown.push_back(i);
  }
  return columns_of(table, shown);
}

}  // namespace

std::string ranges_text(const std::vector<StudyRange>& ranges) {
  return joined(ranges, "", [](const StudyRange& range) {
    return fmt::format(", {} in {}:{}", range.variable, range.lower, range.upper);
  });
}

std::string error_in_words(std::string_view key) {
  std::string words(key);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string curve_in_words(std::string_view key) {
  return key == "max_abs_error"   ? "form − target"
         : key == "max_rel_error" ? "relative error"
                                  : "weighted error";
}

OthersText target_of(const StudyComparison& comparison) {
  const Study& study = comparison.study;
  const std::string given = given_text(study);
  const OthersText target = study.rows ? study.rows->file : study.target + ranges_text(study.over);
  return target + (given.empty() ? "" : ", " + given);
}

std::string advice_text(const StudyComparison& comparison, const std::string& command) {
  const StudyContender* published = first_published(comparison);
  if (published == nullptr) return "";
  const StudyContender* best = better_at_the_same_cost(comparison, *published);
  const StudyContender* least = least_error_at_the_same_cost(comparison, *published);
  std::string text =
      best == nullptr
          ? fmt::format("Keep row {}: no set here errs less at no more cost{}\n",
                        place_of(comparison, *published) + 1,
                        least == nullptr ? "" : " and keeps its properties")
          : fmt::format("Use this: row {}, {}, {}{}: {}\n", place_of(comparison, *best) + 1,
                        gain_text(comparison, *published, *best), cost_text(*published, *best),
                        published->properties.empty() ? "" : ", keeps all its properties", command);
  if (least != best)
    text += fmt::format("The smallest error at that cost: row {}, {}, but it loses: {}\n",
                        place_of(comparison, *least) + 1, gain_text(comparison, *published, *least),
                        to_text(lost_properties(published->properties, least->properties)));
  return text;
}

Table study_comparison_table(const StudyComparison& comparison) {
  Table table{with_columns_of({"row"}, comparison)};
  for (std::size_t i = 0; i < comparison.contenders.size(); ++i)
    table.rows.push_back(with_contender({static_cast<long>(i + 1)}, comparison.contenders[i]));
  return without_empty_columns(table);
}

Table study_comparisons_table(const std::vector<StudyComparison>& comparisons) {
  Table table{with_columns_of({"name", "curve"}, comparisons.front())};
  for (const StudyComparison& comparison : comparisons) {
    for (const StudyContender& contender : comparison.contenders) {
      const OthersText curve = contender.form + ", " + origin_of(contender);
      table.rows.push_back(with_contender({given_text(comparison.study), curve}, contender));
    }
  }
  return table;
}

Json study_comparison_json(const StudyComparison& comparison) {
  Json contenders = Json::array();
  for (const StudyContender& contender : comparison.contenders) {
    const auto& judgement = contender.judgement;
    const StudyContender* best =
        contender.published != nullptr ? better_at_the_same_cost(comparison, contender) : nullptr;
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
         {"parameters", json_object(contender.names, contender.values)},
         {"printed", contender.printed.empty() ? Json() : json_object(contender.names, contender.printed)},
         {comparison.error, contender.max_error.magnitude},
         {"at", json_object(comparison.variables, contender.max_error.at)},
         {"operations", to_text(contender.operations)},
         {"instructions", contender.operations.total()},
         {"verdict", judgement ? Json(name(judgement->verdict)) : Json()},
         {"objective", judgement && !judgement->objective.empty() ? Json(judgement->objective) : Json()},
         {"fits_tried", judgement ? Json(judgement->tried) : Json()},
         {"chance_hits", judgement ? Json(judgement->chance) : Json()},
         {"compared_digits", judgement ? optional_json(judgement->compared_digits) : Json()},
         {"units_off", judgement ? Json(judgement->units_off) : Json()},
         {"claims", claims},
         {"beats", contender.beats},
         {"best", best != nullptr ? Json(place_of(comparison, *best)) : Json()}});
  }
  return {{"target", comparison.study.target},
          {"given", json_object(comparison.study.given)},
          {"contenders", contenders},
          {"left_out", comparison.left_out}};
}

}  // namespace shadefit
