#include "reports/figures/figures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <variant>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

Refit fitted(const char* id, const std::vector<Setting>& settings, const Metric& metric) {
  const FittableFamily& family = *find_family(id);
  FitCache fits(family);
  return {&family, {}, fit_and_assess(fits, settings, std::array{metric}), {}};
}

double value_at(const Table& table, std::size_t row, std::size_t column) {
  return std::get<Number>(table.rows.at(row).at(column)).value;
}

TEST(FitFigure, HasTheErrorAndAMarkAtEachContact) {
  const Refit refit = fitted("fresnel-quadratic", {Setting{}}, {.norm = Norm::minimax});
  const Fit& fit = refit.fits.front().fit;
  const Figure figure = fit_figure(refit);
  EXPECT_EQ(figure.data.columns, (std::vector<std::string>{"cosine", "target", "form", "error", "contact"}));
  // Six digits are drawn: target and form round to within 5e-7, their difference to within 1e-6.
  const std::size_t middle = 200;
  EXPECT_EQ(value_at(figure.data, middle, 0), 0.5);
  EXPECT_NEAR(value_at(figure.data, middle, 1), 1.0 / 32, 1e-15) << "(1 - 1/2)^5";
  EXPECT_NEAR(value_at(figure.data, middle, 3),
              value_at(figure.data, middle, 2) - value_at(figure.data, middle, 1), 1e-15);
  ASSERT_EQ(figure.data.rows.size(), 401 + fit.alternation.size());
  for (std::size_t i = 401; i < figure.data.rows.size(); ++i)
    EXPECT_NEAR(std::abs(value_at(figure.data, i, 4)), *fit.level, 1e-12) << i;
  EXPECT_NE(figure.script.find("'level 0.003402'"), std::string::npos) << figure.script;
}

TEST(FitFigure, AWeightHidesTheLevelWhichIsThatOfTheWeightedError) {
  Metric metric{.norm = Norm::minimax};
  metric.weight = "1 + 4 c";
  const Figure figure = fit_figure(fitted("fresnel-one-term", {Setting{}}, metric));
  EXPECT_EQ(figure.data.rows.size(), 401U);
  EXPECT_EQ(figure.script.find("level"), std::string::npos);
}

TEST(FitFigure, ASharpLobeIsShownWhereItIs) {
  EXPECT_EQ(value_at(fit_figure(fitted("sg-offset", {Setting(5)}, {})).data, 0, 0), 0);
  EXPECT_NEAR(value_at(fit_figure(fitted("sg-offset", {Setting(1000)}, {})).data, 0, 1), 1e-3, 1e-9);
}

TEST(FitFigure, ASweepHasARowForEachExponent) {
  const Figure narrow = fit_figure(fitted("sg-offset", {3, 4}, {}));
  EXPECT_EQ(narrow.data.columns,
            (std::vector<std::string>{"exponent", "x", "max_abs_error", "rms_error", "scaled", "target_1",
                                      "form_1", "error_1", "target_2", "form_2", "error_2"}));
  EXPECT_EQ(narrow.script.find("set logscale x"), std::string::npos);
  EXPECT_NE(fit_figure(fitted("sg-offset", {3, 300}, {})).script.find("set logscale x"), std::string::npos);
}

TEST(FitFigure, ASweepHasTheCurvesOfThreeExponents) {
  const Figure figure = fit_figure(fitted("sg-offset", {3, 4, 5, 6, 16}, {}));
  EXPECT_EQ(figure.data.columns.back(), "error_3");
  // After the five exponents: k (1 - c) = 4 is in the middle of 0 to 8, and c = 3/4 at k = 16.
  const std::size_t middle = 5 + 100;
  EXPECT_EQ(value_at(figure.data, middle, 4), 4);
  EXPECT_NEAR(value_at(figure.data, middle, 11), std::pow(0.75, 16), 1e-7);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(figure.data.rows.at(middle).at(5)))
      << "at k = 3 the cosine would be below 0";
}

TEST(FitFigure, WithoutAFitThereIsNone) {
  Refit refit = fitted("fresnel-one-term", {Setting{}}, {});
  refit.fits.front().fit.status = Status::not_converged;
  EXPECT_THROW(fit_figure(refit), UserError);
}

}  // namespace
}  // namespace shadefit
