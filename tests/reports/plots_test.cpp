#include "reports/figures/figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "fit/scalars/multiprecision.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/sections/report.hpp"
#include "tests/accuracy.hpp"
#include "tests/refusal.hpp"
#include "tests/reports/all_results.hpp"
#include "tests/reports/compilers.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::all_results;
using testing::expect_has;
using testing::expect_lacks;
using testing::is_close;

/// Half a unit of the sixth digit, where the first one is a 1.
constexpr double six_digits = 5e-6;

const Figure& figure(const std::vector<Figure>& figures, const std::string& name) {
  return *std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.name == name; });
}

std::size_t column(const Table& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  EXPECT_NE(found, table.columns.end()) << name;
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// The number that a reader of the CSV sees, in the row where the named columns have these values.
double cell(const Table& table, const std::vector<std::pair<std::string, std::string>>& where,
            const std::string& name) {
  for (const auto& row : table.rows) {
    const bool is_row = std::all_of(where.begin(), where.end(), [&](const auto& condition) {
      return text(row.at(column(table, condition.first)), Precision::report) == condition.second;
    });
    if (is_row) return std::stod(text(row.at(column(table, name)), Precision::report));
  }
  ADD_FAILURE() << "no such row for " << name;
  return std::nan("");
}

std::vector<std::string> names(const std::vector<Figure>& figures) {
  std::vector<std::string> out;
  for (const Figure& f : figures) out.push_back(f.name);
  return out;
}

TEST(Plots, EveryFigureHasDataAndAScriptThatReadsIt) {
  const auto figures = make_figures(all_results());
  EXPECT_EQ(names(figures),
            (std::vector<std::string>{"lobe", "lobe-errors", "offset", "fresnel", "fresnel-errors",
                                      "phong-blinn", "phong-blinn-errors"}));
  const std::regex read_column("column\\('([^']*)'\\)");
  for (const Figure& f : figures) {
    std::set<std::string> read;
    for (std::sregex_iterator match(f.script.begin(), f.script.end(), read_column), end; match != end;
         ++match)
      read.insert((*match)[1]);
    EXPECT_EQ(read, std::set<std::string>(f.data.columns.begin(), f.data.columns.end())) << f.name;
    expect_has(f.script, "'" + f.name + ".csv'");
    expect_has(f.script, "set output '" + f.name + ".svg'");
    EXPECT_TRUE(f.caption.ends_with(".")) << f.name;
  }
  const auto files = plot_files(figures);
  ASSERT_EQ(files.size(), 14U);
  EXPECT_EQ(files[0].name, "plots/lobe.csv");
  EXPECT_TRUE(
      files[0].content.starts_with("exponent,angle,target,offset_0,offset_0.775,offset_1\n2,0,1,1,1,1\n"));
  EXPECT_EQ(files[1].name, "plots/lobe.gnuplot");
}

/// Drawn by gnuplot itself, where it is installed; what it says stands in the file `said`.
void draw(const std::string& call, const testing::TemporaryDirectory& directory) {
  ASSERT_TRUE(
      testing::runs("cd '" + directory.path().string() + "' && LC_ALL=C.UTF-8 gnuplot -d " + call, directory))
      << read_file(directory / "said");
  EXPECT_EQ(read_file(directory / "said"), "") << call;
}

// Every pair of the letters that gnuplot gives a meaning to, at the start, in the middle and at the end.
TEST(Plots, ATextIsDrawnAsItIs) {
  EXPECT_EQ(gnuplot_quoted("a b"), "'a b'");
  EXPECT_EQ(gnuplot_quoted("it's"), R"('it'."\047".'s')");
  EXPECT_EQ(for_gnuplot(OthersText("x_1 @ 2^3")), R"(x\_1 \@ 2\^3)");
  if (!find_gnuplot()) return;
  const testing::TemporaryDirectory directory;
  const std::string special = R"('"\`$@^_{}~#;,%a )";
  std::string script = "set print 'printed'\n", texts;
  for (const char one : special) {
    for (const char two : special) {
      for (const std::string& text : {std::string{one, two}, std::string{one, two, 'a'},
                                      std::string{'a', one, two}, std::string{'a', one, two, 'b'}}) {
        script += "print " + gnuplot_quoted(text) + "\n";
        texts += text + "\n";
      }
    }
  }
  directory.file("a.gnuplot", script);
  draw("a.gnuplot", directory);
  EXPECT_EQ(read_file(directory / "printed"), texts);
  directory.file("b.gnuplot", "set terminal svg\nset output 'b.svg'\nset title " +
                                  gnuplot_quoted(for_gnuplot(OthersText(R"('x\y' @ a^b_c {d} ~e)"))) +
                                  "\nplot [0:1][0:1] 2 notitle\n");
  draw("b.gnuplot", directory);
  expect_has(read_file(directory / "b.svg"), R"('x\y' @ a^b_c {d} ~e)");
}

TEST(Plots, ValuesAreFiniteAndOnlyRelativeErrorsMayBeMissing) {
  for (const Figure& f : make_figures(all_results())) {
    EXPECT_FALSE(f.data.rows.empty()) << f.name;
    for (const auto& row : f.data.rows) {
      ASSERT_EQ(row.size(), f.data.columns.size()) << f.name;
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (const auto* number = std::get_if<Number>(&row[i])) {
          EXPECT_TRUE(std::isfinite(number->value)) << f.name << " " << f.data.columns[i];
          EXPECT_EQ(number->digits, 6);
        } else {
          EXPECT_TRUE(f.data.columns[i].starts_with("rel_")) << f.name << " " << f.data.columns[i];
        }
      }
    }
  }
}

TEST(Plots, FresnelFormsAgreeWithFiftyDigits) {
  const auto figures = make_figures(all_results());
  const Decimal50 c("0.25"), f0("0.04"), n("1.5");
  const Decimal50 schlick = pow(Decimal50(1 - c), 5);
  const Decimal50 one_term = pow(Decimal50(2), Decimal50(Decimal50("-8.35") * c));
  const Decimal50 convention = pow(Decimal50(2), Decimal50(Decimal50("-8.656170") * c));
  const Decimal50 quadratic =
      pow(Decimal50(2), Decimal50(Decimal50("-5.55473") * c * c - Decimal50("6.98316") * c));
  // Fresnel's equations by the angles: sin(i - t)/sin(i + t), tan(i - t)/tan(i + t).
  const Decimal50 i = acos(c), t = asin(Decimal50(sin(i) / n));
  const Decimal50 rs = sin(Decimal50(i - t)) / sin(Decimal50(i + t));
  const Decimal50 rp = tan(Decimal50(i - t)) / tan(Decimal50(i + t));
  const Decimal50 exact = (rs * rs + rp * rp) / 2;

  const Table& weights = figure(figures, "fresnel").data;
  const auto weight = [&](const std::string& name) { return cell(weights, {{"cosine", "0.25"}}, name); };
  EXPECT_TRUE(is_close("schlick", schlick, weight("schlick"), six_digits));
  EXPECT_TRUE(is_close("8.35", one_term, weight("one_term_8.35"), six_digits));
  EXPECT_TRUE(is_close("8.656170", convention, weight("one_term_8.656170"), six_digits));
  EXPECT_TRUE(is_close("quadratic", quadratic, weight("quadratic"), six_digits));
  EXPECT_TRUE(is_close("dielectric", (exact - f0) / (1 - f0), weight("dielectric"), six_digits));

  const Table& errors = figure(figures, "fresnel-errors").data;
  const auto error = [&](const std::string& name) { return cell(errors, {{"cosine", "0.25"}}, name); };
  const auto reflectance = [&](const Decimal50& f) { return Decimal50(f0 + (1 - f0) * f); };
  EXPECT_TRUE(is_close("quadratic to Schlick", reflectance(quadratic) - reflectance(schlick),
                       error("abs_quadratic_to_schlick"), six_digits));
  EXPECT_TRUE(is_close("relative", reflectance(quadratic) / reflectance(schlick) - 1,
                       error("rel_quadratic_to_schlick"), six_digits));
  EXPECT_TRUE(is_close("Schlick to exact", reflectance(schlick) - exact, error("abs_schlick_to_dielectric"),
                       six_digits));
  EXPECT_TRUE(is_close("relative", reflectance(one_term) / exact - 1,
                       error("rel_one_term_8.35_to_dielectric"), six_digits));
}

TEST(Plots, LobesAgreeWithFiftyDigits) {
  const auto figures = make_figures(all_results());
  // k = 15 is drawn up to 50 degrees, rho = 8 up to 60.
  const auto cosine_of = [](const char* degrees) {
    return Decimal50(cos(Decimal50(Decimal50(degrees) * pi<Decimal50>() / 180)));
  };
  const Decimal50 c = cosine_of("12.5"), lobe = pow(c, 15);
  const Decimal50 gaussian = exp(Decimal50(Decimal50("15.775") * (c - 1)));
  const std::vector<std::pair<std::string, std::string>> place{{"exponent", "15"}, {"angle", "12.5"}};
  const Table& values = figure(figures, "lobe").data;
  EXPECT_TRUE(is_close("lobe", lobe, cell(values, place, "target"), six_digits));
  EXPECT_TRUE(is_close("gaussian", gaussian, cell(values, place, "offset_0.775"), six_digits));
  EXPECT_TRUE(is_close("x = 1", exp(Decimal50(16 * (c - 1))), cell(values, place, "offset_1"), six_digits));
  const Table& errors = figure(figures, "lobe-errors").data;
  EXPECT_TRUE(is_close("error", gaussian - lobe, cell(errors, place, "abs_offset_0.775"), six_digits));
  EXPECT_TRUE(is_close("relative", gaussian / lobe - 1, cell(errors, place, "rel_offset_0.775"), six_digits));

  const Decimal50 theta = cosine_of("30"), half = cosine_of("15");
  const Decimal50 phong = pow(theta, 8), blinn = pow(half, Decimal50(Decimal50("4.2") * 8));
  const Table& factors = figure(figures, "phong-blinn-errors").data;
  const std::vector<std::pair<std::string, std::string>> there{{"exponent", "8"}, {"angle", "30"}};
  EXPECT_TRUE(is_close("blinn", blinn - phong, cell(factors, there, "abs_factor_4.2"), six_digits));
  EXPECT_TRUE(is_close("relative", blinn / phong - 1, cell(factors, there, "rel_factor_4.2"), six_digits));
  const Decimal50 best = pow(half, Decimal50(Decimal50("4.192766232") * 8));  // as in the baseline
  EXPECT_TRUE(is_close("best", best - phong, cell(factors, there, "abs_best_factor"), six_digits));
}

TEST(Plots, RelativeErrorsEndWhereTheLobeIsInvisible) {
  const auto figures = make_figures(all_results());
  const Table& errors = figure(figures, "lobe-errors").data;
  std::size_t missing = 0;
  for (const auto& row : errors.rows) {
    const double k = std::get<Number>(row[0]).value, angle = std::get<Number>(row[1]).value;
    const bool is_visible = std::pow(cosine_of_degrees(angle).cos_theta, k) >= 1 / 255.0;
    const bool is_there = std::holds_alternative<Number>(row.at(column(errors, "rel_offset_1")));
    EXPECT_EQ(is_there, is_visible) << "k = " << k << ", angle " << angle;
    missing += !is_there;
  }
  EXPECT_GT(missing, 0U);
}

TEST(Plots, TheBestParametersAreThoseOfTheFits) {
  const auto figures = make_figures(all_results());
  const Table& offset = figure(figures, "offset").data;
  EXPECT_EQ(offset.columns, (std::vector<std::string>{"exponent", "cosine", "angle", "cosine-weighted"}));
  EXPECT_EQ(offset.rows.size(), 21U);
  EXPECT_EQ(cell(offset, {{"exponent", "5"}}, "cosine"), 0.787545);
  EXPECT_EQ(cell(offset, {{"exponent", "1e+06"}}, "angle"), 0.625);
  EXPECT_EQ(cell(figure(figures, "phong-blinn").data, {{"exponent", "8"}}, "angle"), 4.16341);
}

TEST(Plots, WhatWasNotComputedIsNotDrawn) {
  const auto fresnel = make_figures(compute_results({"fresnel-one-term"}));
  EXPECT_EQ(names(fresnel), (std::vector<std::string>{"fresnel", "fresnel-errors"}));
  EXPECT_EQ(fresnel.front().family, "fresnel-one-term");
  EXPECT_TRUE(make_figures(compute_results({"norm-lambert"})).empty());
  EXPECT_TRUE(plot_files({}).empty());

  Results broken = compute_results({"sg-offset", "phong-blinn"});
  EXPECT_EQ(make_figures(broken).size(), 5U);
  broken.refits.front().fits.back().fit.status = Status::not_converged;
  EXPECT_EQ(names(make_figures(broken)), (std::vector<std::string>{"phong-blinn", "phong-blinn-errors"}));
}

TEST(Plots, TheReportShowsThemInTheirSections) {
  const Results& results = all_results();
  const auto figures = make_figures(results);
  const std::string report = write_report(results, figures);
  const auto at = [&](const std::string& part) {
    expect_has(report, part);
    return report.find(part);
  };
  EXPECT_LT(at("(`sg-offset`)\n"), at("](plots/lobe.svg)"));
  EXPECT_LT(at("](plots/offset.svg)"), at("(`fresnel-one-term`)\n"));
  EXPECT_LT(at("(`fresnel-quadratic`)\n"), at("](plots/fresnel-errors.svg)"));
  EXPECT_LT(at("(`phong-blinn`)\n"), at("](plots/phong-blinn-errors.svg)"));
  for (const Figure& f : figures) expect_has(report, f.caption);
  expect_lacks(write_report(results), "plots/");
}

TEST(PlotData, AnglesKeepTheirEnds) {
  EXPECT_EQ(cosine_of_degrees(0).cos_theta, 1);
  EXPECT_EQ(cosine_of_degrees(0).one_minus_cos, 0);
  EXPECT_EQ(cosine_of_degrees(90).cos_theta, 0);
  EXPECT_TRUE(is_close("60", Decimal50("0.5"), cosine_of_degrees(60).cos_theta, 1e-15));
  EXPECT_TRUE(is_close("60", 60, degrees_of(cosine_of_degrees(60)), 1e-14));
  EXPECT_EQ(printed("fresnel-quadratic-a"), "-5.55473");
  EXPECT_EQ(typeset("-5.55473"), "−5.55473");
  EXPECT_EQ(typeset("4.2"), "4.2");
  EXPECT_THROW(printed("none"), std::logic_error);
}

TEST(PlotScript, ARangeHoldsAllItsNumbers) {
  const Table table{{"a", "b"}, {{Number{-0.0371, 6}, Number{7, 6}}, {Number{0.041, 6}, {}}}};
  EXPECT_EQ(range_around(table, {{"a", "", Look::first}}), "[-0.04:0.045]");
  EXPECT_EQ(range_around(table, {{"a", "", Look::first, true}}), "[-4:4.5]") << "in percent";
}

}  // namespace
}  // namespace shadefit
