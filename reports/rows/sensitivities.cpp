#include "reports/rows/sensitivities.hpp"

#include <fmt/format.h>

#include "reports/rows/fit_json.hpp"
#include "reports/table/table.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr int end_digits = 6;  ///< of an interval's end, which is found to nine

Names names_of(const Fit& fit) {
  const auto names = find_family(fit.family->id)->parameters;
  return {names.begin(), names.end()};
}

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
               in_percent(noticeable) + " from", "to"},
              {}};
  for (const ParameterSensitivity& p : sensitivity.parameters) {
    table.rows.push_back(
        {p.parameter, converged(p.value), p.noticeable_digits, p.slight_digits, end(p.lower), end(p.upper)});
  }
  return table;
}

/// "a = -5.6, b = -6.9".
std::string named(const Names& names, const std::vector<std::string>& values) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < names.size(); ++i) parts.push_back(fmt::format("{} = {}", names[i], values[i]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string common_text(const Names& names, const std::optional<CommonDigits>& common, double part,
                        double objective) {
  if (!common) return fmt::format("All constants within {}: no digits of a double do.\n", in_percent(part));
  return fmt::format("All constants within {}: {} digit{}, {}: worse by {:.2g} %\n", in_percent(part),
                     common->digits, common->digits == 1 ? "" : "s", named(names, common->parameters),
                     objective > 0 ? 100 * (common->objective / objective - 1) : 0.0);
}

Table contracts_table(const Sensitivity& sensitivity) {
  Table table{{"the same form under"}, {}};
  for (const std::string_view parameter :
       find_family(sensitivity.contracts.front().fit.family->id)->parameters)
    table.columns.emplace_back(parameter);
  for (const char* column : {"rms error", "max abs error", "status"}) table.columns.emplace_back(column);
  for (const auto& [metric, fit] : sensitivity.contracts) {
    const bool is_answer = fit.status == Status::converged;
    const auto cell = [&](const Cell& value) { return is_answer ? value : Cell(); };
    std::vector<Cell> row{describe(metric)};
    for (const double p : fit.parameters) row.push_back(cell(converged(p)));
    row.insert(row.end(), {cell(Number{fit.rms_error, 4}), cell(Number{fit.max_abs_error.magnitude, 4}),
                           std::string(name(fit.status))});
    table.rows.push_back(row);
  }
  return table;
}

Json common_json(const Names& names, const std::optional<CommonDigits>& common) {
  if (!common) return {};
  Json parameters = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) parameters[names[i]] = common->parameters[i];
  return {{"digits", common->digits}, {"parameters", parameters}, {"objective", common->objective}};
}

Json contract_json(const OtherContract& contract) {
  const auto& [metric, fit] = contract;
  const bool is_answer = fit.status == Status::converged;
  const auto names = find_family(fit.family->id)->parameters;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i)
    parameters[std::string(names[i])] = is_answer ? Json(fit.parameters[i]) : Json();
  return {{"under", describe(metric)},
          {"measure", name(metric.measure)},
          {"domain", {metric.domain.lower, metric.domain.upper}},
          {"status", name(fit.status)},
          {"parameters", parameters},
          {"rms_error", is_answer ? Json(fit.rms_error) : Json()},
          {"max_abs_error", is_answer ? Json(fit.max_abs_error.magnitude) : Json()}};
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
                     names_of(fit), sensitivity, terminal) +
         "\n" + write_console(contracts_table(sensitivity), Precision::report, terminal);
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
  Json json = digits_json(names_of(fit), sensitivity);
  Json contracts = Json::array();
  for (const OtherContract& contract : sensitivity.contracts) contracts.push_back(contract_json(contract));
  json["contracts"] = contracts;
  return json;
}

}  // namespace shadefit
