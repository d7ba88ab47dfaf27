#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "approx/fresnel.hpp"
#include "bench/forms/catalogue.hpp"
#include "tests/bench/exp2_choices.hpp"

namespace shadefit {
namespace {

using forms::fit_pair_for_exp2;
using testing::for_each_degree;

/// max |form - (1-c)^5| of a pair with the polynomial, sampled: every c of a fine grid.
template <class P>
double sampled_level(double a, double b) {
  constexpr int steps = 1 << 16;
  double largest = 0;
  for (int i = 0; i <= steps; ++i) {
    const double c = static_cast<double>(i) / steps;
    const double form = exp2_polynomial<P>((a * c + b) * c);
    largest = std::max(largest, std::abs(form - schlick_weight(c)));
  }
  return largest;
}

// Another method for the same level: the formula itself on a grid, with its jumps. And no pair near it is
// better.
TEST(PairForExp2, IsTheBest) {
  for_each_degree<float>([]<class P>(P) {
    const StudyFit pair = fit_pair_for_exp2(P::record.degree);
    ASSERT_EQ(pair.status, Status::converged) << pair.why;
    const double b = pair.parameters.at(0), a = pair.parameters.at(1), level = pair.level.value();
    // The error that jumps is the contact of degree 2, where its slope is 0.03: a step of the grid misses
    // 5e-7.
    EXPECT_NEAR(sampled_level<P>(a, b), level, 5e-7) << P::record.degree;
    EXPECT_LE(sampled_level<P>(a, b), level * (1 + 1e-9)) << P::record.degree;
    // In the flattest of all directions, at degree 2, a thousandth raises the level by 1.9e-6.
    for (const auto& [da, db] : {std::pair{1e-3, 0.0}, {0.0, 1e-3}, {1e-3, -1e-3}, {1e-3, 1e-3}}) {
      for (const double sign : {-1.0, 1.0})
        EXPECT_GT(sampled_level<P>(a + sign * da, b + sign * db), level + 1e-6) << P::record.degree;
    }
  });
  // By degree 2 it is better than the published pair is with an exact exp2.
  EXPECT_LT(fit_pair_for_exp2(2).level, 0.003766);
}

TEST(PairForExp2, RefusesOtherDegrees) {
  EXPECT_THROW(fit_pair_for_exp2(1), std::logic_error);
  EXPECT_THROW(fit_pair_for_exp2(7), std::logic_error);
}

}  // namespace
}  // namespace shadefit
