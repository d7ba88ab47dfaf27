#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fit/exchange/minimax_study.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/study/search.hpp"
#include "fit/support/user_error.hpp"
#include "tests/refusal.hpp"

// Studies whose target is measured rows.
namespace shadefit {
namespace {

using Numbers = std::vector<double>;

Study study_of_rows(const std::string& form, const MeasuredRows& rows, const std::string& weight = "1") {
  return {.target = "",
          .form = form,
          .over = {{"x", "", ""}},
          .weight = weight,
          .rows = std::make_shared<const MeasuredRows>(rows)};
}

StudyFit fit_of_rows(const Study& study) {
  return solve_study(read_study(study), study.starts);
}

void expect_near_relative(double computed, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(computed / expected, 1, tolerance)
      << what << ": expected " << to_text(expected) << ", computed " << to_text(computed);
}

/// The shapes of NIST's regression problems, with random parameters and noise: no fit is worse than the
/// parameters that made the rows.
TEST(RowStudy, PeaksRatesAndLogisticsAreFoundWithoutAStart) {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int seed = 0; seed < 20; ++seed) {
    const double b1 = between(60, 120), b2 = between(0.005, 0.02), b4 = between(50, 110),
                 b5 = between(12, 30), b7 = between(150, 210), b8 = between(12, 30), b3 = between(50, 120),
                 b6 = between(50, 120);
    const auto peak = [](double x, double at, double width) {
      return std::exp(-std::pow((x - at) / width, 2));
    };
    const std::vector<std::pair<std::string, std::function<double(double)>>> shapes{
        {"b1*exp(-b2*x) + b3*exp(-(x-b4)^2/b5^2) + b6*exp(-(x-b7)^2/b8^2)",
         [=](double x) { return b1 * std::exp(-b2 * x) + b3 * peak(x, b4, b5) + b6 * peak(x, b7, b8); }},
        {"b1*exp(-b2*x) + b3*exp(-b4*x)",
         [=](double x) { return b1 * std::exp(-b2 * x) + b3 * std::exp(-b2 * b5 / 3 * x); }},
        {"b1/(1 + exp(b2 - b3*x))", [=](double x) { return b1 / (1 + std::exp(b5 / 4 - b2 * 5 * x)); }}};
    for (const auto& [form, truth] : shapes) {
      MeasuredRows rows{OthersText("made.csv"), {{}}, {}, {}};
      double square = 0;
      for (int i = 1; i <= 60; ++i) {
        const double x = 4 * i;
        const double noise = between(-2, 2);
        square += noise * noise;
        rows.places[0].push_back(x);
        rows.value.push_back(truth(x) + noise);
      }
      const StudyFit fit = fit_of_rows(study_of_rows(form, rows));
      ASSERT_EQ(name(fit.status), "converged") << form << ", seed " << seed << ": " << fit.why;
      EXPECT_LE(fit.rms_error, std::sqrt(square / 60)) << form << ", seed " << seed;
    }
  }
}

const MeasuredRows measured_line{
    OthersText("line.csv"), {{0, 1, 2, 4, 7}}, {1.1, 2.9, 5.2, 8.7, 15.4}, {0.1, 0.2, 0.1, 0.3, 0.2}};

/// The line a + b x by the sums of textbooks: Press, Teukolsky, Vetterling, Flannery 2007, "Numerical
/// Recipes", 15.2.
struct Line {
  double a, b, variance_a, variance_b, covariance, chi_square;
};

Line line_of(const MeasuredRows& rows, const Numbers& sigma) {
  double s = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  const Numbers &x = rows.places[0], &y = rows.value;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = 1 / (sigma[i] * sigma[i]);
    s += w;
    sx += w * x[i];
    sy += w * y[i];
    sxx += w * x[i] * x[i];
    sxy += w * x[i] * y[i];
  }
  const double d = s * sxx - sx * sx;
  Line line{(sxx * sy - sx * sxy) / d, (s * sxy - sx * sy) / d, sxx / d, s / d, -sx / d, 0};
  for (std::size_t i = 0; i < x.size(); ++i)
    line.chi_square += std::pow((y[i] - line.a - line.b * x[i]) / sigma[i], 2);
  return line;
}

