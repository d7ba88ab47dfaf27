#include "reports/studies/study_extras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fit/scalars/gpu_model.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/joined.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

std::string error_name(const Study& study) {
  return fmt::format("max {}{} error", study.weight == "1" ? "" : "weighted ",
                     study.error == Error::relative ? "rel" : "abs");
}

/// The sets of a rounding, each with what it is.
std::vector<std::pair<const char*, const RoundedStudySet*>> sets_of(const RoundedStudy& rounded) {
  std::vector<std::pair<const char*, const RoundedStudySet*>> sets{
      {rounded.is_proven ? "best" : "best found", &rounded.best}, {"fitted, rounded", &rounded.naive}};
  if (rounded.published) sets.emplace_back("published, rounded", &*rounded.published);
  return sets;
}

/// Appends a column of optional bounds; not one without any.
void add_bounds(Table& table, const std::string& column, const std::vector<std::optional<double>>& bounds) {
  if (std::ranges::none_of(bounds, [](const auto& bound) { return bound.has_value(); })) return;
  table.columns.push_back(column);
  for (std::size_t i = 0; i < bounds.size(); ++i)
    table.rows[i].push_back(bounds[i] ? at_most(*bounds[i]) : Cell());
}

Json set_json(const FittedStudy& study, const RoundedStudySet& set) {
  const std::vector<std::string>& names = study.fit.names;
  Json at = Json::object();
  for (std::size_t i = 0; i < set.at.size(); ++i) at[study.asked().over[i].variable] = set.at[i];
  return {{"parameters", json_object(names, set.values)},
          {"decimal", json_object(names, set.texts)},
          {"hex", json_object(names, set.values, hex_text)},
          {"max_error", set.max_error},
          {"at", at},
          {"real_error", optional_json(set.real_error)},
          {"rounding_error", optional_json(set.rounding_error)},
          {"srgb_codes", optional_json(set.srgb_codes)},
          {"gpu_bound", optional_json(set.gpu_bound)}};
}

/// The meaning of `max_error` of rounded constants.
std::string meaning_of_error(const RoundedStudy& rounded) {
  if (!rounded.best.real_error)
    return "every operation rounded, at every " + to_text(rounded.format) + " of the range";
  if (!rounded.best.rounding_error) return "proven, of the form in real numbers";
  return "a proven bound: of the form in real numbers, and of the rounding of each operation in float";
}

/// The meaning of "best", and by which error, if need be.
std::string meaning_of_best(const RoundedStudy& rounded) {
  const char* by = rounded.best.rounding_error ? " by their error in real numbers" : "";
  if (rounded.is_proven) return fmt::format("Best: proven, among {}{}.", rounded.searched, by);
  return fmt::format("Best found{}: of {} constants tried among {}, not proven.", by, rounded.evaluated,
                     rounded.searched);
}

Table roundings_table(const std::vector<FittedStudy>& studies, const std::vector<RoundedFit>& all) {
  const FittedStudy& first = studies.front();
  Table table;
  for (const auto& [constant, value] : first.asked().given) table.columns.push_back(constant);
  table.columns.emplace_back("constants");
  for (const std::string& parameter : first.fit.names) {
    table.columns.push_back(parameter);
    table.columns.push_back(parameter + " hex");
  }
  table.columns.push_back(error_name(first.asked()));
  for (const StudyRange& range : first.asked().over) table.columns.push_back("at " + range.variable);
  std::vector<std::optional<double>> on_gpu, codes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].rounded) continue;
    for (const auto& [what, set] : sets_of(*all[i].rounded)) {
      std::vector<Cell>& row = table.rows.emplace_back();
      for (const auto& [constant, value] : studies[i].asked().given) row.emplace_back(value);
      row.emplace_back(what);
      for (std::size_t k = 0; k < set->values.size(); ++k)
        row.insert(row.end(), {set->texts[k], hex_text(set->values[k])});
      row.push_back(at_most(set->max_error));
      for (std::size_t k = 0; k < first.asked().over.size(); ++k)
        row.push_back(set->at.empty() ? Cell() : Number{set->at[k], 6});
      on_gpu.push_back(set->gpu_bound);
      codes.push_back(set->srgb_codes);
    }
  }
  add_bounds(table, "on a GPU at most", on_gpu);
  add_bounds(table, "8-bit sRGB codes", codes);
  return table;
}

