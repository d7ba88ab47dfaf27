#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include "approx/fresnel.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"
#include "reports/rows/comparisons.hpp"

namespace shadefit {
namespace {

/// The first published curves, then the best curve that beats one.
std::vector<const Contender*> shown_contenders(const Comparison& comparison) {
  std::vector<const Contender*> shown;
  const Contender* best = nullptr;
  for (const Contender& contender : comparison.contenders) {
    const bool is_published = contender.kind == Contender::Kind::published;
    if (is_published && shown.size() + 1 < curve_looks.size()) shown.push_back(&contender);
    if (is_published || contender.beats.empty()) continue;
    if (best == nullptr || contender.max_abs_error.upper < best->max_abs_error.upper) best = &contender;
  }
  if (best != nullptr) shown.push_back(best);
  return shown;
}

/// The error of a contender over the cosine: of a lobe, of a weight f, or on a surface of F = f0 + (1 - f0)
/// f.
std::function<double(const Cosine<double>&)> error_of(const Comparison& comparison,
                                                      const Contender& contender) {
  const Surface& surface = comparison.setting.surface;
  const Family* family = find_family(contender.family);
  if (family == nullptr)
    return [surface](const Cosine<double>& at) {
      const double difference = schlick_weight(at.cos_theta) - target_weight(surface, at.cos_theta);
      return (1 - normal_reflectance<double>(surface)) * difference;
    };
  return [curve = family->curve_at(comparison.setting, contender.values)](const Cosine<double>& at) {
    return curve(at).error;
  };
}

}  // namespace

Figure better_figure(const Comparison& comparison) {
  const auto shown = shown_contenders(comparison);
  Table table{{"cosine"}};
  Panel panel{.title = for_gnuplot(target_of(comparison)),
              .x_label = "c, the cosine",
              .y_label = comparison.setting.surface.is_named() ? "error of F" : "error",
              .abscissa = "cosine"};
  std::vector<std::function<double(const Cosine<double>&)>> errors;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    errors.push_back(error_of(comparison, *shown[i]));
    const std::string column = fmt::format("error_{}", i + 1);
    table.columns.push_back(column);
    const bool is_published = shown[i]->kind == Contender::Kind::published;
    const std::string label = fmt::format("{}: {}", is_published ? shown[i]->origin : "best", shown[i]->form);
    panel.curves.push_back({column, for_gnuplot(label), curve_looks.at(i)});
  }
  const Domain& domain = comparison.domain;
  for (const double c : abscissae(domain.lower, domain.upper)) {
    auto& row = table.rows.emplace_back(std::vector<Cell>{plotted(c)});
    for (const auto& error : errors) row.push_back(plotted(error({c, 1 - c})));
  }
  panel.settings = fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange {}\n", domain.lower, domain.upper,
                               range_around(table, panel.curves));
  const Plot plot{
      .name = "better",
      .about = fmt::format("Errors of published curves and of the best one, for {}.", target_of(comparison)),
      .columns = 1,
      .panel_height = 360,
      .panels = {panel}};
  return {plot.name, comparison.family->id, plot.about, table, write_script(plot)};
}

}  // namespace shadefit