void expect_line(const StudyFit& fit, const Line& line, double variance_of_noise, const std::string& what) {
  ASSERT_EQ(name(fit.status), "converged") << what << ": " << fit.why;
  ASSERT_TRUE(fit.statistics) << what;
  const RowStatistics& statistics = *fit.statistics;
  EXPECT_EQ(statistics.freedom, 3u) << what;
  expect_near_relative(statistics.covariance[0][1], line.covariance * variance_of_noise, 1e-14, what);
  EXPECT_EQ(statistics.covariance[0][1], statistics.covariance[1][0]);
  for (const std::size_t i : {0U, 1U}) {
    const double value = fit.parameters[i],
                 error = std::sqrt((i == 0 ? line.variance_a : line.variance_b) * variance_of_noise);
    expect_near_relative(value, i == 0 ? line.a : line.b, 1e-14, what);
    expect_near_relative(statistics.standard_errors[i], error, 1e-14, what + ", error");
    // A linear form: the profile interval is the standard error.
    expect_near_relative(value - *statistics.profiles[i].lower, error, 1e-9, what + ", lower");
    expect_near_relative(*statistics.profiles[i].upper - value, error, 1e-9, what + ", upper");
  }
}

TEST(RowStudy, HasTheTextbookNumbersOfALine) {
  const Line weighted = line_of(measured_line, measured_line.sigma);
  const StudyFit absolute = fit_of_rows(study_of_rows("a + b x", measured_line, "1/sigma"));
  expect_line(absolute, weighted, 1, "absolute sigma");
  EXPECT_TRUE(absolute.is_global);
  EXPECT_TRUE(absolute.statistics->is_absolute);
  expect_near_relative(absolute.statistics->variance, weighted.chi_square / 3, 1e-13, "reduced chi-square");

  // Another weight only compares rows: its scale does not matter, and the residuals give the noise.
  for (const char* weight : {"2/sigma", "1/(8 sigma)"}) {
    const StudyFit relative = fit_of_rows(study_of_rows("a + b x", measured_line, weight));
    EXPECT_FALSE(relative.statistics->is_absolute) << weight;
    expect_line(relative, weighted, weighted.chi_square / 3, weight);
  }

  MeasuredRows without_sigma = measured_line;
  without_sigma.sigma.clear();
  const Line plain = line_of(measured_line, Numbers(5, 1));
  const StudyFit fit = fit_of_rows(study_of_rows("a + b x", without_sigma));
  expect_line(fit, plain, plain.chi_square / 3, "no sigma");
  EXPECT_FALSE(fit.statistics->is_absolute);
  expect_near_relative(fit.statistics->variance, plain.chi_square / 3, 1e-13, "s^2");
  expect_near_relative(fit.rms_error, std::sqrt(plain.chi_square / 5), 1e-13, "rms");
  double largest = 0;
  std::size_t row = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const double residual = std::abs(measured_line.value[i] - plain.a - plain.b * measured_line.places[0][i]);
    if (residual > largest) row = i + 1;
    largest = std::max(largest, residual);
  }
  EXPECT_EQ(fit.max_abs_error.row, row);
  expect_near_relative(fit.max_abs_error.magnitude, largest, 1e-12, "largest residual");
  EXPECT_EQ(fit.max_abs_error.at, Numbers{measured_line.places[0][row - 1]});
}

/// A problem of "Statistical Reference Datasets: Nonlinear Regression", National Institute of Standards and
/// Technology, www.itl.nist.gov/div898/strd: its certified parameters, their standard deviations and that of
/// the residuals, to 11 digits.
struct Certified {
  const char* name;
  std::string form;
  Numbers x, y, parameters, standard_errors;
  double deviation;
};

