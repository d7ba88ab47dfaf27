#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fit/exchange/minimax_study.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/study/study_problem.hpp"

// Tables with more rows than are copied: their sums are those of blocks, on all cores.
namespace shadefit {
namespace {

constexpr std::size_t many = 200'000;

/// A number from -1 to 1 for each row.
double noise_of(std::size_t row) {
  return static_cast<double>((row * 2654435761U + 12345) % 1000003) / 500001.0 - 1;
}

template <class Value>
ReadStudy study_of(const std::string& form, const Value& value, std::size_t count = many) {
  auto rows = std::make_shared<MeasuredRows>(MeasuredRows{OthersText("many.csv"), {{}}, {}, {}});
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(count - 1);
    rows->places[0].push_back(x);
    rows->value.push_back(value(x, i));
  }
  return read_study({.target = "", .form = form, .over = {{"x", "", ""}}, .rows = rows});
}

double decay(double x, std::size_t row) {
  return 2 * std::exp(-3 * x) + 0.25 + 0.1 * noise_of(row);
}

TEST(ManyRows, AreNotCopied) {
  const ReadStudy study = study_of("a + b x", [](double x, std::size_t) { return x; });
  const StudyNodes nodes = nodes_of(study, {}, 1);
  EXPECT_EQ(nodes.rows, study.rows);
  EXPECT_TRUE(nodes.coordinates.empty() && nodes.weights.empty());
  EXPECT_EQ(nodes.size(), many);
  const ReadStudy few = study_of(
      "a + b x", [](double x, std::size_t) { return x; }, most_copied_rows);
  EXPECT_EQ(nodes_of(few, {}, 1).rows, nullptr);
}

TEST(ManyRows, HaveTheSameSumsOnAnyNumberOfThreads) {
  const ReadStudy study = study_of("a exp(-b x)/(1 + d x) + c", decay);
  const StudyError error(study);
  const StudyNodes nodes = nodes_of(study, {}, 1);
  const std::vector<double> at{1.9, 2.8, 0.1, 0.3};
  const std::vector<long double> wide(at.begin(), at.end());
  const std::vector<Eigen::Index> columns{0, 1, 2, 3, 4};
  const auto sums_of = [&](unsigned threads) {
    const SampledStudy<double> sampled(error, nodes, threads);
    const auto sums = sampled.derivatives(at);
    ProductMatrix<double> products;
    sampled.products(at, columns, products);
    const WeightedErrors<double> reduced = sampled.reduced(at);
    const auto in_wide = SampledStudy<long double>(error, nodes, threads).gradient(wide);
    std::vector<long double> all{sums.square, sampled.square(at), sampled.target_norm(), in_wide.square};
    const auto append = [&](const auto& matrix) {
      for (Eigen::Index i = 0; i < matrix.size(); ++i) all.push_back(matrix.data()[i]);
    };
    append(sums.gradient), append(sums.hessian), append(products), append(in_wide.gradient);
    append(reduced.errors), append(reduced.slopes);
    EXPECT_FALSE(sampled.has_pole(at));
    EXPECT_TRUE(sampled.has_pole(std::vector<double>{1.9, 2.8, -2, 0.3}));
    return all;
  };
  const auto alone = sums_of(1);
  EXPECT_EQ(sums_of(2), alone);
  EXPECT_EQ(sums_of(7), alone);
}

/// Two ways to the same sums: the triangles of blocks, and the products.
TEST(ManyRows, HaveTrianglesOfTheSameProducts) {
  const ReadStudy study = study_of("a exp(-b x) + c", decay);
  const StudyError error(study);
  const SampledStudy<double> sampled(error, nodes_of(study, {}, 1));
  const std::vector<double> at{1.9, 2.8, 0.3};
  const WeightedErrors<double> reduced = sampled.reduced(at);
  MatrixOf<double> columns(reduced.slopes.rows(), 4);
  columns << reduced.slopes, reduced.errors;
  columns = (reduced.roots.asDiagonal() * columns).eval();
  ProductMatrix<double> products;
  sampled.products(at, std::vector<Eigen::Index>{0, 1, 2, 3}, products);
  EXPECT_LT((columns.transpose() * columns - products).norm(), 1e-13 * products.norm());
  VectorOf<double> errors;
  sampled.errors(at, errors, nullptr);
  EXPECT_NEAR(errors.squaredNorm() / static_cast<double>(many), products(3, 3), 1e-14);
  EXPECT_NEAR(errors[many - 1], 1.9 * std::exp(-2.8) + 0.3 - decay(1, many - 1), 1e-15);
}

/// The sums of textbooks for the line a + b x, in long double.
TEST(ManyRows, HaveTheTextbookNumbersOfALine) {
  const ReadStudy study = study_of("a + b x", decay);
  long double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const std::vector<double>&x = study.rows->places[0], &y = study.rows->value;
  for (std::size_t i = 0; i < many; ++i) {
    sx += x[i], sy += y[i];
    sxx += static_cast<long double>(x[i]) * x[i], sxy += static_cast<long double>(x[i]) * y[i];
  }
  const long double n = many, d = n * sxx - sx * sx, a = (sxx * sy - sx * sxy) / d,
                    b = (n * sxy - sx * sy) / d;
  long double square = 0, largest = 0;
  for (std::size_t i = 0; i < many; ++i) {
    const long double error = a + b * x[i] - y[i];
    square += error * error;
    largest = std::max(largest, std::abs(error));
  }
  const StudyFit fit = solve_study(study, {});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_EQ(fit.digits, 14);
  EXPECT_NEAR(fit.parameters[0], static_cast<double>(a), 1e-14);
  EXPECT_NEAR(fit.parameters[1], static_cast<double>(b), 1e-14);
  EXPECT_NEAR(fit.rms_error, static_cast<double>(std::sqrt(square / n)), 1e-15);
  EXPECT_NEAR(fit.max_abs_error.magnitude, static_cast<double>(largest), 1e-14);
  const std::size_t row = fit.max_abs_error.row - 1;
  EXPECT_NEAR(std::abs(static_cast<double>(a + b * x[row]) - y[row]), static_cast<double>(largest), 1e-9);
  ASSERT_TRUE(fit.statistics);
  // A linear form: the profile interval is the standard error.
  const auto error_of_b = static_cast<double>(std::sqrt(square / (n - 2) * n / d));
  EXPECT_NEAR(fit.statistics->standard_errors[1] / error_of_b, 1, 1e-13);
  EXPECT_NEAR((*fit.statistics->profiles[1].upper - fit.parameters[1]) / error_of_b, 1, 1e-6);
  EXPECT_NEAR((fit.parameters[1] - *fit.statistics->profiles[1].lower) / error_of_b, 1, 1e-6);
}

/// The search sees some rows, the answer all: its gradient is 0. With a parameter at an end of its profile,
/// the sum of squares is larger by the variance.
TEST(ManyRows, AreFittedWithoutAStart) {
  const ReadStudy study = study_of("a exp(-b x) + c", decay);
  const StudyFit fit = solve_study(study, {});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_EQ(fit.digits, 14);
  const StudyError error(study);
  const std::vector<long double> at(fit.parameters.begin(), fit.parameters.end());
  const auto sums = SampledStudy<long double>(error, nodes_of(study, {}, 1)).gradient(at);
  EXPECT_LT(sums.gradient.norm(), 1e-15L);
  EXPECT_NEAR(fit.rms_error, static_cast<double>(std::sqrt(sums.square)), 1e-15);
  ASSERT_TRUE(fit.statistics);
  for (const auto end : {fit.statistics->profiles[1].lower, fit.statistics->profiles[1].upper}) {
    const ReadStudy held = with_held(study, "b", *end);
    const double square = std::pow(solve_study(held, {}).rms_error, 2) - std::pow(fit.rms_error, 2);
    EXPECT_NEAR(square * many / fit.statistics->variance, 1, 1e-6);
  }
}

/// Left and right of the middle are as good, and different curves: the sample prefers one.
TEST(ManyRows, HaveTwoAnswersIfTwoCurvesAreAsGood) {
  const ReadStudy study = study_of("exp(-16 (x - m)^2)", [](double x, std::size_t) {
    return std::exp(-16 * std::pow(std::abs(x - 0.5) - 0.5, 2));
  });
  EXPECT_EQ(solve_study(study, {}).status, Status::ambiguous);
}

// x^2 by a line: the level is 1/8, at both ends and in the middle.
TEST(ManyRows, HaveALeastLevel) {
  const StudyFit line =
      solve_minimax_study(study_of(
                              "a + b x", [](double x, std::size_t) { return x * x; }, many + 1),
                          {}, {});
  ASSERT_EQ(line.status, Status::converged) << line.why;
  EXPECT_NEAR(line.parameters[0], -0.125, 1e-15);
  EXPECT_NEAR(line.parameters[1], 1, 1e-15);
  EXPECT_NEAR(*line.level, 0.125, 1e-15);
  EXPECT_EQ(line.touching.size(), 3u);
}

}  // namespace
}  // namespace shadefit
