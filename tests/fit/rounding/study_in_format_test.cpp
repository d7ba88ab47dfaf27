#include "fit/rounding/study_in_format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fit/bounds/rounding_bound.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/scalars/half.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// A form in C++, once in floats and once in a wider arithmetic, with its subject.
struct FloatTrial {
  const char* name;
  StudySubject subject;
  std::function<float(float, float, std::span<const float>)> in_float;
  std::function<long double(long double, long double, std::span<const long double>)> truth;
  double most_times;  ///< how many times the errors that were seen the bound may be
};

/// The same lines for both.
template <class Form>
FloatTrial trial(const char* name, const StudySubject& subject, const Form& form, double most_times) {
  return {name, subject, [form](float x, float y, std::span<const float> p) { return form(x, y, p); },
          [form](long double x, long double y, std::span<const long double> p) { return form(x, y, p); },
          most_times};
}

const StudyRange from_0_to_1{"x", "0", "1"};

std::vector<FloatTrial> float_trials() {
  return {
      trial(
          "one addition", {{.target = "x", .form = "x + a", .over = {{"x", "1", "2"}}}, {{"a", "1"}}},
          [](auto x, auto, auto p) { return x + p[0]; }, 2),
      trial(
          "a constant that is no float",
          {{.target = "x", .form = "a x", .over = {{"x", "1", "2"}}}, {{"a", "0.1"}}},
          [](auto x, auto, auto p) { return p[0] * x; }, 2),
      trial(
          "a root that ends at 0",
          {{.target = "acos(x)", .form = "sqrt(1-x) (a + b x)", .over = {from_0_to_1}},
           {{"a", "1.5707963"}, {"b", "-0.156583"}}},
          [](auto x, auto, auto p) { return std::sqrt(1 - x) * (p[0] + p[1] * x); }, 4),
      trial(
          "a power at 0, and a maximum",
          {{.target = "x", .form = "max(a pow(x, p) - b, 0)", .over = {from_0_to_1}},
           {{"a", "1.055"}, {"p", "0.416666667"}, {"b", "0.055"}}},
          [](auto x, auto, auto p) {
            const auto y = p[0] * std::pow(x, p[1]) - p[2];
            return y < 0 ? 0 : y;
          },
          4),
      trial(
          "a quotient with a number of its own",
          {{.target = "x", .form = "(x*(a*x+b))/(x*(g*x+d)+0.14)", .over = {{"x", "0", "8"}}},
           {{"a", "2.51"}, {"b", "0.03"}, {"g", "2.43"}, {"d", "0.59"}}},
          [](auto x, auto, auto p) {
            const decltype(x) own = static_cast<decltype(x)>(0.14L);
            return (x * (p[0] * x + p[1])) / (x * (p[2] * x + p[3]) + own);
          },
          4),
      trial(
          "cancellation of large terms",
          {{.target = "x", .form = "x^2 (a + x (-b + x (d + x (-g + x h))))", .over = {from_0_to_1}},
           {{"a", "4.915"}, {"b", "31.33"}, {"d", "83.47"}, {"g", "87.76"}, {"h", "31.7"}}},
          [](auto x, auto, auto p) {
            return x * x * (p[0] + x * (-p[1] + x * (p[2] + x * (-p[3] + x * p[4]))));
          },
          8),
      trial(
          "functions",
          {{.target = "x", .form = "exp2(a x) + log(b + x) - sin(d x) atan(x)", .over = {from_0_to_1}},
           {{"a", "-1.3"}, {"b", "0.7"}, {"d", "2.9"}}},
          [](auto x, auto, auto p) {
            return std::exp2(p[0] * x) + std::log(p[1] + x) - std::sin(p[2] * x) * std::atan(x);
          },
          5),
      trial(
          "two variables",
          {{.target = "x", .form = "x + a y (1 - x)", .over = {from_0_to_1, {"y", "0.002", "1"}}},
           {{"a", "0.7512"}}},
          [](auto x, auto y, auto p) { return x + p[0] * y * (1 - x); }, 4),
  };
}

