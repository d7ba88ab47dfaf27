#include "reports/figures/figures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

Refit fitted(const char* id, const std::vector<Setting>& settings, const Metric& metric) {
  const Family& family = *find_family(id);
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

TEST(FitFigure, WithoutAFitThereIsNone) {
  Refit refit = fitted("fresnel-one-term", {Setting{}}, {});
  refit.fits.front().fit.status = Status::not_converged;
  EXPECT_THROW(fit_figure(refit), UserError);
}

}  // namespace
}  // namespace shadefit