std::string objective_name(const FittedStudy& study) {
  return std::string(study.fit.level ? "largest " : "rms ") +
         (study.asked().error == Error::relative ? "relative error" : "error") +
         (study.asked().weight == "1" ? "" : " times the weight");
}

constexpr int end_digits = 6;  ///< of an interval's end, which is found to nine

std::string in_percent(double part) {
  return fmt::format("{:g} %", 100 * part);
}

Cell end(const std::optional<double>& value) {
  return value ? Cell(Number{*value, end_digits}) : Cell();
}

Table digits_table(const Sensitivity& sensitivity) {
  Table table{{"constant", "optimum", "within " + in_percent(noticeable), "within " + in_percent(slight),
               in_percent(noticeable) + " from", "to"}};
  for (const ParameterSensitivity& p : sensitivity.parameters) {
    table.rows.push_back(
        {p.parameter, converged(p.value), p.noticeable_digits, p.slight_digits, end(p.lower), end(p.upper)});
  }
  return table;
}

std::string common_text(const std::vector<std::string>& names, const std::optional<CommonDigits>& common,
                        double part, double objective) {
  if (!common) return fmt::format("All constants within {}: no digits of a double do.\n", in_percent(part));
  return fmt::format("All constants within {}: {} digit{}, {}: worse by {:.2g} %\n", in_percent(part),
                     common->digits, common->digits == 1 ? "" : "s", equations(names, common->parameters),
                     objective > 0 ? 100 * (common->objective / objective - 1) : 0.0);
}

Json common_json(const std::vector<std::string>& names, const std::optional<CommonDigits>& common) {
  if (!common) return {};
  return {{"digits", common->digits},
          {"parameters", json_object(names, common->parameters)},
          {"objective", common->objective}};
}

/// The same form under other objectives.
Table others_table(const std::vector<std::string>& names, const std::vector<OtherFit>& others) {
  Table table{{"the same form under"}};
  table.columns.insert(table.columns.end(), names.begin(), names.end());
  table.columns.insert(table.columns.end(), {"rms error", "max abs error", "status"});
  for (const auto& [objective, fit] : others) {
    const bool is_answer = fit.status == Status::converged;
    const auto cell = [&](const Number& value) { return is_answer ? Cell(value) : Cell(); };
    auto& row = table.rows.emplace_back(std::vector<Cell>{objective});
    for (const double p : fit.parameters) row.push_back(cell(converged(p)));
    row.insert(row.end(), {cell(Number{fit.rms_error, 4}), cell(Number{fit.max_abs_error.magnitude, 4}),
                           std::string(name(fit.status))});
  }
  return table;
}

Json other_json(const std::vector<std::string>& names, const OtherFit& other) {
  const auto& [under, fit] = other;
  const bool is_answer = fit.status == Status::converged;
  const auto answer = [&](const Json& value) { return is_answer ? value : nullptr; };
  return {{"under", under},
          {"status", name(fit.status)},
          {"parameters",
           json_object(names, is_answer ? fit.parameters : std::vector<double>(names.size()), answer)},
          {"rms_error", answer(fit.rms_error)},
          {"max_abs_error", answer(fit.max_abs_error.magnitude)}};
}

}  // namespace

Cell at_most(double bound, int digits) {
  if (!(bound > 0) || !std::isfinite(bound)) return Number{bound, digits};
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - (digits - 1));
  return Number{std::ceil(bound / unit) * unit, digits};
}