/// The largest difference at floats all over the ranges, more of them near both ends.
double seen_in(const FloatTrial& trial) {
  std::vector<float> p;
  std::vector<long double> exact;
  for (const auto& [name, text] : trial.subject.parameters) {
    p.push_back(std::stof(text));
    exact.push_back(std::stold(text));
  }
  const auto places = [&](std::size_t axis, int count) {
    std::vector<float> result{0};
    if (axis >= trial.subject.study.over.size()) return result;
    const float from = std::stof(trial.subject.study.over[axis].lower),
                to = std::stof(trial.subject.study.over[axis].upper);
    for (int i = 0; i <= count; ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(count);
      for (const float share : {part, part * part * part * 1e-3F, 1 - part * part * 1e-3F})
        result.push_back(std::clamp(from + (to - from) * share, from, to));
    }
    result.erase(result.begin());
    return result;
  };
  double seen = 0;
  const bool is_of_one = trial.subject.study.over.size() == 1;
  for (const float x : places(0, is_of_one ? 20000 : 300)) {
    for (const float y : places(1, 300))
      seen = std::max(seen, static_cast<double>(std::abs(static_cast<long double>(trial.in_float(x, y, p)) -
                                                         trial.truth(x, y, exact))));
  }
  return seen;
}

TEST(RoundingBound, BoundsWhatFloatsShow) {
  for (const FloatTrial& trial : float_trials()) {
    const double bound = bound_of_rounding<FloatFormat>(trial.subject), seen = seen_in(trial);
    EXPECT_LE(seen, bound) << trial.name;
    EXPECT_GE(trial.most_times * seen, bound) << trial.name << ": the bound is far off";
  }
}

// Every 64th pair of halves in [0, 1]^2, in the arithmetic of Eigen.
TEST(RoundingBound, BoundsWhatPairsOfHalvesShow) {
  const StudySubject subject{
      {.target = "x", .form = "x + a y (1 - x)", .over = {from_0_to_1, {"y", "0", "1"}}}, {{"a", "0.7512"}}};
  const double bound = bound_of_rounding<HalfFormat>(subject);
  const Eigen::half a = round_to_half(0.7512), one(1.0F);
  double seen = 0;
  for (std::uint16_t i = 0; i <= 0x3c00; i += 8) {
    for (std::uint16_t j = 0; j <= 0x3c00; j += 8) {
      const auto x = Eigen::numext::bit_cast<Eigen::half>(i), y = Eigen::numext::bit_cast<Eigen::half>(j);
      const double truth =
          static_cast<double>(x) + 0.7512 * static_cast<double>(y) * (1 - static_cast<double>(x));
      seen = std::max(seen, std::abs(static_cast<double>(x + a * y * (one - x)) - truth));
    }
  }
  EXPECT_LE(seen, bound);
  EXPECT_GE(4 * seen, bound) << "the bound is far off";
}

// A relative error and a weight divide and multiply it. x + 1 in floats is off by 2^-23, and by analysis at
// most 2^-24 times 3.
TEST(RoundingBound, IsMeasuredAsTheErrorIs) {
  StudySubject subject{{.target = "4", .form = "x + a", .over = {{"x", "1", "2"}}}, {{"a", "1"}}};
  const double plain = bound_of_rounding<FloatFormat>(subject);
  EXPECT_LE(plain, 3 * 0x1p-24 * (1 + 1e-15));
  EXPECT_GE(plain, 2 * 0x1p-24) << "2 + 2^-23 is a tie";
  subject.study.error = Error::relative;
  EXPECT_NEAR(bound_of_rounding<FloatFormat>(subject), plain / 4, 1e-12);
  subject.study.weight = "2";
  EXPECT_NEAR(bound_of_rounding<FloatFormat>(subject), plain / 2, 1e-12);
}