std::vector<Certified> certified() {
  Numbers twentieths, fives;
  for (int i = 0; i < 24; ++i) twentieths.push_back(i / 20.0);
  for (int i = 0; i < 16; ++i) fives.push_back(50 + 5 * i);
  return {
      {"Misra1a",
       "a (1 - exp(-b x))",
       {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0},
       {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78},
       {2.3894212918E+02, 5.5015643181E-04},
       {2.7070075241E+00, 7.2668688436E-06},
       1.0187876330E-01},
      // A Hessian whose diagonal spans 14 powers of ten.
      {"Misra1c",
       "a (1 - (1 + 2 b x)^(-0.5))",
       {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0},
       {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78},
       {6.3642725809E+02, 2.0813627256E-04},
       {4.6638326572E+00, 1.7728423155E-06},
       5.8428615257E-02},
      {"Lanczos3",
       "a exp(-b x) + d exp(-f x) + g exp(-h x)",
       twentieths,
       {2.5134, 2.0443, 1.6684, 1.3664, 1.1232, 0.9269, 0.7679, 0.6389, 0.5338, 0.4479, 0.3776, 0.3197,
        0.2720, 0.2325, 0.1997, 0.1723, 0.1493, 0.1301, 0.1138, 0.1000, 0.0883, 0.0783, 0.0698, 0.0624},
       {8.6816414977E-02, 9.5498101505E-01, 8.4400777463E-01, 2.9515951832E+00, 1.5825685901E+00,
        4.9863565084E+00},
       {1.7197908859E-02, 9.7041624475E-02, 4.1488663282E-02, 1.0766312506E-01, 5.8371576281E-02,
        3.4436403035E-02},
       2.9923229172E-05},
      {"BoxBOD",
       "a (1 - exp(-b x))",
       {1, 2, 3, 5, 7, 10},
       {109, 149, 149, 191, 213, 224},
       {2.1380940889E+02, 5.4723748542E-01},
       {1.2354515176E+01, 1.0455993237E-01},
       1.7088072423E+01},
      {"MGH09",
       "a (x^2 + b x)/(x^2 + d x + f)",
       {4, 2, 1, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625},
       {0.1957, 0.1947, 0.1735, 0.16, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246},
       {1.9280693458E-01, 1.9128232873E-01, 1.2305650693E-01, 1.3606233068E-01},
       {1.1435312227E-02, 1.9633220911E-01, 8.0842031232E-02, 9.0025542308E-02},
       6.6279236551E-03},
      {"MGH10",
       "a exp(b/(x + d))",
       fives,
       {34780, 28610, 23650, 19630, 16370, 13720, 11540, 9744, 8261, 7030, 6005, 5147, 4427, 3820, 3307,
        2872},
       {5.6096364710E-03, 6.1813463463E+03, 3.4522363462E+02},
       {1.5687892471E-04, 2.3309021107E+01, 7.8486103508E-01},
       2.6009740065E+00},
  };
}

// Without a start: the certified problems give two, from which many solvers fail.
TEST(RowStudy, HasTheCertifiedNumbersOfNist) {
  for (const Certified& known : certified()) {
    const StudyFit fit =
        fit_of_rows(study_of_rows(known.form, {OthersText(known.name), {known.x}, known.y, {}}));
    ASSERT_EQ(name(fit.status), "converged") << known.name << ": " << fit.why;
    ASSERT_TRUE(fit.statistics) << known.name;
    constexpr double eleven_digits = 6e-11;
    for (std::size_t i = 0; i < known.parameters.size(); ++i) {
      const std::string what = known.name + (", " + fit.names[i]);
      expect_near_relative(fit.parameters[i], known.parameters[i], eleven_digits, what);
      expect_near_relative(fit.statistics->standard_errors[i], known.standard_errors[i], eleven_digits, what);
    }
    expect_near_relative(std::sqrt(fit.statistics->variance), known.deviation, eleven_digits, known.name);
  }
}

TEST(RowStudy, RecoversADecay) {
  MeasuredRows rows{OthersText("decay.csv"), {{}}, {}, {}};
  for (int i = 0; i < 12; ++i) {
    rows.places[0].push_back(i / 4.0);
    rows.value.push_back(2 * std::exp(-1.5 * i / 4.0) + 0.25);
  }
  const StudyFit fit = fit_of_rows(study_of_rows("a exp(-b x) + d", rows));
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  const Numbers expected{2, 1.5, 0.25};
  for (std::size_t i = 0; i < 3; ++i)
    expect_near_relative(fit.parameters[i], expected[i], 1e-14, fit.names[i]);
  EXPECT_FALSE(fit.statistics) << "the residuals are rounding";
  rows.sigma.assign(12, 0.1);
  EXPECT_TRUE(fit_of_rows(study_of_rows("a exp(-b x) + d", rows, "1/sigma")).statistics)
      << "sigma is the noise";
}

// Of more than 2000 rows the search begins with some.
TEST(RowStudy, FitsManyRows) {
  for (const int count : {2000, 2001, 4500}) {
    MeasuredRows rows{OthersText("decay.csv"), {{}}, {}, {}};
    for (int i = 0; i < count; ++i) {
      rows.places[0].push_back(3.0 * i / count);
      rows.value.push_back(2 * std::exp(-1.5 * rows.places[0].back()) + 0.25);
    }
    const StudyFit fit = fit_of_rows(study_of_rows("a exp(-b x) + d", rows));
    ASSERT_EQ(name(fit.status), "converged") << count << ": " << fit.why;
    expect_near_relative(fit.parameters[1], 1.5, 1e-13, to_text(static_cast<double>(count)));
  }
}

