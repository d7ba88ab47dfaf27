#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include <array>

#include "approx/fresnel.hpp"
#include "approx/records/optical_constants.hpp"
#include "fit/catalogue/surface.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/joined.hpp"

namespace shadefit {
namespace {

/// A published curve of c: its column, its label and its line style.
struct Form {
  std::string column;
  std::string label;
  Look look;
  double (*weight)(double cos_theta);
};

double schlick(double c) {
  return schlick_weight(c);
}

double dielectric(double c) {
  return target_weight(exact_surface(constant<double>(glass.ior)), c);
}

Form schlick_form(Look look) {
  return {"schlick", "Schlick, (1 − c)^5", look, &schlick};
}

/// The approximations by one exp2.
std::vector<Form> exp2_forms() {
  const std::string sharpness = printed("fresnel-one-term"), other = printed("fresnel-offset-one");
  const std::string a = typeset(printed("fresnel-quadratic-a"));
  const std::string b = printed("fresnel-quadratic-b");
  const std::string sum = b.starts_with('-') ? "− " + b.substr(1) : "+ " + b;
  return {{"one_term_" + sharpness, fmt::format("exp2(−{} c)", sharpness), Look::first,
           [](double c) { return fresnel_one_term(c, constant<double>(printed("fresnel-one-term"))); }},
          {"one_term_" + other, fmt::format("exp2(−{} c)", other), Look::third,
           [](double c) { return fresnel_one_term(c, constant<double>(printed("fresnel-offset-one"))); }},
          {"quadratic", fmt::format("exp2(({} c {}) c)", a, sum), Look::second, [](double c) {
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

Table weight_table(const std::vector<Form>& forms) {
  Table table{{"cosine"}};
  for (const Form& form : forms) table.columns.push_back(form.column);
  for (int i = 0; i <= plot_steps; ++i) {
    const double c = static_cast<double>(i) / plot_steps;
    auto& row = table.rows.emplace_back(std::vector<Cell>{plotted(c)});
    for (const Form& form : forms) row.push_back(plotted(form.weight(c)));
  }
  return table;
}

Figure weights(std::string_view family) {
  std::vector<Form> forms{schlick_form(Look::target)};
  for (const Form& form : exp2_forms()) forms.push_back(form);
  forms.push_back(
      {"dielectric", fmt::format("exact dielectric, n = {}", glass.ior), Look::fourth, &dielectric});
  std::vector<Curve> curves;
  for (const Form& form : forms) curves.push_back({form.column, form.label, form.look});
  Panel linear = panel_over_cosine(curves, "set yrange [0:1]\n");
  linear.title = "linear scale";
  linear.y_label = "weight f";
  Panel logarithmic =
      panel_over_cosine(curves, "set logscale y\nset yrange [1e-5:1]\nset format y '10^{%T}'\n");
  logarithmic.title = "logarithmic scale";
  const Plot plot{.name = "fresnel",
                  .about = "Schlick's Fresnel weight f, its approximations and the exact dielectric.",
                  .columns = 2,
                  .panel_height = 330,
                  .panels = {linear, logarithmic}};
  return {plot.name, family,
          fmt::format("Schlick's weight, its approximations by one exp2, and the weight that the exact "
                      "dielectric of index {} has in its place; on the logarithmic scale it shows what each "
                      "leaves at normal incidence, where the weight is 0.",
                      glass.ior),
          weight_table(forms), write_script(plot)};
}

/// Against one reference: absolute error of F and its error relative to the reference's F, by column.
struct ErrorsAgainst {
  std::string reference;
  std::string title;
  std::vector<Form> forms;
  double (*weight)(double cos_theta);
};

std::vector<Curve> error_curves(const ErrorsAgainst& comparison, const std::string& kind) {
  std::vector<Curve> curves;
  for (const Form& form : comparison.forms) {
    curves.push_back({fmt::format("{}_{}_to_{}", kind, form.column, comparison.reference), form.label,
                      form.look, kind == "rel"});
  }
  return curves;
}

Table error_table(const std::vector<ErrorsAgainst>& comparisons) {
  const double f0 = constant<double>(reference_f0);
  Table table{{"cosine"}};
  for (const ErrorsAgainst& comparison : comparisons) {
    for (const char* kind : {"abs", "rel"}) {
      for (const Curve& curve : error_curves(comparison, kind)) table.columns.push_back(curve.column);
    }
  }
  for (int i = 0; i <= plot_steps; ++i) {
    const double c = static_cast<double>(i) / plot_steps;
    auto& row = table.rows.emplace_back(std::vector<Cell>{plotted(c)});
    for (const ErrorsAgainst& comparison : comparisons) {
      const double reference = comparison.weight(c);
      std::vector<double> errors;
      for (const Form& form : comparison.forms) errors.push_back((1 - f0) * (form.weight(c) - reference));
      for (const double error : errors) row.push_back(plotted(error));
      for (const double error : errors) row.push_back(plotted(error / schlick_reflectance(f0, reference)));
    }
  }
  return table;
}

Figure errors(std::string_view family) {
  std::vector<Form> with_schlick{schlick_form(Look::thin_target)};
  for (const Form& form : exp2_forms()) with_schlick.push_back(form);
  const std::vector<ErrorsAgainst> comparisons{
      {"schlick", fmt::format("against Schlick, F0 = {}", reference_f0), exp2_forms(), &schlick},
      {"dielectric", fmt::format("against the exact dielectric, n = {}", glass.ior), with_schlick,
       &dielectric}};
  const Table data = error_table(comparisons);
  std::vector<Panel> panels;
  for (const char* kind : {"abs", "rel"}) {
    const bool is_absolute = std::string_view(kind) == "abs";
    std::vector<Curve> all;
    for (const ErrorsAgainst& comparison : comparisons) {
      const auto curves = error_curves(comparison, kind);
      all.insert(all.end(), curves.begin(), curves.end());
    }
    for (const ErrorsAgainst& comparison : comparisons) {
      const bool is_first = &comparison == &comparisons.front();
      Panel& panel = panels.emplace_back(
          panel_over_cosine(error_curves(comparison, kind), "set yrange " + range_around(data, all) + "\n"));
      panel.levels = {{"0", ""}};
      if (is_first) panel.y_label = is_absolute ? "absolute error of F" : "relative error of F, %";
      if (is_absolute) {
        panel.title = comparison.title;
        panel.x_label.clear();
      } else {
        panel.top_tics.clear();
      }
    }
  }
  const Plot plot{.name = "fresnel-errors",
                  .about = fmt::format("Errors of F = F0 + (1 - F0) f, F0 = {}, by each published form of f.",
                                       reference_f0),
                  .columns = 2,
                  .panel_height = 230,
                  .panels = panels};
  return {
      plot.name, family,
      fmt::format("Errors of the reflectance F = F0 + (1 − F0) f with F0 = {}, the one of index {}: on the "
                  "left against Schlick's formula, which they approximate, on the right against the exact "
                  "dielectric, which Schlick's formula itself misses.",
                  reference_f0, glass.ior),
      data, write_script(plot)};
}

}  // namespace

std::vector<Figure> fresnel_figures(std::string_view family) {
  return {weights(family), errors(family)};
}

}  // namespace shadefit