// 0.7 rounds down, and at that float the condition differs: the whole jump is an error.
TEST(RoundingBound, KnowsThatAConditionMayChange) {
  EXPECT_EQ(bound_of_rounding<FloatFormat>(
                {{.target = "x", .form = "x < a ? 0 : 1", .over = {from_0_to_1}}, {{"a", "0.7"}}}),
            1);
}

TEST(RoundingBound, IsInfiniteWithoutABound) {
  for (const char* form : {"integral(a t, t, 0, x)", "exp(a x)", "sqrt(x - 0.5) + a", "a/(x - 0.5)"})
    EXPECT_EQ(bound_of_rounding<FloatFormat>(
                  {{.target = "x", .form = form, .over = {from_0_to_1}}, {{"a", "100"}}}),
              HUGE_VAL)
        << form;
}

const Study pair_of_halves{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};

/// Every half from 0 to 1 by its bits, in the arithmetic of Eigen.
double error_in_half(double a, double b) {
  const Eigen::half p = round_to_half(a), q = round_to_half(b);
  double largest = 0;
  for (std::uint16_t bits = 0; bits <= 0x3c00; ++bits) {
    const auto c = Eigen::numext::bit_cast<Eigen::half>(bits);
    const auto form = static_cast<double>(exp2((p * c + q) * c));
    largest = std::max(largest, std::abs(form - std::pow(1 - static_cast<double>(c), 5)));
  }
  return largest;
}

TEST(StudyInFormat, IsTheLoopOverEveryHalf) {
  StudyInFormat<HalfFormat> study(read_study(pair_of_halves));
  EXPECT_EQ(study.places().size(), 0x3c01U);
  for (const auto& [a, b] : {std::pair{-5.555, -6.984}, std::pair{-5.492, -7.008}}) {
    const std::array constants{static_cast<double>(round_to_half(a)), static_cast<double>(round_to_half(b))};
    // pow in double rounds otherwise than a product
    EXPECT_NEAR(study.largest_error(constants).magnitude, error_in_half(a, b), 1e-15);
  }
}

TEST(StudyInFormat, MovesToBetterConstants) {
  StudyInFormat<HalfFormat> study(read_study(pair_of_halves));
  const std::vector<double> start{-5.5546875, -6.984375};
  const std::vector<double> moved = moved_constants(study, start, {});
  const double before = error_in_half(start[0], start[1]), after = error_in_half(moved[0], moved[1]);
  EXPECT_LT(after, 0.95 * before);
  // docs/rounding-and-sensitivity.md: no pair of halves is below 0.0035796
  EXPECT_GE(after, 0.003579);
  // x is exact at both ends of x^2.
  const Study line{.target = "x^2", .form = "a + b x", .over = {from_0_to_1}};
  StudyInFormat<HalfFormat> parabola(read_study(line));
  const std::vector<double> exact{0, 1};
  EXPECT_NE(moved_constants(parabola, exact, {}), exact);
  EXPECT_EQ(moved_constants(parabola, exact, std::array{0.0, 1.0}), exact);
}

TEST(StudyInFormat, SaysWhereAFormIsNoNumber) {
  StudyInFormat<HalfFormat> pole(read_study({.target = "x", .form = "a/x", .over = {from_0_to_1}}));
  const ErrorInFormat error = pole.largest_error(std::array{1.0});
  EXPECT_EQ(error.magnitude, HUGE_VAL);
  EXPECT_EQ(error.at, std::vector<double>{0});
  // 300^2 overflows, and the infinite denominator hides it: the result is 0, and wrong
  StudyInFormat<HalfFormat> hidden(
      read_study({.target = "1/x^2", .form = "a/(x x)", .over = {{"x", "300", "400"}}}));
  EXPECT_NEAR(hidden.largest_error(std::array{1.0}).magnitude, 1 / 9e4, 1e-12);
}