RoundedFit rounded_fit(const FittedStudy& study, bool is_one_of_several,
                       const std::function<RoundedStudy()>& round) {
  if (study.fit.status != Status::converged) return {{}, "the fit did not converge"};
  try {
    return {round(), ""};
  } catch (const UserError& error) {
    if (!is_one_of_several) throw;
    return {{}, error.what()};
  }
}

std::string roundings_text(const std::vector<FittedStudy>& studies, const std::vector<RoundedFit>& all,
                           const Terminal& terminal) {
  std::vector<std::string> said;
  for (const RoundedFit& of : all) {
    if (!of.rounded) {
      if (!of.reason.empty()) said.push_back(fmt::format("Not rounded: {}.", of.reason));
      continue;
    }
    const RoundedStudy& rounded = *of.rounded;
    said.push_back(fmt::format("Max error: {}.", meaning_of_error(rounded)));
    if (rounded.best.gpu_bound) said.push_back(fmt::format("On a GPU: {}.", gpu_assumption));
    said.push_back(meaning_of_best(rounded));
  }
  std::string text = "\n" + write_console(roundings_table(studies, all), Precision::report, terminal);
  // A sentence that was said before is not said again.
  for (auto sentence = said.begin(); sentence != said.end(); ++sentence)
    if (std::find(said.begin(), sentence, *sentence) == sentence) text += *sentence + "\n";
  return text;
}

void add_rounding(Json& fit, const std::string& key, const FittedStudy& study, const RoundedFit& of) {
  Json& json = fit[key];
  if (!of.rounded) {
    fit[key + "_reason"] = of.reason;
    return;
  }
  const RoundedStudy& rounded = *of.rounded;
  json = {{"format", to_text(rounded.format)}};
  json.update(set_json(study, rounded.best));
  json["naive"] = set_json(study, rounded.naive);
  json["published"] = rounded.published ? set_json(study, *rounded.published) : Json();
  json["proven"] = rounded.is_proven;
  json["searched"] = rounded.searched;
  json["tried"] = rounded.evaluated;
  json["error_is"] = meaning_of_error(rounded);
  json["gpu_model"] = rounded.best.gpu_bound ? Json(gpu_assumption) : Json();
}

std::string sensitivity_text(const FittedStudy& study, const Sensitivity& sensitivity,
                             const Terminal& terminal) {
  const std::string given = given_text(study.asked());
  const std::vector<std::string>& names = study.fit.names;
  std::string text =
      fmt::format("\nHow far the constants may move until the {}, {:.4g}, is worse by {} or {}{}:\n",
                  objective_name(study), sensitivity.objective, in_percent(noticeable), in_percent(slight),
                  given.empty() ? "" : ", " + given) +
      write_console(digits_table(sensitivity), Precision::report, terminal) +
      common_text(names, sensitivity.noticeable_digits, noticeable, sensitivity.objective) +
      common_text(names, sensitivity.slight_digits, slight, sensitivity.objective);
  if (!sensitivity.others.empty())
    text += "\n" + write_console(others_table(names, sensitivity.others), Precision::report, terminal);
  return text;
}

Json sensitivity_json(const FittedStudy& study, const Sensitivity& sensitivity) {
  const std::vector<std::string>& names = study.fit.names;
  Json parameters = Json::object();
  for (const ParameterSensitivity& p : sensitivity.parameters) {
    parameters[p.parameter] = {{"within_1_percent", p.noticeable_digits},
                               {"within_0.1_percent", p.slight_digits},
                               {"profile_1_percent", {optional_json(p.lower), optional_json(p.upper)}}};
  }
  return {{"objective", sensitivity.objective},
          {"parameters", parameters},
          {"all_within_1_percent", common_json(names, sensitivity.noticeable_digits)},
          {"all_within_0.1_percent", common_json(names, sensitivity.slight_digits)},
          {"contracts",
           json_array(sensitivity.others, [&](const OtherFit& other) { return other_json(names, other); })}};
}

}  // namespace shadefit