// With the values m + {-1, 0, 1} the sum of squares of exp(a) is 3 (exp(a) - m)^2 + 2: with sigma = 1 it
// grows by 1 at exp(a) = m +- 1/sqrt(3).
TEST(RowStudy, ProfilesAreClosedOrOpen) {
  const auto fit_with_mean = [](double m) {
    return fit_of_rows(
        study_of_rows("exp(a)", {OthersText("m.csv"), {{1, 2, 3}}, {m - 1, m, m + 1}, {1, 1, 1}}, "1/sigma"));
  };
  const double step = 1 / std::sqrt(3.0);
  for (const double mean : {2.0, 0.6}) {
    const StudyFit fit = fit_with_mean(mean);
    ASSERT_TRUE(fit.statistics) << mean;
    EXPECT_NEAR(*fit.statistics->profiles[0].lower, std::log(mean - step), 1e-9) << mean;
    EXPECT_NEAR(*fit.statistics->profiles[0].upper, std::log(mean + step), 1e-9) << mean;
  }
  const StudyFit open = fit_with_mean(0.5);
  EXPECT_FALSE(open.statistics->profiles[0].lower);
  EXPECT_NEAR(*open.statistics->profiles[0].upper, std::log(0.5 + step), 1e-9);

  // The others are minimised again: the slope of a line, as a logarithm.
  MeasuredRows rows = measured_line;
  const Line line = line_of(rows, rows.sigma);
  const StudyFit slope = fit_of_rows(study_of_rows("a + exp(b) x", rows, "1/sigma"));
  EXPECT_NEAR(*slope.statistics->profiles[1].lower, std::log(line.b - std::sqrt(line.variance_b)), 1e-9);
  EXPECT_NEAR(*slope.statistics->profiles[1].upper, std::log(line.b + std::sqrt(line.variance_b)), 1e-9);
}

TEST(RowStudy, ProfilesEndWhereTheFormHasNoValue) {
  // sqrt(b + x) has no value at x = 0 with b below 0.
  const MeasuredRows rows{OthersText("root.csv"), {{0, 0.25, 1, 4}}, {0.3, 0.4, 1.1, 1.9}, {1, 1, 1, 1}};
  const StudyFit fit = fit_of_rows(study_of_rows("sqrt(b + x)", rows, "1/sigma"));
  ASSERT_TRUE(fit.statistics) << fit.why;
  EXPECT_NEAR(*fit.statistics->profiles[0].lower, 0, 1e-9);
}

// As many rows as parameters leave nothing to compute errors from; one more does.
TEST(RowStudy, NeedsMoreRowsThanParametersForErrors) {
  const MeasuredRows two{OthersText("m.csv"), {{0, 1}}, {1, 3}, {}},
      three{OthersText("m.csv"), {{0, 1, 2}}, {1, 3, 4}, {}};
  EXPECT_FALSE(fit_of_rows(study_of_rows("a + b x", two)).statistics);
  EXPECT_EQ(fit_of_rows(study_of_rows("a + b x", three)).statistics->freedom, 1u);
  EXPECT_THROW(fit_of_rows(study_of_rows("a + b x + d x^2", two)), UserError);
}

TEST(RowStudy, SaysWhatRowsDoNotDetermine) {
  const StudyFit flat =
      fit_of_rows(study_of_rows("a + b x", {OthersText("m.csv"), {{1, 1, 1}}, {2, 3, 4}, {}}));
  EXPECT_EQ(name(flat.status), "degenerate");
  EXPECT_FALSE(flat.statistics);
  // Left and right of the middle are as good, and different curves.
  const StudyFit two = fit_of_rows(study_of_rows(
      "exp(-4 (x - m)^2)", {OthersText("m.csv"), {{-1, -0.5, 0, 0.5, 1}}, {1, 0.5, 0, 0.5, 1}, {}}));
  EXPECT_EQ(name(two.status), "ambiguous");
}

// Rows at every tenth are as well on a wave of 20 pi more: the slow one counts.
TEST(RowStudy, TakesTheSlowestWave) {
  MeasuredRows rows{OthersText("wave.csv"), {{}}, {}, {}};
  for (int i = 0; i < 30; ++i) {
    rows.places[0].push_back(i / 10.0);
    rows.value.push_back(std::sin(0.7 * i + 0.4) + (i % 3) / 50.0);
  }
  Study study = study_of_rows("a sin(b x + p)", rows);
  EXPECT_NEAR(std::abs(fit_of_rows(study).parameters[1]), 7, 0.1);
  const StudyFit minimax = solve_minimax_study(read_study(study), {}, {});
  ASSERT_EQ(minimax.status, Status::converged) << minimax.why;
  EXPECT_NEAR(std::abs(minimax.parameters[1]), 7, 0.1);
}

