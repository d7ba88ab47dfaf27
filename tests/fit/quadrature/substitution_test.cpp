#include "fit/quadrature/substitution.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "fit/quadrature/gauss.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

struct Case {
  Metric metric;
  Shape shape;
};

const Case cases[] = {
    {{.measure = Measure::cosine}, {}},
    {{.measure = Measure::angle}, {}},
    {{.measure = Measure::cosine}, {.concentration = 0.2, .end_power = 0.1}},
    {{.measure = Measure::angle}, {.concentration = 5, .end_power = 2.5}},
    {{.measure = Measure::cosine}, {.concentration = 2e6, .end_power = 1e6}},
    {{.measure = Measure::angle}, {.concentration = 2e6, .end_power = 1e6}},
    {{.measure = Measure::cosine_weighted}, {.concentration = 5, .end_power = 2.5}},
    {{.measure = Measure::cosine, .domain = {0.25, 0.75}}, {.end_power = 0.5}},
    {{.measure = Measure::angle, .domain = {0.25, 0.75}}, {.end_power = 0.5}},
};

TEST(Substitution, CosineAndComplementBelongTogether) {
  for (const auto& [metric, shape] : cases) {
    const Substitution substitution(metric, shape);
    for (const double s : {0.0, 1e-9, 0.1, 0.5, 0.9, 1.0}) {
      const auto c = substitution.at(s).cosine;
      EXPECT_NEAR(c.cos_theta + c.one_minus_cos, 1, 4e-16) << name(metric.measure) << " " << s;
      EXPECT_GE(c.cos_theta, metric.domain.lower - 1e-16);
      EXPECT_LE(c.cos_theta, metric.domain.upper + 1e-16);
    }
  }
}

// Both keep their digits: against the same places in long double, relatively, down to 1 - c = 1e-16.
TEST(Substitution, CosineAndComplementKeepTheirDigits) {
  for (const auto& [metric, shape] : cases) {
    const Substitution substitution(metric, shape);
    for (const double s : {1e-9, 1e-3, 0.1, 0.5, 0.75}) {
      const auto narrow = substitution.at(s).cosine;
      const auto wide = substitution.at(static_cast<long double>(s)).cosine;
      EXPECT_NEAR(static_cast<double>(narrow.one_minus_cos / wide.one_minus_cos - 1), 0, 1e-15)
          << name(metric.measure) << " " << s;
      // (1 - s)^q with q up to 8, and the sine of what is left of the angle
      EXPECT_NEAR(static_cast<double>(narrow.cos_theta / wide.cos_theta - 1), 0, 4e-15)
          << name(metric.measure) << " " << s;
    }
  }
}

TEST(Substitution, EndsAreTheEndsOfTheDomainOrTheCut) {
  for (const auto& [metric, shape] : cases) {
    const Substitution substitution(metric, shape);
    const auto top = substitution.at(0.0).cosine, bottom = substitution.at(1.0).cosine;
    EXPECT_NEAR(top.cos_theta, metric.domain.upper, 1e-16);
    const double cut =
        shape.concentration > 0 ? 1 - metric.domain.upper + Substitution::decay / shape.concentration : 1;
    EXPECT_NEAR(bottom.one_minus_cos, std::min(cut, 1 - metric.domain.lower), 4e-16);
  }
  EXPECT_EQ(Substitution({.measure = Measure::cosine}, {}).at(1.0).cosine.cos_theta, 0);
  EXPECT_EQ(Substitution({.measure = Measure::angle}, {}).at(1.0).cosine.cos_theta, 0);
}

// The density is the derivative of the measure: of c for the cosine, of theta for the angle (dc = sin
// dtheta).
TEST(Substitution, DensityIsThatOfTheMeasure) {
  using Jet = ceres::Jet<double, 1>;
  for (const auto& [metric, shape] : cases) {
    const Substitution substitution(metric, shape);
    for (const double s : {0.1, 0.5, 0.9}) {
      const auto place = substitution.at(Jet(s, 0));
      const double y = place.cosine.one_minus_cos.a;
      const double c = place.cosine.cos_theta.a;
      // of the variable: dc, d theta = dc / sin(theta), c dc
      const double sine = metric.measure == Measure::angle             ? std::sqrt(y * (2 - y))
                          : metric.measure == Measure::cosine_weighted ? 1 / c
                                                                       : 1;
      // Each of c and 1 - c loses digits of its derivative at its far end, where the power map is flat.
      EXPECT_NEAR(place.cosine.one_minus_cos.v[0] / (place.density.a * sine), 1, 1e-9);
      EXPECT_NEAR(-place.cosine.cos_theta.v[0] / (place.density.a * sine), 1, 1e-9);
    }
  }
}

TEST(Gauss, RulesIntegratePolynomialsExactly) {
  for (const unsigned size : gauss_sizes) {
    std::vector<std::pair<long double, long double>> nodes;
    visit_gauss_rule<long double>(size, [&](long double x, long double w) { nodes.emplace_back(x, w); });
    ASSERT_EQ(nodes.size(), size);
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
    for (const int degree : {0, 1, 2, static_cast<int>(2 * size) - 1}) {
      long double sum = 0;
      for (const auto& [x, w] : nodes) sum += w * power(x, degree);
      // a weighted mean of numbers below 1: rounding, times the degree for the power
      EXPECT_LE(std::abs(sum * (degree + 1) - 1), 1e-18L * (degree + 10)) << size << " " << degree;
    }
  }
  EXPECT_THROW(visit_gauss_rule<double>(gauss_sizes.back() + 2, [](double, double) {}), std::out_of_range);
}

// The power map is what makes a fractional power converge: without it 38 nodes leave six digits of this one.
TEST(Substitution, FractionalPowersConvergeFast) {
  const auto integral = [](const Shape& shape) {
    const Substitution substitution({}, shape);
    long double sum = 0;
    visit_gauss_rule<long double>(38, [&](long double x, long double w) {
      const auto place = substitution.at(x);
      sum += w * place.density * std::pow(place.cosine.cos_theta, 0.1L);
    });
    return std::abs(static_cast<double>(sum * 1.1L - 1));
  };
  EXPECT_LT(integral({.end_power = 0.1}), 1e-15);
  EXPECT_GT(integral({.end_power = 0}), 1e-6);
}

}  // namespace
}  // namespace shadefit
