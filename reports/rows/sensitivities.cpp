#include "reports/rows/sensitivities.hpp"

#include <fmt/format.h>

#include "reports/io/joined.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr int end_digits = 6;  ///< of an interval's end, which is found to nine

std::string objective_name(const Metric& metric) {
  const std::string error = metric.error == Error::relative ? "relative error" : "error";
  return (metric.norm == Norm::minimax ? "largest " : "rms ") + error +
         (metric.weight.empty() ? "" : " times the weight");
}

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

std::string common_text(const Names& names, const std::optional<CommonDigits>& common, double part,
                        double objective) {
  if (!common) return fmt::format("All constants within {}: no digits of a double do.\n", in_percent(part));
  return fmt::format("All constants within {}: {} digit{}, {}: worse by {:.2g} %\n", in_percent(part),
                     common->digits, common->digits == 1 ? "" : "s", equations(names, common->parameters),
                     objective > 0 ? 100 * (common->objective / objective - 1) : 0.0);
}

Json common_json(const Names& names, const std::optional<CommonDigits>& common) {
  if (!common) return {};
  return {{"digits", common->digits},
          {"parameters", json_object(names, common->parameters)},
          {"objective", common->objective}};
}

}  // namespace

std::string digits_text(const std::string& objective, const std::string& setting, const Names& names,
                        const Sensitivity& sensitivity, const Terminal& terminal) {
  return fmt::format("\nHow far the constants may move until the {}, {:.4g}, is worse by {} or {}{}:\n",
                     objective, sensitivity.objective, in_percent(noticeable), in_percent(slight), setting) +
         write_console(digits_table(sensitivity), Precision::report, terminal) +
         common_text(names, sensitivity.noticeable_digits, noticeable, sensitivity.objective) +
         common_text(names, sensitivity.slight_digits, slight, sensitivity.objective);
}

std::string sensitivity_text(const Fit& fit, const Sensitivity& sensitivity, const Terminal& terminal) {
  return digits_text(objective_name(fit.metric), fit.exponent ? fmt::format(", k = {}", *fit.exponent) : "",
                     fit.family->parameters, sensitivity, terminal) +
         "\n" +
         write_console(other_fits_table(fit.family->parameters, sensitivity.contracts,
                                        [](const Metric& metric) { return describe(metric); }),
                       Precision::report, terminal);
}

Json digits_json(const Names& names, const Sensitivity& sensitivity) {
  Json parameters = Json::object();
  for (const ParameterSensitivity& p : sensitivity.parameters) {
    parameters[p.parameter] = {{"within_1_percent", p.noticeable_digits},
                               {"within_0.1_percent", p.slight_digits},
                               {"profile_1_percent", {optional_json(p.lower), optional_json(p.upper)}}};
  }
  return {{"objective", sensitivity.objective},
          {"parameters", parameters},
          {"all_within_1_percent", common_json(names, sensitivity.noticeable_digits)},
          {"all_within_0.1_percent", common_json(names, sensitivity.slight_digits)}};
}

Json sensitivity_json(const Fit& fit, const Sensitivity& sensitivity) {
  Json json = digits_json(fit.family->parameters, sensitivity);
  json["contracts"] = Json::array();
  for (const auto& [metric, other] : sensitivity.contracts) {
    Json& contract =
        json["contracts"].emplace_back(Json{{"under", describe(metric)},
                                            {"measure", name(metric.measure)},
                                            {"domain", {metric.domain.lower, metric.domain.upper}}});
    add_answer_json(contract, fit.family->parameters, other);
  }
  return json;
}

}  // namespace shadefit
