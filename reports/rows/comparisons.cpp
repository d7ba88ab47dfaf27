#include "reports/rows/comparisons.hpp"

#include <fmt/format.h>

#include "reports/io/joined.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/tables.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;
using ContenderKind = Contender::Kind;

/// "a = -5.55473, b = -6.98316": published ones as printed, fitted ones with ten digits or all.
std::string constants_text(const Contender& contender, Precision precision) {
  if (contender.kind == ContenderKind::published) return equations(contender.parameters);
  auto value = contender.values.begin();
  return joined(contender.parameters, ", ", [&](const auto& parameter) {
    return parameter.first + " = " + text(converged(*value++), precision);
  });
}

/// The lower bound, which is the error at a place: its digits do not depend on the steps of the proof.
Cell shown_error(const Contender& contender, int digits) {
  return Number{contender.max_abs_error.lower, digits};
}

Cell relative_error(const Contender& contender, int digits) {
  return contender.max_rel_error ? Cell(Number{*contender.max_rel_error, digits}) : Cell();
}

Cell place_of_error(const Contender& contender) {
  return contender.at ? place(*contender.at) : Cell();
}

long instructions(const Contender& contender) {
  return contender.operations.total();
}

/// "fresnel-quadratic-a", "schlick", "target", "fresnel-cubic minimax absolute error": the name of a curve
/// for programs.
std::string curve_id(const Contender& contender) {
  if (contender.kind == ContenderKind::published) return std::string(contender.published);
  if (contender.kind == ContenderKind::target) return "target";
  return fmt::format("{} {}", contender.family, contender.origin);
}

std::string origin_of(const Contender& contender) {
  if (contender.kind != ContenderKind::published) return contender.origin;
  return fmt::format("{}, {}", contender.published, contender.origin);
}

Table table_of(const Comparison& comparison, int digits) {
  Table table{{"form", "constants", "from", "max abs error", "at c", "max rel error", "rms error",
               "operations", "instructions", "beats"}};
  for (const Contender& contender : comparison.contenders) {
    table.rows.push_back({contender.form, constants_text(contender, Precision::report), origin_of(contender),
                          shown_error(contender, digits), place_of_error(contender),
                          relative_error(contender, digits), Number{contender.rms_error, digits},
                          to_text(contender.operations), instructions(contender),
                          joined(contender.beats, ", ")});
  }
  return table;
}

Json surface_json(const Comparison& comparison) {
  const Surface& surface = comparison.setting.surface;
  if (!surface.is_named()) return {};
  return {{"formula", surface.is_exact() ? "exact" : "schlick"},
          {"ior", surface.ior},
          {"extinction", surface.extinction}};
}

Json contender_json(const Contender& contender) {
  constexpr std::array kinds{"published", "fitted", "target"};
  Json parameters = Json::object(), printed;
  for (std::size_t i = 0; i < contender.parameters.size(); ++i) {
    const auto& [name, text] = contender.parameters[i];
    parameters[name] = contender.values[i];
    if (contender.kind == ContenderKind::published) printed[name] = text;
  }
  const auto or_null = [](std::string_view text) { return text.empty() ? Json() : Json(text); };
  return {{"kind", kinds[static_cast<std::size_t>(contender.kind)]},
          {"family", or_null(contender.family)},
          {"published", or_null(contender.published)},
          {"form", contender.form},
          {"from", contender.origin},
          {"parameters", parameters},
          {"printed", printed},
          {"certified_max_abs_error", {contender.max_abs_error.lower, contender.max_abs_error.upper}},
          {"max_abs_error_at", contender.at ? Json(contender.at->cos_theta) : Json()},
          {"max_rel_error", optional_json(contender.max_rel_error)},
          {"rms_error", contender.rms_error},
          {"operations", to_text(contender.operations)},
          {"instructions", instructions(contender)},
          {"beats", contender.beats}};
}

}  // namespace

std::string target_of(const Comparison& comparison) {
  const auto& [family, setting, domain, contenders, left_out] = comparison;
  const std::string target = target_of(*family, setting.surface);
  return target + (family->has_exponent() ? fmt::format(" at k = {}", setting.exponent) : "") +
         (domain == Domain{} ? "" : " on " + to_text(domain));
}

Table comparison_table(const Comparison& comparison) {
  return table_of(comparison, 6);
}

Table short_comparison_table(const Comparison& comparison) {
  return table_of(comparison, 4);
}

Table comparisons_table(const std::vector<Comparison>& comparisons, Precision precision) {
  Table table{{"constant", "exponent", "target", "domain", "curve", "form", "parameters", "max_abs_error",
               "max_abs_error_at", "max_rel_error", "rms_error", "operations", "instructions", "beats"}};
  for (const Comparison& comparison : comparisons) {
    const Family& family = *comparison.family;
    for (const Contender& contender : comparison.contenders) {
      const Cell error = precision == Precision::full
                             ? Cell(Number{contender.max_abs_error.upper, all_digits})
                             : shown_error(contender, 4);
      table.rows.push_back({std::string(family.id),
                            family.has_exponent() ? Cell(Number{comparison.setting.exponent, 10}) : Cell(),
                            target_of(family, comparison.setting.surface), to_text(comparison.domain),
                            curve_id(contender), contender.form, constants_text(contender, precision), error,
                            place_of_error(contender), relative_error(contender, 4),
                            Number{contender.rms_error, 4}, to_text(contender.operations),
                            instructions(contender), joined(contender.beats, " ")});
    }
  }
  return table;
}

Json write_comparison_json(const Comparison& comparison) {
  const Family& family = *comparison.family;
  return {{"schema", 1},
          {"constant", family.id},
          {"exponent", family.has_exponent() ? Json(comparison.setting.exponent) : Json()},
          {"target", target_of(family, comparison.setting.surface)},
          {"surface", surface_json(comparison)},
          {"domain", {comparison.domain.lower, comparison.domain.upper}},
          {"curves", json_array(comparison.contenders, contender_json)},
          {"left_out", comparison.left_out}};
}

std::string not_reached_lines(const Comparison& comparison) {
  std::string lines;
  for (const Contender& contender : comparison.contenders) {
    if (contender.max_abs_error.is_reached) continue;
    lines += fmt::format("shadefit: {}: the largest error of {} could not be enclosed: it is in [{}, {}]\n",
                         target_of(comparison), curve_id(contender), contender.max_abs_error.lower,
                         contender.max_abs_error.upper);
  }
  return lines;
}

std::string left_out_lines(const std::vector<std::string>& left_out) {
  return joined(left_out, "", [](const std::string& fit) { return "Left out: " + for_terminal(fit) + "\n"; });
}

}  // namespace shadefit