// 0.1 is no half: its row is evaluated at the half nearest to it.
TEST(StudyInFormat, RoundsTheVariablesOfRows) {
  Study study{.target = "", .form = "a x", .over = {{"x", "", ""}}};
  study.rows = std::make_shared<const MeasuredRows>(
      MeasuredRows{.file = OthersText("rows.csv"), .places = {{0.5, 0.1}}, .value = {0.5, 0.1}, .sigma = {}});
  StudyInFormat<HalfFormat> in_half(read_study(study));
  const double rounded = static_cast<double>(round_to_half(0.1));
  const ErrorInFormat error = in_half.largest_error(std::array{1.0});
  EXPECT_EQ(error.magnitude, std::abs(rounded - 0.1));
  EXPECT_EQ(error.at, std::vector<double>{rounded});
}

/// a x at three rows whose x are halves: with a = 1 the residuals are -1/8, 1/4 and 1/2.
Study three_rows() {
  Study study{.target = "", .form = "a x", .over = {{"x", "", ""}}};
  study.rows = std::make_shared<const MeasuredRows>(MeasuredRows{.file = OthersText("rows.csv"),
                                                                 .places = {{0.125, 0.5, 1}},
                                                                 .value = {0.25, 0.25, 0.5},
                                                                 .sigma = {0.015625, 0.5, 1}});
  return study;
}

double error_of_three_rows(const Study& study) {
  return StudyInFormat<HalfFormat>(read_study(study)).largest_error(std::array{1.0}).magnitude;
}

TEST(StudyInFormat, WeightsRowsAsTheStudyAsks) {
  Study study = three_rows();
  EXPECT_EQ(error_of_three_rows(study), 0.5);
  study.weight = "3 - 2 x";
  EXPECT_EQ(error_of_three_rows(study), 0.5) << "11/32, 1/2 and 1/2";
  study.weight = "1 - x";
  EXPECT_EQ(error_of_three_rows(study), 0.125) << "7/64, 1/8 and 0";
  study.weight = "1/(value + sigma)";
  EXPECT_NEAR(error_of_three_rows(study), 0.125 / 0.265625, 1e-15) << "8/17, 1/3 and 1/3";
  study.error = Error::relative;
  study.weight = "1 - x";
  EXPECT_EQ(error_of_three_rows(study), 0.5) << "7/16, 1/2 and 0";
  study.weight = "x";
  EXPECT_EQ(error_of_three_rows(study), 1) << "1/16, 1/2 and 1";
}

// The error at the rows is the one by which the sets of the study are compared.
TEST(StudyInFormat, IsTheErrorOfTheStudyAtRows) {
  for (const Error error : {Error::absolute, Error::relative}) {
    Study study = three_rows();
    study.error = error;
    study.weight = "exp(x) + value";
    EXPECT_NEAR(error_of_three_rows(study), largest_weighted_error(read_study(study), {1}).magnitude, 1e-15);
  }
}

// Without a weight that is asked for the sets are compared by the residual, in the unit of the rows.
TEST(StudyInFormat, LeavesTheUnitOfRowsWithoutAWeight) {
  for (const Error error : {Error::absolute, Error::relative}) {
    for (const char* weight : {"1", "1/sigma"}) {
      Study study = three_rows();
      study.error = error;
      study.weight = weight;
      EXPECT_EQ(error_of_three_rows(study), largest_error(read_study(study), {1}).magnitude) << weight;
    }
  }
}

// The last row counts for next to nothing: a = 0.8 fits the other two best.
TEST(StudyInFormat, SearchesWithTheWeightOfRows) {
  Study study = three_rows();
  study.weight = "x < 1 ? 1 : 0.0001";
  StudyInFormat<HalfFormat> in_half(read_study(study));
  const std::vector<double> moved = moved_constants(in_half, {1}, {});
  // |a/8 - 1/4| and |a/2 - 1/4| are equal at a = 0.8
  EXPECT_NEAR(moved.front(), 0.8, 0.001);
}

}  // namespace
}  // namespace shadefit
