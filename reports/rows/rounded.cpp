#include "reports/rows/rounded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "fit/scalars/rounded_interval.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

Json constants_json(const FittableFamily& family, const RoundedConstants& constants, Error error) {
  Json parameters, decimals, hexes;
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    const std::string parameter(family.parameters[i]);
    parameters[parameter] = constants.parameters[i];
    decimals[parameter] = constants.texts[i];
    hexes[parameter] = hex_text(constants.parameters[i]);
  }
  return {{"parameters", parameters},
          {"decimal", decimals},
          {"hex", hexes},
          {error == Error::relative ? "max_rel_error" : "max_abs_error", constants.max_error},
          {"at", constants.at},
          {"real_error", optional_json(constants.real_error)},
          {"rounding_error", optional_json(constants.rounding_error)},
          {"srgb_codes", optional_json(constants.srgb_codes)},
          {"gpu_bound", optional_json(constants.gpu_bound)}};
}

std::string_view short_name(Error error) {
  return error == Error::relative ? "rel" : "abs";
}

std::vector<Cell> row_of(const std::string_view name, const RoundedConstants& constants) {
  std::vector<Cell> row{std::string(name)};
  for (std::size_t i = 0; i < constants.parameters.size(); ++i) {
    row.emplace_back(constants.texts[i]);
    row.emplace_back(hex_text(constants.parameters[i]));
  }
  row.push_back(at_most(constants.max_error));
  row.emplace_back(Number{constants.at, 6});
  for (const auto& bound : {constants.gpu_bound, constants.srgb_codes})
    row.push_back(bound ? at_most(*bound) : Cell());
  return row;
}

/// The meaning of `max error`.
std::string meaning_of_error(const NumberFormat& format) {
  switch (format.kind) {
    case NumberFormat::Kind::half:
    case NumberFormat::Kind::bfloat16:
      return "every operation rounded, at every " + to_text(format) + " of the domain";
    case NumberFormat::Kind::single:
      return "a proven bound: of the form in real numbers, and of the rounding of each operation in float";
    case NumberFormat::Kind::decimal:
      break;
  }
  return "a proven bound: of the form in real numbers, and of the rounding of each operation in double";
}

/// The meaning of "best".
std::string meaning_of_best(const Rounded& rounded) {
  const std::string by = rounded.format.is_narrow() ? "" : " by their error in real numbers";
  if (rounded.is_proven) return fmt::format("Best: proven, among {}{}.", rounded.searched, by);
  return fmt::format("Best found{}: of {} constants tried among {}, not proven.", by, rounded.evaluated,
                     rounded.searched);
}

}  // namespace

Cell at_most(double bound, int digits) {
  if (!(bound > 0) || !std::isfinite(bound)) return Number{bound, digits};
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - (digits - 1));
  return Number{std::ceil(bound / unit) * unit, digits};
}

Table rounded_table(const Refit& refit, const std::vector<RoundedFit>& fits) {
  const FittableFamily& family = *refit.family;
  Table table;
  if (family.has_exponent()) table.columns.emplace_back("exponent");
  table.columns.emplace_back("constants");
  for (const std::string_view parameter : family.parameters) {
    table.columns.emplace_back(parameter);
    table.columns.push_back(std::string(parameter) + " hex");
  }
  const auto first =
      std::find_if(fits.begin(), fits.end(), [](const auto& f) { return f.rounded.has_value(); });
  const Error error = first == fits.end() ? Error::absolute : first->rounded->error;
  table.columns.push_back(fmt::format("max {} error", short_name(error)));
  for (const char* column : {"at c", "on a GPU at most", "8-bit sRGB codes"})
    table.columns.emplace_back(column);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].rounded) continue;
    const Rounded& rounded = *fits[i].rounded;
    const auto add = [&](std::string_view name, const RoundedConstants& constants) {
      std::vector<Cell> row = row_of(name, constants);
      if (family.has_exponent()) row.insert(row.begin(), Number{*refit.fits[i].fit.exponent, all_digits});
      table.rows.push_back(row);
    };
    add(rounded.is_proven ? "best" : "best found", rounded.best);
    add("fitted, rounded", rounded.naive);
    if (rounded.published) add("published, rounded", *rounded.published);
  }
  return table;
}

std::string rounded_text(const std::vector<RoundedFit>& fits) {
  std::string text;
  std::vector<std::string> said;  // each sentence once per sweep
  const auto say = [&](const std::string& sentence) {
    if (std::find(said.begin(), said.end(), sentence) != said.end()) return;
    said.push_back(sentence);
    text += sentence + "\n";
  };
  for (const RoundedFit& fit : fits) {
    if (!fit.rounded) {
      say(fmt::format("Not rounded: {}.", fit.reason));
      continue;
    }
    say(fmt::format("Max {} error: {}.", short_name(fit.rounded->error),
                    meaning_of_error(fit.rounded->format)));
    if (fit.rounded->best.gpu_bound) say(fmt::format("On a GPU: {}.", gpu_assumption));
    say(meaning_of_best(*fit.rounded));
  }
  return text;
}

void add_rounded_json(Json& fit_json, const FittableFamily& family, const RoundedFit& fit) {
  if (!fit.rounded) {
    fit_json["rounded"] = nullptr;
    fit_json["rounded_reason"] = fit.reason;
    return;
  }
  const Rounded& rounded = *fit.rounded;
  const auto json_of = [&](const RoundedConstants& constants) {
    return constants_json(family, constants, rounded.error);
  };
  Json json{{"format", to_text(rounded.format)}, {"error", name(rounded.error)}};
  json.update(json_of(rounded.best));
  json["naive"] = json_of(rounded.naive);
  json["published"] = rounded.published ? json_of(*rounded.published) : Json();
  json["proven"] = rounded.is_proven;
  json["searched"] = rounded.searched;
  json["boxes"] = rounded.boxes;
  json["tried"] = rounded.evaluated;
  json["error_is"] = meaning_of_error(rounded.format);
  json["gpu_model"] = rounded.best.gpu_bound ? Json(gpu_assumption) : Json();
  fit_json["rounded"] = json;
}

}  // namespace shadefit
