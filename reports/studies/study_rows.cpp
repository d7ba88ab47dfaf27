#include "reports/studies/study_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fit/scalars/symbolic.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

bool is_answer(const FittedStudy& study) {
  return study.fit.status == Status::converged;
}

std::string range_text(const StudyRange& range) {
  const std::string text = fmt::format("{} in {}:{}", range.variable, range.lower, range.upper);
  return range.density == "1" ? text : fmt::format("{}, density {}", text, range.density);
}

Json parameters_json(const FittedStudy& study, const std::vector<double>& values) {
  Json object = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) object[study.fit.names[i]] = values[i];
  return object;
}

Json alternation_json(const FittedStudy& study) {
  Json points = Json::array();
  for (const AlternationPoint& point : study.fit.alternation)
    points.push_back({{study.read.axes.front().variable, point.at.cos_theta}, {"error", point.error}});
  return points;
}

Json place_json(const FittedStudy& study) {
  Json object = Json::object();
  for (std::size_t i = 0; i < study.fit.max_abs_error.at.size(); ++i)
    object[study.read.axes[i].variable] = study.fit.max_abs_error.at[i];
  return object;
}

Json published_json(const FittedStudy& study) {
  Json array = Json::array();
  for (const auto& [set, judgement] : study.published) {
    Json values = Json::object();
    for (const auto& [name, text] : set.values) values[name] = text;
    array.push_back({{"values", values},
                     {"source", set.source},
                     {"verdict", name(judgement.verdict)},
                     {"objective", judgement.objective.empty() ? Json() : Json(judgement.objective)}});
  }
  return array;
}

/// The texts of all sets, one after the other.
template <class Text>
std::string of_all_sets(const FittedStudy& study, const Text& text) {
  std::vector<std::string> texts;
  for (const JudgedSet& judged : study.published) texts.push_back(text(judged));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::string verdict_text(const StudyJudgement& judgement) {
  const std::string verdict(name(judgement.verdict));
  return judgement.verdict == Verdict::other_objective ? verdict + ": " + judgement.objective : verdict;
}

std::string short_source(const std::string& source) {
  constexpr std::size_t year = 4;
  for (std::size_t at = 0; at + year <= source.size(); ++at) {
    const std::string_view word = std::string_view(source).substr(at, year);
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    if (std::all_of(word.begin(), word.end(), is_digit)) return source.substr(0, at + year);
  }
  return source.substr(0, source.find_first_of(",:"));
}

std::string printed_text(const PrintedValues& values) {
  std::vector<std::string> texts;
  for (const auto& [name, text] : values) texts.push_back(name + " = " + text);
  return fmt::format("{}", fmt::join(texts, ", "));
}

Table study_table(const std::vector<FittedStudy>& studies) {
  const FittedStudy& first = studies.front();
  Table table;
  for (const auto& [name, value] : first.asked.given) table.columns.push_back(name);
  for (const std::string& name : first.fit.names) table.columns.push_back(name);
  for (const char* column : {"status", "digits", "rms error", "max abs error"})
    table.columns.emplace_back(column);
  for (const StudyAxis& axis : first.read.axes) table.columns.push_back("at " + axis.variable);
  const bool has_published = std::any_of(studies.begin(), studies.end(),
                                         [](const FittedStudy& study) { return !study.published.empty(); });
  if (has_published) table.columns.insert(table.columns.end(), {"published", "verdict"});
  for (const FittedStudy& study : studies) {
    std::vector<Cell> row;
    for (const auto& [name, value] : study.asked.given) row.emplace_back(value);
    for (const double p : study.fit.parameters)
      row.push_back(is_answer(study) ? Cell(Number{p, all_digits}) : Cell());
    row.emplace_back(std::string(name(study.fit.status)));
    row.push_back(is_answer(study) ? Cell(static_cast<long>(study.fit.digits)) : Cell());
    row.push_back(is_answer(study) ? Cell(Number{study.fit.rms_error, 4}) : Cell());
    row.push_back(is_answer(study) ? Cell(Number{study.fit.max_abs_error.magnitude, 4}) : Cell());
    for (std::size_t i = 0; i < study.read.axes.size(); ++i)
      row.push_back(is_answer(study) ? Cell(Number{study.fit.max_abs_error.at[i], 6}) : Cell());
    if (has_published) {
      row.emplace_back(of_all_sets(study, [](const JudgedSet& j) { return printed_text(j.set.values); }));
      row.emplace_back(of_all_sets(study, [](const JudgedSet& j) { return verdict_text(j.judgement); }));
    }
    table.rows.push_back(row);
  }
  return table;
}

std::string study_headline(const FittedStudy& study) {
  std::string over;
  for (const StudyRange& range : study.asked.over) over += ", " + range_text(range);
  const bool is_relative = study.asked.error == Error::relative;
  const std::string weight = study.asked.weight == "1" ? "" : ", weight " + study.asked.weight;
  return fmt::format("{} ~ {}{}, {}{}{}", study.asked.form, study.asked.target, over,
                     study.fit.level ? "minimax" : "least squares", is_relative ? ", relative error" : "",
                     weight);
}

std::string level_text(const FittedStudy& study) {
  if (!study.fit.level || !is_answer(study)) return "";
  std::string text = fmt::format("Level {:.10g}, the error is", *study.fit.level);
  const std::string& variable = study.read.axes.front().variable;
  for (std::size_t i = 0; i < study.fit.alternation.size(); ++i) {
    const AlternationPoint& point = study.fit.alternation[i];
    text += fmt::format("{} {} at {} = {:.6g}", i == 0 ? "" : ",", point.error < 0 ? "-" : "+", variable,
                        point.at.cos_theta);
  }
  return text + "\n";
}

nlohmann::ordered_json study_json(const std::vector<FittedStudy>& studies) {
  Json array = Json::array();
  for (const FittedStudy& study : studies) {
    Json over = Json::object(), given = Json::object();
    for (const StudyRange& range : study.asked.over)
      over[range.variable] = {{"range", {range.lower, range.upper}}, {"density", range.density}};
    for (const auto& [name, value] : study.asked.given) given[name] = value;
    const bool has_answer = is_answer(study);
    array.push_back({{"target", study.asked.target},
                     {"form", study.asked.form},
                     {"over", over},
                     {"given", given},
                     {"norm", study.fit.level ? "minimax" : "least-squares"},
                     {"error", name(study.asked.error)},
                     {"weight", study.asked.weight},
                     {"status", name(study.fit.status)},
                     {"why", study.fit.why.empty() ? Json() : Json(study.fit.why)},
                     {"starts", study.fit.starts},
                     {"global", study.fit.is_global},
                     {"parameters", has_answer ? parameters_json(study, study.fit.parameters) : Json()},
                     {"digits", has_answer ? Json(study.fit.digits) : Json()},
                     {"rms_error", has_answer ? Json(study.fit.rms_error) : Json()},
                     {"max_abs_error", has_answer ? Json(study.fit.max_abs_error.magnitude) : Json()},
                     {"at", has_answer ? place_json(study) : Json()},
                     {"level", has_answer && study.fit.level ? Json(*study.fit.level) : Json()},
                     {"alternation", alternation_json(study)},
                     {"published", published_json(study)}});
  }
  return array;
}

}  // namespace shadefit
