#include "reports/rows/rounded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fit/scalars/rounded_interval.hpp"
#include "fit/support/hex_float.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

Json constants_json(const Family& family, const RoundedStudySet& constants, Error error) {
  return {{"parameters", json_object(family.parameters, constants.values)},
          {"decimal", json_object(family.parameters, constants.texts)},
          {"hex", json_object(family.parameters, constants.values, hex_text)},
          {error == Error::relative ? "max_rel_error" : "max_abs_error", constants.max_error},
          {"at", constants.at.front()},
          {"real_error", optional_json(constants.real_error)},
          {"rounding_error", optional_json(constants.rounding_error)},
          {"srgb_codes", optional_json(constants.srgb_codes)},
          {"gpu_bound", optional_json(constants.gpu_bound)}};
}

std::string_view short_name(Error error) {
  return error == Error::relative ? "rel" : "abs";
}

std::vector<Cell> row_of(const std::string_view name, const RoundedStudySet& constants) {
  std::vector<Cell> row{std::string(name)};
  for (std::size_t i = 0; i < constants.values.size(); ++i) {
    row.emplace_back(constants.texts[i]);
    row.emplace_back(hex_text(constants.values[i]));
  }
  row.push_back(at_most(constants.max_error));
  row.emplace_back(Number{constants.at.front(), 6});
  for (const auto& bound : {constants.gpu_bound, constants.srgb_codes})
    row.push_back(bound ? at_most(*bound) : Cell());
  return row;
}

}  // namespace

std::string meaning_of_error(const RoundedStudy& rounded) {
  if (!rounded.best.real_error)
    return "every operation rounded, at every " + to_text(rounded.format) + " of the range";
  if (!rounded.best.rounding_error) return "proven, of the form in real numbers";
  return "a proven bound: of the form in real numbers, and of the rounding of each operation in float";
}

Cell at_most(double bound, int digits) {
  if (!(bound > 0) || !std::isfinite(bound)) return Number{bound, digits};
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - (digits - 1));
  return Number{std::ceil(bound / unit) * unit, digits};
}

std::string each_once(const std::vector<std::string>& sentences) {
  std::string text;
  for (auto sentence = sentences.begin(); sentence != sentences.end(); ++sentence) {
    if (std::find(sentences.begin(), sentence, *sentence) == sentence) text += *sentence + "\n";
  }
  return text;
}

Table rounded_table(const Refit& refit, const std::vector<RoundedFit>& fits) {
  const Family& family = *refit.family;
  Table table;
  if (family.has_exponent()) table.columns.emplace_back("exponent");
  table.columns.emplace_back("constants");
  for (const std::string_view parameter : family.parameters) {
    table.columns.emplace_back(parameter);
    table.columns.push_back(std::string(parameter) + " hex");
  }
  const Error error = refit.fits.front().fit.metric.error;
  table.columns.push_back(fmt::format("max {} error", short_name(error)));
  for (const char* column : {"at c", "on a GPU at most", "8-bit sRGB codes"})
    table.columns.emplace_back(column);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].rounded) continue;
    const RoundedStudy& rounded = *fits[i].rounded;
    const auto add = [&](std::string_view name, const RoundedStudySet& constants) {
      auto& row = table.rows.emplace_back(row_of(name, constants));
      if (family.has_exponent()) row.insert(row.begin(), Number{*refit.fits[i].fit.exponent, all_digits});
    };
    add(rounded.is_proven ? "best" : "best found", rounded.best);
    add("fitted, rounded", rounded.naive);
    if (rounded.published) add("published, rounded", *rounded.published);
  }
  return table;
}

std::string rounded_text(const std::vector<RoundedFit>& fits, Error error) {
  std::vector<std::string> said;
  for (const RoundedFit& fit : fits) {
    if (!fit.rounded) {
      said.push_back(fmt::format("Not rounded: {}.", fit.reason));
      continue;
    }
    const RoundedStudy& rounded = *fit.rounded;
    said.push_back(fmt::format("Max {} error: {}.", short_name(error), meaning_of_error(rounded)));
    if (rounded.best.gpu_bound) said.push_back(fmt::format("On a GPU: {}.", gpu_assumption));
    said.push_back(
        meaning_of_best(rounded, rounded.format.is_narrow() ? "" : " by their error in real numbers"));
  }
  return each_once(said);
}

void add_rounded_json(Json& fit_json, const Family& family, const RoundedFit& fit, Error error) {
  if (!fit.rounded) {
    fit_json["rounded"] = nullptr;
    fit_json["rounded_reason"] = fit.reason;
    return;
  }
  const RoundedStudy& rounded = *fit.rounded;
  const auto json_of = [&](const RoundedStudySet& constants) {
    return constants_json(family, constants, error);
  };
  Json json{{"format", to_text(rounded.format)}, {"error", name(error)}};
  json.update(json_of(rounded.best));
  json["naive"] = json_of(rounded.naive);
  json["published"] = rounded.published ? json_of(*rounded.published) : Json();
  json["proven"] = rounded.is_proven;
  json["searched"] = rounded.searched;
  json["tried"] = rounded.evaluated;
  json["error_is"] = meaning_of_error(rounded);
  json["gpu_model"] = rounded.best.gpu_bound ? Json(gpu_assumption) : Json();
  fit_json["rounded"] = json;
}

}  // namespace shadefit
