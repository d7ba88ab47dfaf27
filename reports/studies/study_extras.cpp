#include "reports/studies/study_extras.hpp"

#include <fmt/format.h>

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

RoundedSets rounded_sets(const FittedStudy& study, bool is_one_of_several,
                         const std::function<RoundedStudy()>& round) {
  RoundedSets sets{.reason = "the fit did not converge",
                   .error = error_name(study.asked()),
                   .parameters = study.fit.names};
  for (const StudyRange& range : study.asked().over) sets.variables.push_back(range.variable);
  for (const auto& [constant, value] : study.asked().given) sets.given.emplace_back(constant, value);
  if (study.fit.status != Status::converged) return sets;
  try {
    sets.rounded = round();
    sets.reason.clear();
  } catch (const UserError& error) {
    if (!is_one_of_several) throw;
    sets.reason = error.what();
  }
  return sets;
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
