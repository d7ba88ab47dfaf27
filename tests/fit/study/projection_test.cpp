#include "fit/study/projection.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_nodes.hpp"

namespace shadefit {
namespace {

/// Of a rational form: a and b enter linearly, d and g do not.
struct RationalStudy {
  ReadStudy read =
      read_study({.target = "exp(-x)", .form = "(a + b x)/(1 + d x + g x^2)", .over = {{"x", "0", "1"}}});
  StudyError error{read};
  SampledStudy<double> sampled{error, nodes_of(read, {{{0}, {1}}}, 30)};
};

struct Look {
  std::array<double, 3> residuals;
  std::array<double, 6> slopes;
  std::vector<double> parameters;
  double square;
};

Look look(const Projection& projection, const std::array<double, 2>& q, bool has_slopes = true) {
  Look result{};
  projection(q.data(), result.residuals.data(), has_slopes ? result.slopes.data() : nullptr);
  for (const double r : result.residuals) result.square += r * r;
  result.parameters = projection.parameters();
  return result;
}

constexpr std::array<double, 2> from{0.5, 0.1};

TEST(Projection, FollowsAStep) {
  const RationalStudy study;
  const Projection walking(study.error, study.sampled), fresh(study.error, study.sampled);
  look(walking, from);
  // The linear parameters follow to first order: what they lack has the size of the square of the step, and
  // is taken away.
  constexpr std::array near{0.501, 0.0995};
  const Look followed = look(walking, near), expected = look(fresh, near);
  for (std::size_t i = 0; i < expected.parameters.size(); ++i)
    EXPECT_NEAR(followed.parameters[i], expected.parameters[i], 1e-11);
  // Both forms of the square have roundings of the errors, 1e-16 of the target, whose share of the errors
  // here, 1e-3 of the target, is 1e-13.
  EXPECT_NEAR(followed.square, expected.square, 1e-12 * expected.square);
  EXPECT_NEAR(followed.square, study.sampled.square(followed.parameters), 1e-12 * expected.square);
}

TEST(Projection, BeginsAnewBeyondItsReach) {
  const RationalStudy study;
  const Projection walking(study.error, study.sampled), fresh(study.error, study.sampled);
  look(walking, from);
  constexpr std::array far{40.0, 3.0};
  const Look jumped = look(walking, far), expected = look(fresh, far);
  EXPECT_EQ(jumped.parameters, expected.parameters);
  EXPECT_EQ(jumped.residuals, expected.residuals);
  EXPECT_EQ(jumped.slopes, expected.slopes);
}

TEST(Projection, RemembersTheAcceptedPlace) {
  const RationalStudy study;
  const Projection projection(study.error, study.sampled);
  look(projection, {0.49, 0.1});
  const Look accepted = look(projection, from);
  look(projection, {0.6, 0.2}, false);
  const Look again = look(projection, from);
  EXPECT_EQ(again.parameters, accepted.parameters);
  EXPECT_EQ(again.residuals, accepted.residuals);
  projection.forget();
  const Projection fresh(study.error, study.sampled);
  EXPECT_EQ(look(projection, from).residuals, look(fresh, from).residuals);
}

}  // namespace
}  // namespace shadefit
