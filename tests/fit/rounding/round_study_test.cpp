#include "fit/rounding/round_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "fit/rounding/every_number.hpp"
#include "fit/rounding/study_lattice.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

const NumberFormat single{NumberFormat::Kind::single};
const NumberFormat half_format{NumberFormat::Kind::half};

NumberFormat decimals(int digits) {
  return {NumberFormat::Kind::decimal, digits};
}

RoundedStudy rounded(const Study& study, Norm norm, const NumberFormat& format) {
  const StudyObjective objective = objective_of(study, norm, {});
  return round_study(objective, fit_study(objective), format);
}

const Study fresnel_pair{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};
const Study line_of_square{.target = "x^2", .form = "a + b x", .over = {{"x", "0", "1"}}};

std::map<std::string, Study> studies_of_references() {
  return {{"pair", fresnel_pair},
          {"sine", {.target = "sin(x)", .form = "x (a + b x x)", .over = {{"x", "0", "1.5"}}}},
          {"relative",
           {.target = "exp(-x)", .form = "a/(b + x)", .over = {{"x", "0", "2"}}, .error = Error::relative}},
          {"parabola", {.target = "exp(x)", .form = "a + (b + d x) x", .over = {{"x", "0", "1"}}}}};
}

// tests/references/make_rounding_references.py tries all neighbours, in an arithmetic of its own.
TEST(RoundStudy, FindsWhatTryingAllNeighboursFinds) {
  const CsvTable table =
      parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/references/rounding.csv"), "rounding.csv");
  ASSERT_EQ(table.rows.size(), 8U);
  const auto studies = studies_of_references();
  for (const auto& row : table.rows) {
    const RoundedStudy found =
        rounded(studies.at(row[0]), Norm::least_squares, parse_number_format("--round", row[1]));
    std::string constants;
    for (const double value : found.best.values) constants += (constants.empty() ? "" : " ") + to_text(value);
    EXPECT_NEAR(found.best.max_error / std::stod(row[3]), 1, 1e-8)
        << row[0] << " " << row[1] << " " << row[2] << " but " << constants;
    EXPECT_LT(found.best.max_error, found.naive.max_error) << row[0] << " " << row[1];
    EXPECT_TRUE(found.is_proven) << row[0] << " " << row[1];
    EXPECT_GE(found.best.gpu_bound.value_or(0), found.best.max_error) << row[0] << " " << row[1];
  }
}

// A form with most of the functions, and a number that half cannot hold.
const Study functions{
    .target = "2 + x",
    .form =
        "a sin(b x) + tanh(a x)/(2 + cos(b x)) + erf(a x) + atan(b x) - log1p(x) expm1(-x) + "
        "tan(a x/4) + floor(3 x) a/100 + 2049 x/5000 + sqrt(x + b b) - pow(x, 0.3)",
    .over = {{"x", "0", "1"}}};

/// No constants in a box have a smaller error than its bound says. Half the boxes of few steps have a bound.
template <class Problem, class Lattice>
void expect_bounds(Problem& problem, const Lattice& lattice, double a, double b, double slack) {
  std::mt19937 random(1);
  int bounded = 0;
  for (const std::int64_t size : {0, 1, 30, 2000, 20000}) {
    for (int i = 0; i < 6; ++i) {
      const auto from = [&](double centre) {
        return lattice.nearest(centre) - std::uniform_int_distribution<std::int64_t>(0, size)(random);
      };
      const LatticePoint lower{from(a), from(b)};
      const LatticeBox box{lower, {lower[0] + size, lower[1] + size}};
      const double bound = problem.bound(box, HUGE_VAL);
      bounded += bound > 0 && size <= 30 ? 1 : 0;
      for (int k = 0; k < 2; ++k) {
        std::uniform_int_distribution<std::int64_t> step(0, size);
        const LatticePoint point{lower[0] + step(random), lower[1] + step(random)};
        ASSERT_LE(bound, problem.error(point, HUGE_VAL) * (1 + slack)) << size;
      }
    }
  }
  EXPECT_GE(bounded, 9);
}

TEST(RoundStudy, BoundsEveryErrorInABox) {
  for (const Study& study : {fresnel_pair, functions, studies_of_references().at("relative")}) {
    const ReadStudy read = read_study(study);
    StudyInFormat<HalfFormat> in_half(read);
    NarrowStudyProblem<HalfFormat> narrow(read, in_half);
    expect_bounds(narrow, BinaryLattice<HalfFormat>{}, 0.7, 1.2, 0);
    RealStudyProblem<BinaryLattice<FloatFormat>> real(read, {}, [](const auto&) { return true; });
    // the largest error is sampled, at the places of the bound too
    expect_bounds(real, BinaryLattice<FloatFormat>{}, 0.7, 1.2, 1e-9);
  }
}

