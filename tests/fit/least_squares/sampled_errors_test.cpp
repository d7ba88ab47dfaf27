#include "fit/least_squares/sampled_errors.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"

namespace shadefit {
namespace {

/// A family's scale times its error against its own formula of the relative error.
template <class F>
void expect_relative_scale(const F& family, const std::array<double, F::parameters.size()>& p) {
  for (const double c : {0.75, 0.9, 1.0}) {
    const auto sample = family.sample(Cosine<double>{c, 1 - c});
    const double scaled = family.relative_scale(sample) * family.error(sample, p);
    const double expected = family.relative_error(sample, p);
    // Form and target are at most 1 and rounded to 1e-16; the scale is below 35.
    EXPECT_NEAR(scaled, expected, 1e-14 * (1 + std::abs(expected))) << F::info.id << " c = " << c;
  }
}

TEST(LeastSquares, TheScaleOfARelativeErrorIsItsRatioToTheError) {
  expect_relative_scale(SgOffset{{12}}, {0.5});
  expect_relative_scale(SgScaled{{12}}, {1.1, 0.5});
  expect_relative_scale(PhongBlinn{{12}}, {4.5});
  for (const Surface& surface : {Surface{}, exact_surface(1.5), exact_surface(0.2, 3)}) {
    expect_relative_scale(FresnelOneTerm{{surface}}, {9});
    expect_relative_scale(FresnelQuadratic{{surface}}, {-5, -7});
    expect_relative_scale(FresnelCubic{{surface}}, {-1, -5, -7});
    expect_relative_scale(FresnelQuartic{{surface}}, {-1, -1, -5, -7});
    expect_relative_scale(FresnelFourth{{surface}}, {0.9});
    expect_relative_scale(FresnelSquare{{surface}}, {2, -2});
    expect_relative_scale(FresnelRational{{surface}}, {0.5});
  }
}

// Of three parameters, any are given: the others are those of the form with these constants.
TEST(SampledErrors, OfFreeOnesAreThoseOfTheWhole) {
  const FresnelCubic family;
  const SampledProblem<FresnelCubic, double> sampled(family, Substitution::panels({}, family.shape()), 12);
  const SampledErrors all = sampled_errors(sampled, family, {});
  const std::vector p{-1.0, -5.0, -7.0};
  for (int which = 0; which < 7; ++which) {
    GivenParameters given(3);
    std::vector<Eigen::Index> free;
    std::vector<double> values;
    for (std::size_t i = 0; i < 3; ++i) {
      if (which >> i & 1) {
        given[i] = p[i];
      } else {
        free.push_back(static_cast<Eigen::Index>(i));
        values.push_back(p[i]);
      }
    }
    const SampledErrors part = of_free(all, given);
    EXPECT_EQ(part.square(values), all.square(p));
    EXPECT_EQ(part.gradient(values).gradient, all.gradient(p).gradient(free).eval());
    EXPECT_EQ(part.derivatives(values).hessian, all.derivatives(p).hessian(free, free).eval());
    std::vector<double> r(12), slopes(12 * values.size()), all_r(12), all_slopes(36);
    part.errors(values, r, slopes);
    all.errors(p, all_r, all_slopes);
    EXPECT_EQ(r, all_r);
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t node = 0; node < 12; ++node)
        EXPECT_EQ(slopes[12 * i + node], all_slopes[12 * static_cast<std::size_t>(free[i]) + node]);
    }
  }
}

// Gradient and Hessian by Jets of Jets against central differences of the summed square itself, in long
// double.
TEST(SampledProblem, DerivativesAreThoseOfTheSquare) {
  const FresnelQuadratic family;
  const SampledProblem<FresnelQuadratic, long double> problem(family,
                                                              Substitution::panels({}, family.shape()), 26);
  const std::array<long double, 2> p{-5.0L, -7.5L};
  const auto d = problem.derivatives(p);
  constexpr long double h = 1e-4L;
  for (std::size_t i = 0; i < 2; ++i) {
    auto up = p, down = p;
    up[i] += h, down[i] -= h;
    const auto above = problem.derivatives(up), below = problem.derivatives(down);
    const auto row = static_cast<int>(i);
    // the differences are off by h^2 times a third derivative of the size of the second: 1e-8
    EXPECT_NEAR(static_cast<double>((above.square - below.square) / (4 * h) / d.gradient[row]), 1, 1e-7);
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(static_cast<double>((above.gradient[j] - below.gradient[j]) / (2 * h) / d.hessian(row, j)),
                  1, 1e-7);
    }
  }
  EXPECT_EQ(d.hessian(0, 1), d.hessian(1, 0));
  const auto first = problem.gradient(p);
  EXPECT_EQ(first.square, d.square);
  EXPECT_NEAR(static_cast<double>(first.gradient[0] / d.gradient[0]), 1, 1e-16);
  EXPECT_NEAR(static_cast<double>(first.gradient[1] / d.gradient[1]), 1, 1e-16);
  EXPECT_EQ(problem.square(p), d.square);
}

}  // namespace
}  // namespace shadefit
