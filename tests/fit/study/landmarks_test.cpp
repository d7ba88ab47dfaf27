#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "app/studies/find_study.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/study/study.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

/// Numbers of the literature, closed forms and limits that the truths of the committed studies have to meet.
namespace shadefit {
namespace {

const std::filesystem::path studies_folder = std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies";

/// The target of a study as a function of its variables. A constant of `given` has this value instead of its
/// own.
std::function<double(std::vector<double>)> target_of(const std::string& id,
                                                     const std::map<std::string, std::string>& given = {}) {
  const StudyFile file = load_study(studies_folder / (id + ".toml"));
  Study study = file.study;
  study.form = file.forms.front().formula;
  study.given = given;
  const ReadStudy read = read_formulas(study);
  std::vector<std::string> variables;
  for (const StudyAxis& axis : read.axes) variables.push_back(axis.variable);
  const Tape tape = tape_of(read.target, variables);
  return [tape](const std::vector<double>& place) {
    TapeProgram<double> program(tape, {});
    program.run(place);
    return program.output(0);
  };
}

/// Gauss-Legendre with 60 nodes.
template <class F>
double integral(const F& f, double from, double to) {
  return boost::math::quadrature::gauss<double, 60>::integrate(f, from, to);
}

/// The reflectance of unpolarised light by Fresnel's equations, written for the two refracted cosines.
double unpolarised(double cosine, double n) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  const double s = (cosine - n * inside) / (cosine + n * inside),
               p = (n * cosine - inside) / (n * cosine + inside);
  return (s * s + p * p) / 2;
}

// Walsh 1926, "The reflection factor of a polished glass surface for diffused light"; Duntley 1942, "The
// optical properties of diffusing materials", J. Opt. Soc. Am. 32, prints 0.0918 for n = 1.5 from outside and
// 0.596 from inside.
TEST(Landmarks, TheFresnelAverageOfGlass) {
  const double average = integral([](double c) { return 2 * c * unpolarised(c, 1.5); }, 0, 1);
  EXPECT_NEAR(average, 0.0918, 0.00005);
  for (const char* id : {"fresnel-average", "fresnel-average-inverse", "fresnel-average-quotient"})
    EXPECT_NEAR(target_of(id)({1.5}), average, 1e-13) << id;
  // Seen from inside; the index of one of these is that of the air against the glass.
  const double inside = 1 - (1 - average) / 2.25;
  EXPECT_NEAR(inside, 0.596, 0.0005);
  EXPECT_NEAR(target_of("fresnel-inside")({1.5}), inside, 1e-13);
  EXPECT_NEAR(target_of("fresnel-inside-cubic")({1 / 1.5}), inside, 1e-13);
}

// Without a step of the index nothing is reflected, and with a large one nearly all.
TEST(Landmarks, TheFresnelAverageAtItsLimits) {
  EXPECT_NEAR(target_of("fresnel-average")({1.001}),
              integral([](double t) { return 4 * t * t * t * unpolarised(t * t, 1.001); }, 0, 1), 1e-7);
  EXPECT_LT(target_of("fresnel-average")({1.001}), 0.001);
  EXPECT_GT(target_of("fresnel-average-quotient")({400}), 0.98);
  EXPECT_LT(target_of("fresnel-average-quotient")({400}), 1);
}

// The integral of 2 m (1 - m)^5 is 1/21.
TEST(Landmarks, TheAverageOfSchlicksTerm) {
  const auto average = target_of("schlick-average");
  EXPECT_NEAR(average({0}), 1.0 / 21, 1e-14);
  EXPECT_NEAR(average({0.04}), 0.04 + 0.96 / 21, 1e-14);
  EXPECT_NEAR(average({1}), 1, 1e-14);
}

// Henyey, Greenstein 1941: over the sphere it has the integral 1 and the mean cosine g.
TEST(Landmarks, HenyeyGreensteinIsAPhaseFunction) {
  for (const char* g : {"0", "0.3", "0.6", "0.8"}) {
    const auto phase = target_of("hg-schlick", {{"g", g}});
    const auto moment = [&](int power) {
      return integral([&](double c) { return 2 * std::numbers::pi * std::pow(c, power) * phase({c}); }, -1,
                      1);
    };
    EXPECT_NEAR(moment(0), 1, 1e-9) << g;
    EXPECT_NEAR(moment(1), std::stod(g), 1e-9) << g;
  }
  EXPECT_NEAR(target_of("hg-schlick", {{"g", "0"}})({0.5}), 1 / (4 * std::numbers::pi), 1e-15);
}

/// The albedo of a half-space that scatters evenly in all directions, under light from all directions: 1 - 2
/// sqrt(1 - w) times the first moment of H, by Chandrasekhar 1960, "Radiative Transfer". H is found by
/// iteration.
double diffuse_albedo(double w) {
  constexpr int count = 200;
  const double s = std::sqrt(1 - w);
  std::vector<double> h(count, 1);
  const auto cosine = [](int i) { return (i + 0.5) / count; };
  for (int step = 0; step < 100; ++step) {
    std::vector<double> next;
    for (int i = 0; i < count; ++i) {
      double sum = 0;
      for (int k = 0; k < count; ++k)
        sum += h[static_cast<std::size_t>(k)] * cosine(k) / (cosine(i) + cosine(k)) / count;
      next.push_back(1 / (s + w / 2 * sum));
    }
    h = next;
  }
  double first = 0;
  for (int i = 0; i < count; ++i) first += h[static_cast<std::size_t>(i)] * cosine(i) / count;
  return 1 - 2 * s * first;
}

// Van de Hulst 1980, "Multiple Light Scattering", gives (1 - s)(1 - 0.139 s)/(1 + 1.17 s), accurate to about
// 0.002, for this albedo with s = sqrt(1 - w). The study has the inverse.
TEST(Landmarks, VanDeHulst) {
  const auto similarity = target_of("van-de-hulst-inverse");
  EXPECT_NEAR(similarity({0}), 1, 1e-13);
  EXPECT_NEAR(similarity({1}), 0, 1e-13);
  for (const double w : {0.2, 0.5, 0.8, 0.95}) {
    const double s = std::sqrt(1 - w);
    EXPECT_NEAR(similarity({(1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s)}), s, 1e-13);
    EXPECT_NEAR(diffuse_albedo(w), (1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s), 0.0025) << w;
    EXPECT_NEAR(similarity({diffuse_albedo(w)}), s, 0.004) << w;  // 0.0021 over a slope of 0.6
  }
}

// Burley 2012, "Physically-based shading at Disney": the product of two Schlick terms, over all directions.
TEST(Landmarks, BurleysAlbedoIsItsIntegral) {
  const auto albedo = target_of("burley-albedo");
  for (const double x : {0.0, 0.3, 1.0}) {
    for (const double r : {0.0, 0.5, 1.0}) {
      const auto around = [&](double l) {
        return integral(
            [&](double turn) {
              const double vl = x * l + std::sqrt((1 - x * x) * (1 - l * l)) * std::cos(turn);
              const double edge = 0.5 + 2 * r * (1 + vl) / 2 - 1;  // (l.h)^2 = (1 + l.v)/2
              return 2 / std::numbers::pi * l * (1 + edge * std::pow(1 - l, 5)) *
                     (1 + edge * std::pow(1 - x, 5));
            },
            0, std::numbers::pi);
      };
      EXPECT_NEAR(albedo({x, r}), integral([&](double t) { return 2 * t * around(1 - t * t); }, 0, 1), 1e-12)
          << x << ", " << r;
    }
  }
}

// Oren, Nayar 1994, the qualitative model: Lambert's at r = 0, and A alone from above.
TEST(Landmarks, OrenNayar) {
  const auto albedo = target_of("oren-nayar-albedo");
  for (const double x : {0.0, 0.4, 1.0}) EXPECT_NEAR(albedo({x, 0}), 1, 1e-15);
  for (const double r : {0.3, 1.0}) {
    const double a = 1 - 0.5 * r * r / (r * r + 0.33), b = 0.45 * r * r / (r * r + 0.09);
    EXPECT_NEAR(albedo({1, r}), a, 1e-15);
    // The positive cosines of the azimuth have the integral 2.
    const double view = 1.1;
    const auto ring = [&](double light) {
      const double most = std::max(view, light), least = std::min(view, light);
      return 2 / std::numbers::pi * b * std::sin(most) * std::tan(least) * std::cos(light) * std::sin(light);
    };
    EXPECT_NEAR(albedo({std::cos(view), r}),
                a + integral(ring, 0, view) + integral(ring, view, std::numbers::pi / 2), 1e-13);
  }
}

// Portsmouth, Kutz, Hill 2025: the average of G/pi over the hemisphere is 2/3 - 28/(15 pi); from above G is
// 0.
TEST(Landmarks, FujiisOrenNayar) {
  const auto albedo = target_of("fon-albedo");
  EXPECT_NEAR(albedo({1}), 1, 1e-15);
  const double average = integral(
      [&](double angle) { return 2 * std::sin(angle) * std::cos(angle) * albedo({std::cos(angle)}); }, 0,
      std::numbers::pi / 2);
  EXPECT_NEAR(average, 1 + 2.0 / 3 - 28 / (15 * std::numbers::pi), 1e-12);
}

/// The rows of a table as numbers: the variables, then the value.
std::vector<std::vector<double>> rows_of(const std::string& name) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : parse_csv(read_file(studies_folder / (name + ".csv")), name).rows) {
    rows.emplace_back();
    for (const std::string& cell : row) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

constexpr double table_rounding = 2e-12;  // a table has 12 digits

// A white furnace: with f0 = 1 Schlick's Fresnel term is 1, and scale + bias is the albedo of GGX alone. It
// is at most 1. Where alpha = 1 all half vectors are as likely, and separable masking gives 2 (1 - ln 2)/(1 +
// x), with Smith's own and with Schlick's.
TEST(Landmarks, WhiteFurnace) {
  const auto closed = [](double x) { return 2 * (1 - std::log(2.0)) / (1 + x); };
  int rough = 0;
  for (const std::string name : {"karis", "materialx-ggx"}) {
    const auto scale = rows_of(name + "-scale"), bias = rows_of(name + "-bias");
    ASSERT_EQ(scale.size(), bias.size());
    for (std::size_t i = 0; i < scale.size(); ++i) {
      ASSERT_EQ(scale[i][0], bias[i][0]);
      ASSERT_EQ(scale[i][1], bias[i][1]);
      const double sum = scale[i][2] + bias[i][2];
      EXPECT_GT(scale[i][2], 0);
      EXPECT_GT(bias[i][2], 0);
      EXPECT_LT(sum, 1 + table_rounding) << name << ", row " << i;
      if (name == "karis" && scale[i][1] == 1) {
        EXPECT_NEAR(sum, closed(scale[i][0]), table_rounding) << "row " << i;
        ++rough;
      }
    }
  }
  for (const auto& row : rows_of("conductor-albedo")) {
    EXPECT_LT(row[2], 1 + table_rounding);
    if (row[1] == 1) {
      EXPECT_NEAR(row[2], closed(std::max(row[0], 0.02)), table_rounding) << row[0];
      ++rough;
    }
  }
  EXPECT_EQ(rough, 25 + 32);
}

// A surface without roughness is a mirror: bias is (1 - x)^5, scale the rest. At alpha = 0.0025 and away from
// the horizon the albedo is that up to some alpha^2, and with Schlick's masking up to alpha.
TEST(Landmarks, AMirror) {
  int smooth = 0;
  const auto scale = rows_of("karis-scale"), bias = rows_of("karis-bias");
  for (std::size_t i = 0; i < scale.size(); ++i) {
    if (scale[i][1] != 0.05 || scale[i][0] < 0.5) continue;
    EXPECT_NEAR(bias[i][2], std::pow(1 - scale[i][0], 5), 0.001) << scale[i][0];
    EXPECT_NEAR(scale[i][2] + bias[i][2], 1, 0.003) << scale[i][0];
    ++smooth;
  }
  for (const auto& row : rows_of("conductor-albedo")) {
    if (row[1] != 0 || row[0] < 0.5) continue;
    EXPECT_NEAR(row[2], 1, 1e-4) << row[0];
    ++smooth;
  }
  EXPECT_GT(smooth, 25);
}

// From above sin^2 of the half vector is (1 - l)/2 all around, and the albedo of sheen is a beta function.
TEST(Landmarks, SheenFromAbove) {
  int above = 0;
  for (const auto& row : rows_of("three-sheen")) {
    if (row[0] != 1) continue;
    const double m = 1 / (2 * row[1] * row[1]);
    EXPECT_NEAR(row[2], (1 + m) / 2 * std::exp2(-m) / ((m + 1) * (m + 2)), table_rounding) << row[1];
    ++above;
  }
  EXPECT_EQ(above, 25);
}

}  // namespace
}  // namespace shadefit