// The references are no worse than others only because they are searched for: a bound that is half too large
// rules the best out.
TEST(RoundStudy, APlantedWrongBoundLosesTheBest) {
  const ReadStudy read = read_study(fresnel_pair);
  StudyInFormat<HalfFormat> in_half(read);
  NarrowStudyProblem<HalfFormat> problem(read, in_half);
  const BinaryLattice<HalfFormat> lattice;
  const std::vector<LatticePoint> starts{{lattice.nearest(-5.555), lattice.nearest(-6.984)}};
  const auto error_with = [&](double factor) {
    const LatticeProblem planted{
        [&](const LatticeBox& box, double best) { return factor * problem.bound(box, best); },
        [&](const LatticePoint& point, double best) { return problem.error(point, best); }};
    const auto found = search_format(planted, lattice.last(), starts, half_format, 100'000, keep_going);
    return in_half.largest_error(values_at(lattice, found.point)).magnitude;
  };
  EXPECT_NEAR(error_with(1), 0.00357959451, 1e-11);
  EXPECT_GT(error_with(1.5), 0.0036);
}

// Two variables have no list of all places, and an integral in the target is no obstacle in half.
TEST(RoundStudy, EvaluatesInHalfWhereTheFormCanBe) {
  const Study mean{.target = "integral(exp(-x t^2), t, 0, 1)", .form = "a + b x", .over = {{"x", "0", "1"}}};
  const RoundedStudy found = rounded(mean, Norm::least_squares, half_format);
  EXPECT_TRUE(found.is_proven);
  EXPECT_LT(found.best.max_error, found.naive.max_error);
  // a published set that is better than the fit is a start, and a row
  const StudyObjective objective = objective_of(fresnel_pair, Norm::least_squares, {});
  const RoundedStudy with = round_study(objective, fit_study(objective), half_format, {-5.55473, -6.98316});
  EXPECT_EQ(with.published.value().texts, (std::vector<std::string>{"-5.555", "-6.984"}));
  EXPECT_NEAR(with.best.srgb_codes.value(), 7.99577, 1e-5);
}

// With a = -1 the denominator is 0 at c = 1, and the error has no bound.
TEST(RoundStudy, AvoidsAPole) {
  const Study study{
      .target = "(1 - c)^4/(1 - 0.99 c)", .form = "(1 - c)^4/(1 + a c)", .over = {{"c", "0", "1"}}};
  const RoundedStudy found = rounded(study, Norm::least_squares, decimals(1));
  EXPECT_EQ(found.best.texts, std::vector<std::string>{"-0.9"});
  EXPECT_EQ(found.naive.texts, std::vector<std::string>{"-1"});
  EXPECT_EQ(found.naive.max_error, HUGE_VAL);
}

TEST(RoundStudy, BoundsTheRoundingOfFloat) {
  const RoundedStudy found = rounded(fresnel_pair, Norm::minimax, single);
  EXPECT_EQ(found.best.texts, (std::vector<std::string>{"-5.5513434", "-6.9961205"}));
  const auto& set = found.best;
  EXPECT_EQ(set.max_error, std::nextafter(set.real_error.value() + set.rounding_error.value(), 1.0));
  EXPECT_GT(set.gpu_bound.value(), set.max_error);
  EXPECT_FALSE(rounded(fresnel_pair, Norm::minimax, decimals(3)).best.rounding_error.has_value());
}

/// max |a + b x - x^2| on [0, 1]: at an end, or where b = 2 x.
double error_of_line(double a, double b) {
  const double inside = 0 <= b && b <= 2 ? std::abs(a + b * b / 4) : 0;
  return std::max({std::abs(a), std::abs(a + b - 1), inside});
}

// Every pair of decimals of two digits near the optimum, a = -1/8, b = 1, in a plain loop.
TEST(RoundStudy, NoOtherDecimalsAreBetter) {
  const RoundedStudy found = rounded(line_of_square, Norm::minimax, decimals(2));
  double best = 1;
  for (int i = -20; i <= -10; ++i) {
    for (int j = 80; j <= 120; ++j) {
      if (j > 100 && j % 10 != 0) continue;  // 1.01 has three digits
      best = std::min(best, error_of_line(i / 100.0, j / 100.0));
    }
  }
  EXPECT_TRUE(found.is_proven);
  EXPECT_NEAR(error_of_line(found.best.values[0], found.best.values[1]), best, 1e-15);
  EXPECT_GE(found.best.max_error, best * (1 - 1e-15));
  EXPECT_LE(found.best.max_error, best * (1 + 2e-6));
}

// More parameters than the whole lattice allows, a relative error, a held parameter, two variables.
TEST(RoundStudy, IsNeverWorseThanRoundingEachConstant) {
  Study rational{.target = "sqrt(x)", .form = "(a + b x)/(1 + d x)", .over = {{"x", "0.25", "1"}}};
  rational.error = Error::relative;
  Study held = fresnel_pair;
  held.held = {{"a", -5.5}};
  const Study plane{.target = "x y",
                    .form = "a + b x + d y",
                    .over = {{"x", "0", "1"}, {"y", "0", "1"}},
                    .weight = "1 + x"};
  for (const auto& [study, norm] :
       {std::pair{rational, Norm::minimax}, {held, Norm::least_squares}, {plane, Norm::least_squares}}) {
    for (const NumberFormat& format : {decimals(3), single}) {
      const RoundedStudy found = rounded(study, norm, format);
      EXPECT_LE(found.best.max_error, found.naive.max_error * (1 + 1e-6)) << study.form << to_text(format);
      EXPECT_GT(found.evaluated, 1);
      EXPECT_EQ(found.best.values.size(), read_study(study).parameters.size());
    }
  }
}

TEST(RoundStudy, RefusesWhatRoundingBreaks) {
  const auto refusal = [](const Study& study, const NumberFormat& format,
                          const Constraints& constraints = {}) {
    const StudyObjective objective = objective_of(study, Norm::minimax, constraints);
    return testing::refusal([&] { round_study(objective, fit_study(objective), format); });
  };
  Study plane = line_of_square;
  plane.over.push_back({"y", "0", "1"});
  EXPECT_EQ(refusal(plane, half_format), "--round 'half' takes one variable: take float or decimal:N for 2");
  const Study mean{.target = "integral(t x, t, 0, 1)", .form = "a + b x", .over = {{"x", "0", "1"}}};
  EXPECT_EQ(refusal(mean, single),
            "--round 'float' does not go with 'integral': no enclosure of it is fast enough");
  Study tiny = line_of_square;
  tiny.over = {{"x", "1e-9", "2e-9"}};
  EXPECT_EQ(refusal(tiny, half_format), "--round 'half': the range of x holds no number of half");
  EXPECT_EQ(refusal(line_of_square, single, {.exact_at = {0}}),
            "--round 'float' does not go with a constraint: rounding would break it");
  Study sextic = line_of_square;
  sextic.form = "a + b x + d x^2 + g x^3 + h x^4 + m x^5 + n x^6";
  sextic.target = "exp(x)";
  EXPECT_EQ(refusal(sextic, single), "--round 'float' takes at most 6 parameters: the form has 7");
  Study large = line_of_square;
  large.form = "1e-40 a + b x";
  EXPECT_EQ(refusal(large, single), "--round 'float': a = -1.25e+39 overflows: the largest is 3.40282e+38");
}

RoundedStudy evaluated(const Study& study, const NumberFormat& format) {
  const StudyObjective objective = objective_of(study, Norm::minimax, {});
  return evaluate_study(objective, fit_study(objective), format);
}

// The errors are those of a loop over every float, and moves gain on rounding where floats are coarse.
TEST(EvaluateStudy, IsJudgedAtEveryFloat) {
  const Study study{.target = "exp(x)", .form = "a + (b + d x) x", .over = {{"x", "0.9", "1"}}};
  const RoundedStudy found = evaluated(study, single);
  EXPECT_FALSE(found.is_proven);
  EXPECT_LT(found.best.max_error, found.naive.max_error);
  for (const RoundedStudySet* set : {&found.best, &found.naive}) {
    std::vector<float> p(set->values.begin(), set->values.end());
    double largest = 0;
    for (float x = 0.9F; x <= 1; x = std::nextafter(x, 2.0F)) {
      const float form = p[0] + (p[1] + p[2] * x) * x;
      if (x >= 0.9) largest = std::max(largest, std::abs(static_cast<double>(form) - std::exp(x * 1.0)));
    }
    EXPECT_NEAR(set->max_error, largest, 1e-15);
  }
}

TEST(EvaluateStudy, FindsTheBestHalves) {
  const RoundedStudy found = evaluated(fresnel_pair, half_format);
  EXPECT_GE(found.best.max_error, 0.003579594) << "the proven best of all halves";
  EXPECT_LE(found.best.max_error, 0.0036);
}

// What is left out has no larger error.
TEST(EvaluateStudy, TheLargestOfEveryNumberIsThatOfTheLoop) {
  auto studies = studies_of_references();
  studies.emplace("functions", functions);
  for (const auto& [name, study] : studies) {
    const ReadStudy read = read_study(study);
    StudyInFormat<HalfFormat> all(read);
    const std::vector<double> constants(read.parameters.size(), 0.8125);
    const double largest = all.largest_error(constants).magnitude;
    Study part = study;
    part.over[0].upper = "0.01";  // a sample that has not the largest error
    StudyInFormat<HalfFormat> sample(read_study(part));
    EXPECT_EQ(largest_of_every_number(read, sample, constants).magnitude, largest) << name;
  }
}

TEST(EvaluateStudy, RefusesWhatHasNoList) {
  const auto refusal = [](const Study& study, const NumberFormat& format) {
    return testing::refusal([&] { evaluated(study, format); });
  };
  Study plane = line_of_square;
  plane.over.push_back({"y", "0", "1"});
  EXPECT_EQ(refusal(plane, single), "--evaluate 'float' takes one variable, not 2");
  Study mean = line_of_square;
  mean.target = "integral(t x, t, 0, 1)";
  EXPECT_EQ(refusal(mean, single),
            "--evaluate 'float' does not go with 'integral': no enclosure of it is fast enough");
  EXPECT_EQ(refusal(mean, half_format), "");
}

}  // namespace
}  // namespace shadefit