// The starts reach as far as the numbers of the rows, which have units.
TEST(RowStudy, StartsAtTheSizesOfTheRows) {
  const auto starts = [](double x, double y) {
    return starts_of(read_study(study_of_rows("a exp(-b x)", {OthersText("m.csv"), {{0, x}}, {0, y}, {}})),
                     1);
  };
  EXPECT_EQ(starts(1, 1).octaves, 6);
  EXPECT_EQ(starts(1, 1).count, 32u);
  EXPECT_EQ(starts(2, 1).count, 32u);
  EXPECT_EQ(starts(1024, 1).octaves, 16);
  EXPECT_EQ(starts(1, 0.0009765625).octaves, 16);
  EXPECT_EQ(starts(1024, 1).count, 128u);
}

TEST(RowStudy, TakesARelativeErrorAndAnyWeight) {
  // The mean of (a/y - 1)^2 over y = 1, 2 is least at a = (1 + 1/2)/(1 + 1/4).
  Study relative = study_of_rows("a", {OthersText("m.csv"), {{1, 2}}, {1, 2}, {}});
  relative.error = Error::relative;
  EXPECT_NEAR(fit_of_rows(relative).parameters[0], 1.2, 1e-15);
  EXPECT_NEAR(
      fit_of_rows(study_of_rows("a", {OthersText("m.csv"), {{1, 2}}, {1, 2}, {}}, "1/value")).parameters[0],
      1.2, 1e-15);
  // The weight multiplies the error: the mean of x^2 (a - y)^2.
  EXPECT_NEAR(fit_of_rows(study_of_rows("a", {OthersText("m.csv"), {{1, 2}}, {1, 2}, {}}, "x")).parameters[0],
              1.8, 1e-15);
}

TEST(RowStudy, AnswersBadInputWithOneLine) {
  const Study good = study_of_rows("a + b x", measured_line, "1/sigma");
  const auto fault_of = [](const Study& study) { return testing::refusal([&] { fit_of_rows(study); }); };
  EXPECT_EQ(fault_of(good), "");
  const auto refusal = [&]<class T>(T Study::*member, const std::type_identity_t<T>& value) {
    Study study = good;
    study.*member = value;
    return fault_of(study);
  };
  EXPECT_EQ(refusal(&Study::over, {}), "--form needs --over, a column of the table: for example --over x");
  EXPECT_EQ(refusal(&Study::over, {{"x", "0", "1"}}),
            "--over 'x=0:1' has a range, but the rows of the table give the values: leave it out");
  Study without_rows = good;
  without_rows.rows = nullptr;
  without_rows.target = "x";
  EXPECT_EQ(fault_of(without_rows), "--over 'x' needs a range: for example 0:1");
  EXPECT_EQ(refusal(&Study::over, {{"value", "", ""}}),
            "--over 'value': a table has this name for its measured values");
  EXPECT_EQ(refusal(&Study::form, "a + sigma x"),
            "--form: its parameter 'sigma': a table has this name for its standard deviations");
  EXPECT_EQ(refusal(&Study::given, {{"value", "1"}}),
            "--given 'value': a table has this name for its measured values");
  EXPECT_EQ(refusal(&Study::definitions, {{"sigma", {}, "2"}}),
            "--let 'sigma': a table has this name for its standard deviations");
  EXPECT_EQ(refusal(&Study::form, "a + b x + d x^2 + f x^3 + g x^4 + h x^5"),
            "'line.csv' has fewer rows than the form has parameters: 5 and 6");
  EXPECT_EQ(refusal(&Study::weight, "max(x - 1, 0)"),
            "--weight must be finite and greater than 0; it is not at line 2 of 'line.csv'");
  Study without_sigma = study_of_rows("a + sigma x", {OthersText("m.csv"), {{1, 2, 3}}, {1, 0, 2}, {}});
  EXPECT_EQ(fault_of(without_sigma), "") << "the name is free";
  without_sigma.error = Error::relative;
  EXPECT_EQ(fault_of(without_sigma),
            "--error 'relative' divides by the target, which is 0 at line 3 of 'm.csv': leave that row out");
}

}  // namespace
}  // namespace shadefit
