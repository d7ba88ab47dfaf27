#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"

namespace shadefit {
namespace {

/// One curve of the panels: the suffix of its column's name, and its value at a cosine. In long double the
/// digits of small errors survive the difference from the target.
struct Approximation {
  std::string column;
  std::string label;
  Look look;
  std::function<long double(const Fit&, const Cosine<double>&)> value;
};

/// The available fits of a low, a medium and a high exponent under the first measure.
std::vector<const Fit*> fits_at(const Refit& refit, std::initializer_list<double> exponents) {
  std::vector<const Fit*> fits;
  for (const double exponent : exponents) {
    if (const Fit* fit = fit_at(refit, measures.front(), exponent)) fits.push_back(fit);
  }
  return fits;
}

/// The angle up to which a lobe is visible, rounded up to a multiple of five degrees.
double last_angle(const Fit& fit) {
  constexpr double step = 5;
  return std::ceil(degrees_of(where_lobe_is_visible(*fit.exponent).value()) / step) * step;
}

/// cos^k(θ), with all digits near its peak.
long double lobe_at(const Fit& fit, const Cosine<double>& c) {
  constexpr double near = 0.5;
  return c.cos_theta > near ? power_lobe_near_peak<long double>(c.one_minus_cos, *fit.exponent)
                            : power_lobe<long double>(c.cos_theta, *fit.exponent);
}

/// The lobe of a fit and its approximations.
std::vector<DrawnCurve> values_at(const Fit& fit, const std::vector<Approximation>& approximations) {
  std::vector<DrawnCurve> curves{{{"target", "cos^k(θ)", Look::target},
                                  [&](double angle) { return lobe_at(fit, cosine_of_degrees(angle)); }}};
  for (const Approximation& of : approximations)
    curves.push_back({{of.column, of.label, of.look}, [&fit, value = of.value](double angle) {
                        return value(fit, cosine_of_degrees(angle));
                      }});
  return curves;
}

/// The errors of the approximations: absolute ones, then relative ones, where the target is at least 1/255.
std::vector<DrawnCurve> errors_at(const Fit& fit, const std::vector<Approximation>& approximations) {
  std::vector<DrawnCurve> curves;
  const auto error = [&fit](const Approximation& of, const Cosine<double>& c) {
    return of.value(fit, c) - lobe_at(fit, c);
  };
  for (const Approximation& of : approximations)
    curves.push_back({{"abs_" + of.column, of.label, of.look},
                      [=](double angle) { return error(of, cosine_of_degrees(angle)); }});
  const double least = where_lobe_is_visible(*fit.exponent).value().cos_theta;
  for (const Approximation& of : approximations)
    curves.push_back({{"rel_" + of.column, of.label, of.look, true}, [=, &fit](double angle) {
                        const Cosine<double> c = cosine_of_degrees(angle);
                        return c.cos_theta >= least ? error(of, c) / lobe_at(fit, c) : NAN;
                      }});
  return curves;
}

/// The curves of each fit, as far as its lobe is visible.
Table table_of(const std::vector<const Fit*>& fits, const std::vector<Approximation>& approximations,
               std::vector<DrawnCurve> (*curves_at)(const Fit&, const std::vector<Approximation>&)) {
  Table table = table_for({"exponent", "angle"}, curves_at(*fits.front(), approximations));
  for (const Fit* fit : fits)
    append_rows(table, {plotted(*fit->exponent)}, curves_at(*fit, approximations),
                even_places(0, last_angle(*fit)));
  return table;
}

/// A row of panels over the angle, one per fit.
struct PanelRow {
  std::string y_label;
  std::string settings;
  std::vector<Curve> curves;
  std::vector<Level> levels;
};

/// A panel has the angles where the lobe of its fit is visible. The exponents, with the name `letter`, stand
/// above the columns.
std::vector<Panel> panels_of(const std::vector<PanelRow>& rows, const std::vector<const Fit*>& fits,
                             const std::string& letter) {
  std::vector<Panel> panels;
  for (const PanelRow& row : rows) {
    for (const Fit* fit : fits) {
      Panel& panel = panels.emplace_back(
          Panel{.settings = fmt::format("set xrange [0:{}]\n", last_angle(*fit)) + row.settings,
                .abscissa = "angle",
                .where = fmt::format("column('exponent') == {}", *fit->exponent),
                .curves = row.curves,
                .levels = row.levels});
      if (fit == fits.front()) panel.y_label = row.y_label;
      if (&row == &rows.front()) panel.title = fmt::format("{} = {}", letter, *fit->exponent);
      if (&row == &rows.back()) panel.x_label = "angle, degrees";
    }
  }
  return panels;
}

/// Absolute errors above, relative ones below. The axis ends at 100 %: in the tail of a blunt lobe a relative
/// error grows to thousands of percent.
Figure error_figure(const std::string& name, const std::string& about, std::string_view family,
                    const std::string& caption, const std::vector<const Fit*>& fits,
                    const std::vector<Approximation>& approximations, const std::string& letter) {
  const std::vector<Curve> curves = curves_of(errors_at(*fits.front(), approximations));
  const auto relative = curves.begin() + std::ssize(approximations);
  const std::vector<Level> zero{{"0", ""}};
  const Plot plot{name, about, 3, 200,
                  panels_of({{"absolute error", "", {curves.begin(), relative}, zero},
                             {"relative error, %", "set yrange [*:*<100]\n", {relative, curves.end()}, zero}},
                            fits, letter)};
  return figure_of(plot, family, caption, table_of(fits, approximations, errors_at));
}

std::vector<Approximation> gaussian_approximations() {
  const auto offset = [](const std::string& x, Look look) -> Approximation {
    return {"offset_" + x, "x = " + x, look,
            [value = constant<double>(x)](const Fit& fit, const Cosine<double>& c) {
              return gaussian_lobe_near_peak<long double>(c.one_minus_cos, *fit.exponent, value);
            }};
  };
  return {offset("0", Look::first), offset(printed("sg-offset-mean"), Look::second),
          offset("1", Look::third)};
}

/// The best parameter by measure, marked where it was fitted.
std::vector<Curve> measure_curves() {
  constexpr std::array looks{Look::second, Look::first, Look::third};
  static_assert(looks.size() == measures.size());
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const std::string measure(name(measures[i]));
    curves.push_back(
        {.column = measure, .label = measure + " measure", .look = looks[i], .has_points = true});
  }
  return curves;
}

Figure gaussian_lobe_figure(const std::vector<const Fit*>& fits) {
  const std::vector<Curve> curves = curves_of(values_at(*fits.front(), gaussian_approximations()));
  // The logarithmic scale ends at one code of an 8-bit linear target.
  const Plot plot{"lobe", "The lobe c^k and exp((k+x)(c-1)) for three offsets x, at three exponents k.", 3,
                  210,
                  panels_of({{"value", "set yrange [0:1]\n", curves, {}},
                             {"value, logarithmic", "set logscale y\nset yrange [1./255:1]\n", curves, {}}},
                            fits, "k")};
  return figure_of(
      plot, "sg-offset",
      "The lobe cos^k θ and its spherical Gaussian exp((k+x)(cos θ − 1)) for three offsets x, at a low, a "
      "medium and a high exponent k, each as far as the lobe is visible; below on a logarithmic scale, where "
      "the tails part.",
      table_of(fits, gaussian_approximations(), values_at));
}

Figure offset_figure(const Refit& refit) {
  const std::string mean = printed("sg-offset-mean"), limit = printed("sg-offset-limit");
  const auto panel = [&](const std::string& settings, const Level& level) {
    return Panel{.x_label = "exponent k",
                 .settings = settings + "set yrange [0.4:0.85]\n",
                 .abscissa = "exponent",
                 .curves = measure_curves(),
                 .levels = {level}};
  };
  // The small range is slightly more than that of the published mean; the next fit is at k = 25.
  Panel small = panel("set xrange [0:26]\n", {mean, mean + ", the mean"});
  small.y_label = "best offset x";
  const Panel whole =
      panel("set logscale x\nset xrange [1:1e6]\nset format x '10^{%T}'\n", {limit, limit + ", the limit"});
  const Plot plot{"offset", "The best offset x by exponent k, under three measures.", 2, 330, {small, whole}};
  return figure_of(
      plot, "sg-offset",
      fmt::format("The best offset x by exponent k under three measures, on a small and on the whole range, "
                  "with the printed mean {} and limit {}.",
                  mean, limit),
      best_parameter_table(refit));
}

std::vector<Approximation> blinn_approximations() {
  const auto factor = [](const std::string& x, Look look) -> Approximation {
    return {"factor_" + x, "factor " + x, look,
            [value = constant<double>(x)](const Fit& fit, const Cosine<double>& c) {
              return blinn_lobe<long double>(c.one_minus_cos, *fit.exponent, value);
            }};
  };
  return {factor(printed("phong-blinn-fisher-woo"), Look::first),
          factor(printed("phong-blinn-gotanda"), Look::third),
          {"best_factor", "best factor", Look::second, [](const Fit& fit, const Cosine<double>& c) {
             return blinn_lobe<long double>(c.one_minus_cos, *fit.exponent, fit.parameters.front());
           }}};
}

Figure factor_figure(const Refit& refit) {
  const std::string limit = printed("phong-blinn-fisher-woo"), somewhere = printed("phong-blinn-gotanda");
  const Panel panel{.x_label = "Phong exponent ρ",
                    .y_label = "best factor x",
                    .settings = "set logscale x 2\nset xtics 2\nset xrange [1:2048]\nset yrange [3.9:5.6]\n",
                    .abscissa = "exponent",
                    .curves = measure_curves(),
                    .levels = {{limit, limit}, {somewhere, somewhere}}};
  const Plot plot{"phong-blinn",
                  "The best factor from Phong's exponent to Blinn's, under three measures.",
                  1,
                  340,
                  {panel}};
  return figure_of(
      plot, "phong-blinn",
      fmt::format(
          "The best factor from the Phong exponent ρ to Blinn's under three measures, with the printed {} and {}.",
          limit, somewhere),
      best_parameter_table(refit));
}

}  // namespace

