#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "fit/formula/parse_formula.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/truths/albedos.hpp"
#include "fit/truths/graded_rule.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

namespace shadefit {
namespace {

constexpr double albedo_pi = std::numbers::pi;
/// What docs/truths.md promises.
constexpr double albedo_tolerance = 1e-12;

Symbolic formula_of(const std::string& text) {
  return read_formula(text, {.variables = {"c", "alpha"}, .takes_integrals = true}).formula;
}

double value_of(const std::string& truth, double c, double alpha) {
  return evaluate<double>(formula_of(truth + "(c, alpha)"),
                          [&](const std::string& name) { return name == "c" ? c : alpha; });
}

double by_rule(const std::string& truth, double c, double alpha) {
  return albedo_by_rule(*find_albedo(truth), c, alpha);
}

/// The truths of tests/references/albedo.csv.
const std::map<std::string, std::string> names_of_references{
    {"ggx-height-correlated", "ggx_albedo"},
    {"ggx-separable", "ggx_albedo_separable"},
    {"ggx-schlick", "ggx_albedo_k"},
    {"ggx-height-correlated-scale", "ggx_scale"},
    {"ggx-height-correlated-bias", "ggx_bias"},
    {"ggx-separable-scale", "ggx_scale_separable"},
    {"ggx-separable-bias", "ggx_bias_separable"},
    {"ggx-schlick-scale", "ggx_scale_k"},
    {"ggx-schlick-bias", "ggx_bias_k"},
    {"sheen-neubelt", "imageworks_sheen_albedo"},
    {"sheen-charlie", "charlie_albedo"},
};

TEST(Albedos, AgreeWithReferencesOf20Digits) {
  const CsvTable table =
      parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/references/albedo.csv"), "albedo.csv");
  int count = 0;
  for (const auto& row : table.rows) {
    const auto name = names_of_references.find(row[0]);
    if (name == names_of_references.end()) continue;
    const double c = std::stod(row[1]), alpha = std::stod(row[2]), truth = std::stod(row[3]);
    // The albedo of sheen may be greater than 1.
    const double tolerance = albedo_tolerance * std::max(1.0, truth);
    EXPECT_NEAR(value_of(name->second, c, alpha), truth, tolerance)
        << name->second << row[1] << ' ' << row[2];
    if (find_albedo(name->second)) {
      EXPECT_NEAR(by_rule(name->second, c, alpha), truth, tolerance) << name->second;
    }
    ++count;
  }
  EXPECT_EQ(count, 9 * 16 + 2 * 15);
}

using Masking = double (*)(double c, double l, double alpha);

double smith_root(double x, double alpha) {
  return std::sqrt(alpha * alpha + (1 - alpha * alpha) * x * x);
}

/// G2/c.
const std::map<std::string, Masking> maskings{
    {"", [](double c, double l,
            double alpha) { return 2 * l / (c * smith_root(l, alpha) + l * smith_root(c, alpha)); }},
    {"_separable",
     [](double c, double l, double alpha) {
       return 4 * l / ((c + smith_root(c, alpha)) * (l + smith_root(l, alpha)));
     }},
    {"_k",
     [](double c, double l, double alpha) {
       const double k = alpha / 2;
       return l / ((c * (1 - k) + k) * (l * (1 - k) + k));
     }},
};

/// Albedo and bias by another integral: over the slopes of the visible normals, in polar coordinates, up to
/// where the light sets.
std::array<double, 2> by_normals(Masking masking, double c, double alpha) {
  const double s = std::sqrt(1 - c * c);
  const auto nodes = [](double k) { return static_cast<std::size_t>(40 + 5 * k); };
  std::array<double, 2> sums{};
  for (const double sign : {1.0, -1.0}) {
    visit_graded(c, albedo_pi / 2, nodes, [&](double chi, double outer) {
      const double toward_view = sign * std::sin(chi), root = std::hypot(s * toward_view, c);
      const double end = toward_view > 0 ? (root + s * toward_view) / c : c / (root - s * toward_view);
      const double last = std::asinh(end / alpha);
      const auto add = [&](double u, double inner) {
        const double slope = alpha * std::sinh(u), toward = c + s * slope * toward_view;
        const double l = 2 * toward / (1 + slope * slope) - c;
        const double weight = 2 / albedo_pi * outer * inner * toward * std::sinh(u) /
                              std::pow(std::cosh(u), 3) * masking(c, l, alpha);
        sums[0] += weight;
        sums[1] += weight * std::pow(1 - toward / std::sqrt(1 + slope * slope), 5);
      };
      for (const RuleNode& node : gauss_on_unit(64)) add(node.position * last / 2, node.weight * last / 2);
      visit_graded(alpha, last / 2, nodes, [&](double u, double weight) { add(last - u, weight); });
    });
  }
  return sums;
}

TEST(Albedos, OfGgxAgreeWithAnIntegralOverVisibleNormals) {
  for (const auto& [suffix, masking] : maskings) {
    for (const auto& place :
         {std::pair(0.02, 0.05), {0.07, 0.3}, {0.3, 0.02}, {0.8, 0.8}, {0.3, 1e-4}, {0.001, 1e-4}}) {
      const double c = place.first, alpha = place.second;
      const auto [albedo, bias] = by_normals(masking, c, alpha);
      EXPECT_NEAR(value_of("ggx_albedo" + suffix, c, alpha), albedo, albedo_tolerance) << suffix << c;
      EXPECT_NEAR(value_of("ggx_bias" + suffix, c, alpha), bias, albedo_tolerance) << suffix << c;
    }
  }
}

/// The albedo of sheen by an integral over the half vectors, in polar coordinates about the normal, up to
/// where the light sets. The visibility is at most `most`: it is cut off at none, one or two of these half
/// vectors, and the two meet at one azimuth.
double sheen_by_normals(double c, double alpha, double most) {
  const double s = std::sqrt(1 - c * c), cut = std::max(0.0, (1 / (4 * most) - c) / (1 - c));
  const auto nodes = [](double k) { return static_cast<std::size_t>(60 + 5 * k); };
  double sum = 0;
  const auto add_azimuth = [&](double sine, double outer) {
    const double r = std::hypot(c, s * sine), end = std::atan2(c, -s * sine) / 2;
    std::vector<double> ends{0, end};  // distances from where the light sets
    if (0 < cut && cut < r) {
      const double turn = std::asin(cut / r) / 2;
      for (const double place : {turn, albedo_pi / 2 - turn})
        if (place < end) ends.push_back(place);
    }
    std::sort(ends.begin(), ends.end());
    const auto add = [&](double t, double inner) {
      const double theta = end - t, l = r * std::sin(2 * t);
      const double half = c * std::cos(theta) + s * std::sin(theta) * sine;
      sum += outer * inner * std::pow(std::sin(theta), 1 + 1 / alpha) * half * l *
             std::min(most, 1 / (4 * (l + c - l * c)));
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double low = ends[i], high = ends[i + 1], middle = (high - low) / 2;
      visit_graded(c / r, middle, nodes, [&](double t, double weight) { add(low + t, weight); });
      visit_graded(c, middle, nodes, [&](double t, double weight) { add(high - t, weight); });
    }
  };
  for (const double sign : {1.0, -1.0}) {
    const auto add = [&](double chi, double weight) { add_azimuth(sign * std::sin(chi), weight); };
    if (cut <= c) {
      visit_graded(c, albedo_pi / 2, nodes, add);
      continue;
    }
    // Where the two meet there is a root of the distance.
    const double meet = std::asin(std::sqrt(cut * cut - c * c) / s), root = std::sqrt(c);
    visit_graded(c, meet / 2, nodes, add);
    visit_graded(root, std::sqrt(meet / 2), nodes,
                 [&](double t, double weight) { add(meet - t * t, 2 * t * weight); });
    visit_graded(root, std::sqrt(albedo_pi / 2 - meet), nodes,
                 [&](double t, double weight) { add(meet + t * t, 2 * t * weight); });
  }
  return (2 + 1 / alpha) / (2 * albedo_pi) * 8 * sum;
}

TEST(Albedos, OfSheenAgreeWithAnIntegralOverHalfVectors) {
  for (const auto& place : {std::pair(0.03, 0.2), {0.2, 0.07}, {0.5, 0.3}, {0.9, 0.9}, {0.005, 1e-4}}) {
    const double c = place.first, alpha = place.second;
    EXPECT_NEAR(value_of("imageworks_sheen_albedo", c, alpha), sheen_by_normals(c, alpha, 1e300),
                albedo_tolerance)
        << c;
    EXPECT_NEAR(value_of("charlie_albedo", c, alpha), sheen_by_normals(c, alpha, 1), albedo_tolerance) << c;
  }
}

/// Places between those of the table, from the sequence of the golden ratio.
template <class Visit>
void visit_places(int count, double least_log_c, double least_log_alpha, const Visit& visit) {
  double first = 0, second = 0;
  for (int i = 0; i < count; ++i) {
    first = std::fmod(first + 0.7548776662466927, 1);
    second = std::fmod(second + 0.5698402909980532, 1);
    visit(std::exp(least_log_c * first), std::exp(least_log_alpha * second));
  }
}

/// The largest difference of a table and its rule, relative to the larger of 1 and the value.
double interpolation_error(const std::string& name, int count, double least_log_c, double least_log_alpha) {
  double most = 0;
  visit_places(count, least_log_c, least_log_alpha, [&](double c, double alpha) {
    const double exact = by_rule(name, c, alpha);
    most = std::max(most, std::abs(value_of(name, c, alpha) - exact) / std::max(1.0, exact));
  });
  return most;
}

TEST(Albedos, AreInterpolatedTo1e12) {
  for (const std::string name : {"ggx_bias", "ggx_bias_separable", "ggx_bias_k"})
    EXPECT_LT(interpolation_error(name, 200, -4, -6), albedo_tolerance) << name;
  for (const std::string name : {"charlie_albedo", "imageworks_sheen_albedo"})
    EXPECT_LT(interpolation_error(name, 200, -3, -4), albedo_tolerance) << name;
}

// The rules of the others take seconds for so many places: .ci/release runs them.
TEST(Albedos, WithoutFresnelAreInterpolatedTo1e12At10000Places) {
  for (const std::string name : {"ggx_albedo", "ggx_albedo_separable", "ggx_albedo_k"})
    EXPECT_LT(interpolation_error(name, 10000, -30, -9.9), albedo_tolerance) << name;
}

class AlbedosAt10000Places : public testing::TestWithParam<const char*> {};

TEST_P(AlbedosAt10000Places, AreInterpolatedTo1e12) {
  const double least = std::log(1e-4);
  EXPECT_LT(interpolation_error(GetParam(), 10000, least, least), albedo_tolerance);
}

INSTANTIATE_TEST_SUITE_P(Tables, AlbedosAt10000Places,
                         testing::Values("ggx_bias", "ggx_bias_separable", "ggx_bias_k", "charlie_albedo",
                                         "imageworks_sheen_albedo"));

TEST(Albedos, HaveTheirClosedFormsWhereThereAreSome) {
  for (const double c : {1e-9, 0.01, 0.2, 0.7, 1.0}) {
    EXPECT_NEAR(value_of("ggx_albedo", c, 1), 1 - c * std::log1p(1 / c), albedo_tolerance) << c;
    EXPECT_NEAR(value_of("ggx_albedo_separable", c, 1), 2 * (1 - std::log(2.0)) / (1 + c), albedo_tolerance);
    EXPECT_NEAR(value_of("ggx_albedo_k", c, 1), 2 * (1 - std::log(2.0)) / (1 + c), albedo_tolerance) << c;
  }
  for (const double c : {0.01, 0.5}) {
    // The integral of (1 - (c + l)/2) l/(c + (1 - c) l) over l.
    const double r = c / (1 - c), logarithm = r * std::log(1 / c);
    const double whole = ((1 - c / 2) * (1 - logarithm) - (0.5 - r + r * logarithm) / 2) / (1 - c);
    EXPECT_NEAR(value_of("imageworks_sheen_albedo", c, 0.5), whole, albedo_tolerance) << c;
  }
  for (const double alpha : {0.02, 0.3, 1.0}) {
    // sin^2 h = (1 - l)/2 for every azimuth.
    const double m = 1 / (2 * alpha), beta = 1 / ((m + 1) * (m + 2));
    EXPECT_NEAR(value_of("imageworks_sheen_albedo", 1, alpha), (2 + 1 / alpha) / 4 * std::exp2(-m) * beta,
                albedo_tolerance)
        << alpha;
  }
}

TEST(Albedos, HaveTheirLimits) {
  // A surface of small alpha is a mirror.
  EXPECT_NEAR(value_of("ggx_albedo", 0.5, 1e-4), 1, 1e-6);
  EXPECT_NEAR(value_of("ggx_bias", 0.5, 1e-4), std::pow(0.5, 5), 1e-6);
  EXPECT_NEAR(value_of("ggx_albedo", 0.5, 0), 1, 1e-6) << "counts as e^-10";
  // Height-correlated masking loses no light at grazing angles.
  for (const double alpha : {0.001, 0.1, 1.0}) {
    EXPECT_NEAR(value_of("ggx_albedo", 0, alpha), 1, albedo_tolerance) << alpha;
    EXPECT_LT(value_of("ggx_albedo", 1e-6, alpha), 1) << alpha;
  }
  EXPECT_TRUE(std::isnan(value_of("ggx_albedo", 1.01, 0.5)));
  EXPECT_TRUE(std::isnan(value_of("ggx_albedo", 0.5, -0.01)));
  EXPECT_TRUE(std::isnan(value_of("ggx_albedo", -0.01, 0.5)));
  EXPECT_TRUE(std::isnan(value_of("ggx_albedo", 0.5, 1.01)));
  EXPECT_EQ(value_of("ggx_albedo", 0.5, 1 + 1e-15), value_of("ggx_albedo", 0.5, 1));
}

TEST(Albedos, HaveTheSameValueInEveryScalar) {
  const Symbolic formula = formula_of("ggx_albedo(c, alpha)");
  const std::vector<std::string> names{"c", "alpha"};
  for (const auto& place : {std::pair(0.3, 0.2), {1e-9, 0.04}}) {
    const double c = place.first, alpha = place.second;
    const auto value_of_name = [&](const std::string& name) { return name == "c" ? c : alpha; };
    const long double wide = evaluate<long double>(
        formula, [&](const std::string& name) -> long double { return value_of_name(name); });
    EXPECT_NEAR(static_cast<double>(wide), value_of("ggx_albedo", c, alpha), 1e-14);
    const Decimal50 widest =
        in_50_digits(formula, [&](const std::string& name) -> Decimal50 { return value_of_name(name); });
    EXPECT_EQ(static_cast<long double>(widest), wide);
    TapeProgram<TwoLanes> program(tape_of(formula, names), {});
    program.run(std::array{TwoLanes(c, alpha), TwoLanes(alpha, c)});
    const TwoLanes both = program.output(0);
    EXPECT_EQ(both[0], value_of("ggx_albedo", c, alpha));
    EXPECT_EQ(both[1], value_of("ggx_albedo", alpha, c));
  }
}

TEST(Albedos, HaveDerivatives) {
  const std::vector<std::string> names{"c", "alpha"};
  Graph graph(names);
  const int value = graph.add(formula_of("ggx_albedo(c, alpha^2)"));
  std::vector<int> outputs{value}, inputs;
  for (const std::string& name : names) inputs.push_back(graph.add(Symbolic::variable(name)));
  const int by_c = graph.derivative(value, 0), by_alpha = graph.derivative(value, 1);
  outputs.insert(outputs.end(),
                 {by_c, by_alpha, graph.derivative(by_c, 0), graph.derivative(by_c, 1),
                  graph.derivative(by_alpha, 1), graph.derivative(graph.derivative(by_c, 0), 0)});
  TapeProgram<double> program(Tape(graph, outputs, inputs), {});
  const auto at = [&](double c, double alpha) {
    program.run(std::array{c, alpha});
    std::vector<double> found;
    for (std::size_t i = 0; i < outputs.size(); ++i) found.push_back(program.output(i));
    return found;
  };
  // In the second place c is in the last row of the table, which has another variable.
  for (const auto& place : {std::pair(0.3, 0.5), {0.002, 0.9}}) {
    const double c = place.first, alpha = place.second;
    const double h = 1e-4 * c, g = 1e-4 * alpha;
    const auto here = at(c, alpha), right = at(c + h, alpha), left = at(c - h, alpha);
    const auto above = at(c, alpha + g), below = at(c, alpha - g);
    const auto expect_slope = [&](std::size_t i, double from, double to, double width) {
      EXPECT_NEAR(here[i], (to - from) / width, 1e-6 * std::max(std::abs(here[i]), 1e-3)) << i << " at " << c;
    };
    expect_slope(1, left[0], right[0], 2 * h);
    expect_slope(2, below[0], above[0], 2 * g);
    expect_slope(3, left[1], right[1], 2 * h);
    expect_slope(4, below[1], above[1], 2 * g);
    expect_slope(5, below[2], above[2], 2 * g);
    expect_slope(6, left[3], right[3], 2 * h);
  }
  EXPECT_THROW(graph.derivative(outputs.back(), 0), std::logic_error);
}

TEST(Albedos, AreDoubleIntegralsWithRootsAtZero) {
  EXPECT_EQ(integral_depth(formula_of("1 + ggx_scale(c, alpha)")), 2);
  EXPECT_EQ(to_text(formula_of("2 ggx_albedo(c, alpha)")), "2 ggx_albedo(c, alpha)");
}

}  // namespace
}  // namespace shadefit
