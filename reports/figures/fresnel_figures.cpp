#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>

#include "approx/fresnel.hpp"
#include "approx/records/optical_constants.hpp"
#include "fit/catalogue/surface.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/joined.hpp"

namespace shadefit {
namespace {

double dielectric(double c) {
  return target_weight(exact_surface(constant<double>(glass.ior)), c);
}

DrawnCurve schlick(Look look) {
  return {{"schlick", "Schlick, (1 − c)^5", look}, schlick_weight<double>};
}

/// The approximations by one exp2.
std::vector<DrawnCurve> exp2_forms() {
  const std::string sharpness = printed("fresnel-one-term"), other = printed("fresnel-offset-one");
  const std::string a = typeset(printed("fresnel-quadratic-a"));
  const std::string b = printed("fresnel-quadratic-b");
  const std::string sum = b.starts_with('-') ? "− " + b.substr(1) : "+ " + b;
  return {{{"one_term_" + sharpness, fmt::format("exp2(−{} c)", sharpness), Look::first},
           [](double c) { return fresnel_one_term(c, constant<double>(printed("fresnel-one-term"))); }},
          {{"one_term_" + other, fmt::format("exp2(−{} c)", other), Look::third},
           [](double c) { return fresnel_one_term(c, constant<double>(printed("fresnel-offset-one"))); }},
          {{"quadratic", fmt::format("exp2(({} c {}) c)", a, sum), Look::second}, [](double c) {
             return fresnel_quadratic(c, constant<double>(printed("fresnel-quadratic-a")),
                                      constant<double>(printed("fresnel-quadratic-b")));
           }}};
}

/// The angle on top of a panel over the cosine, which runs from grazing (left) to normal incidence.
std::string angles() {
  return joined(std::array{90, 80, 70, 60, 45, 30, 0}, ", ",
                [](int degrees) { return fmt::format("'{0}°' cos({0}*pi/180)", degrees); });
}

/// A panel over the cosine of the angle of incidence.
Panel panel_over_cosine(std::vector<Curve> curves, const std::string& settings) {
  return {.x_label = "c, the cosine of the angle of incidence",
          .settings = "set xrange [0:1]\nset x2range [0:1]\n" + settings,
          .top_tics = angles(),
          .abscissa = "cosine",
          .curves = std::move(curves)};
}

Table table_over_cosine(const std::vector<DrawnCurve>& curves) {
  Table table = table_for({"cosine"}, curves);
  append_rows(table, {}, curves, even_places(0, 1));
  return table;
}

Figure weights(std::string_view family) {
  std::vector<DrawnCurve> forms = exp2_forms();
  forms.insert(forms.begin(), schlick(Look::target));
  forms.push_back(
      {{"dielectric", fmt::format("exact dielectric, n = {}", glass.ior), Look::fourth}, dielectric});
  Panel linear = panel_over_cosine(curves_of(forms), "set yrange [0:1]\n");
  linear.title = "linear scale";
  linear.y_label = "weight f";
  Panel logarithmic =
      panel_over_cosine(curves_of(forms), "set logscale y\nset yrange [1e-5:1]\nset format y '10^{%T}'\n");
  logarithmic.title = "logarithmic scale";
  const Plot plot{.name = "fresnel",
                  .about = "Schlick's Fresnel weight f, its approximations and the exact dielectric.",
                  .columns = 2,
                  .panel_height = 330,
                  .panels = {linear, logarithmic}};
  return figure_of(
      plot, family,
      fmt::format("Schlick's weight, its approximations by one exp2, and the weight that the exact "
                  "dielectric of index {} has in its place; on the logarithmic scale it shows what each "
                  "leaves at normal incidence, where the weight is 0.",
                  glass.ior),
      table_over_cosine(forms));
}

/// The errors of F by these forms of the weight against one reference: absolute, or in percent of its F.
std::vector<DrawnCurve> errors_of(const std::vector<DrawnCurve>& forms, const char* name,
                                  const std::function<double(double)>& reference, bool in_percent) {
  std::vector<DrawnCurve> errors;
  for (const DrawnCurve& form : forms) {
    Curve curve = form.curve;
    curve.column = fmt::format("{}_{}_to_{}", in_percent ? "rel" : "abs", curve.column, name);
    curve.in_percent = in_percent;
    errors.push_back({curve, [weight = form.value, reference, in_percent](double c) {
                        const double f0 = constant<double>(reference_f0), truth = reference(c);
                        const double error = (1 - f0) * (weight(c) - truth);
                        return in_percent ? error / schlick_reflectance(f0, truth) : error;
                      }});
  }
  return errors;
}

Figure errors(std::string_view family) {
  std::vector<DrawnCurve> forms = exp2_forms();
  // By panel: absolute above, relative below; on the left against Schlick.
  std::array<std::vector<DrawnCurve>, 4> errors;
  for (const bool in_percent : {false, true})
    errors.at(in_percent ? 2 : 0) = errors_of(forms, "schlick", schlick(Look::target).value, in_percent);
  forms.insert(forms.begin(), schlick(Look::thin_target));
  for (const bool in_percent : {false, true})
    errors.at(in_percent ? 3 : 1) = errors_of(forms, "dielectric", dielectric, in_percent);
  std::vector<DrawnCurve> all;
  for (const std::size_t panel : {0u, 2u, 1u, 3u})
    all.insert(all.end(), errors.at(panel).begin(), errors.at(panel).end());
  const Table data = table_over_cosine(all);
  const std::array titles{fmt::format("against Schlick, F0 = {}", reference_f0),
                          fmt::format("against the exact dielectric, n = {}", glass.ior)};
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const bool in_percent = i >= 2, is_first = i % 2 == 0;
    std::vector<Curve> of_row = curves_of(errors.at(is_first ? i : i - 1)),
                       others = curves_of(errors.at(i | 1U));
    of_row.insert(of_row.end(), others.begin(), others.end());
    Panel& panel = panels.emplace_back(
        panel_over_cosine(curves_of(errors.at(i)), "set yrange " + range_around(data, of_row) + "\n"));
    panel.levels = {{"0", ""}};
    if (is_first) panel.y_label = in_percent ? "relative error of F, %" : "absolute error of F";
    if (in_percent) {
      panel.top_tics.clear();
    } else {
      panel.title = titles.at(i);
      panel.x_label.clear();
    }
  }
  const Plot plot{.name = "fresnel-errors",
                  .about = fmt::format("Errors of F = F0 + (1 - F0) f, F0 = {}, by each published form of f.",
                                       reference_f0),
                  .columns = 2,
                  .panel_height = 230,
                  .panels = panels};
  return figure_of(
      plot, family,
      fmt::format("Errors of the reflectance F = F0 + (1 − F0) f with F0 = {}, the one of index {}: on the "
                  "left against Schlick's formula, which they approximate, on the right against the exact "
                  "dielectric, which Schlick's formula itself misses.",
                  reference_f0, glass.ior),
      data);
}

}  // namespace

std::vector<Figure> fresnel_figures(std::string_view family) {
  return {weights(family), errors(family)};
}

}  // namespace shadefit