std::vector<Figure> gaussian_figures(const Refit& refit) {
  // Low, medium and high: the lowest in use, the end of the published mean, a glossy surface.
  const auto fits = fits_at(refit, {2, 15, 100});
  if (fits.empty()) return {offset_figure(refit)};
  return {
      gaussian_lobe_figure(fits),
      error_figure(
          "lobe-errors", "Errors of exp((k+x)(c-1)) against c^k for three offsets x, at three exponents k.",
          "sg-offset",
          "Errors of the spherical Gaussian against cos^k θ, whose peak is 1, for three offsets x; relative "
          "errors where the lobe is at least 1/255, and up to 100 %.",
          fits, gaussian_approximations(), "k"),
      offset_figure(refit)};
}

std::vector<Figure> phong_blinn_figures(const Refit& refit) {
  const auto fits = fits_at(refit, {2, 8, 128});
  if (fits.empty()) return {factor_figure(refit)};
  return {
      factor_figure(refit),
      error_figure(
          "phong-blinn-errors",
          "Errors of cos^(x rho)(theta/2) against cos^rho(theta) for three factors x, at three exponents.",
          "phong-blinn",
          "Errors of the Blinn lobe cos^(xρ)(θ/2) against the Phong lobe cos^ρ θ, whose peak is 1, for three "
          "factors x; relative errors where the lobe is at least 1/255, and up to 100 %.",
          fits, blinn_approximations(), "ρ")};
}

}  // namespace shadefit
