#include "fit/squares/minimax_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/studies/find_study.hpp"
#include "approx/scalar.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "fit/verdicts/study_verdict.hpp"

// Minimax fits of measured rows. References are computed here, in long double and by other ways.
namespace shadefit {
namespace {

using Wide = std::vector<long double>;

Study study_of(const std::string& form, const std::vector<double>& x, const std::vector<double>& value,
               const std::string& weight = "1") {
  return {.target = "",
          .form = form,
          .over = {{"x", "", ""}},
          .weight = weight,
          .rows = std::make_shared<const MeasuredRows>(MeasuredRows{OthersText("rows.csv"), {x}, value, {}})};
}

StudyFit rows_fit(const Study& study) {
  return solve_minimax_rows(read_study(study), study.starts);
}

const std::vector<double> uneven{0, 0.1, 0.15, 0.4, 0.5, 0.7, 0.72, 0.9, 1.3, 1.6, 2.2, 3};
const std::vector<double> measured{1.0, 0.8, 0.9, 0.2, 0.35, -0.3, -0.1, 0.4, 0.6, 1.7, 1.1, 2.9};

/// The shares of n + 1 rows of n numbers whose sum is 0, by elimination; the last share is 1.
Wide shares_of(std::vector<Wide> rows) {
  const std::size_t n = rows.size() - 1;
  // Equation j: the sum over the first n rows of share * rows[i][j] is -rows[n][j].
  std::vector<Wide> equations(n, Wide(n + 1));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i <= n; ++i) equations[j][i] = i < n ? rows[i][j] : -rows[n][j];
  for (std::size_t k = 0; k < n; ++k) {
    const auto pivot =
        std::max_element(equations.begin() + static_cast<std::ptrdiff_t>(k), equations.end(),
                         [&](const Wide& a, const Wide& b) { return std::abs(a[k]) < std::abs(b[k]); });
    std::swap(*pivot, equations[k]);
    for (std::size_t j = 0; j < n; ++j) {
      const long double factor = j == k ? 0 : equations[j][k] / equations[k][k];
      for (std::size_t i = k; i <= n; ++i) equations[j][i] -= factor * equations[k][i];
    }
  }
  Wide shares;
  for (std::size_t k = 0; k < n; ++k) shares.push_back(equations[k][n] / equations[k][k]);
  shares.push_back(1);
  return shares;
}

/// The least level of a linear form: the highest of all sets of n + 1 rows. That of a set is |sum of share *
/// value| / sum of |share|, as the shares cancel every form. `rows` has the parts of the form, times the
/// weight, and the value, times the weight. Source: de la Vallee Poussin 1911, "Sur la methode de
/// l'approximation minimum".
long double reference_level(const std::vector<Wide>& rows, std::size_t n) {
  long double highest = 0;
  std::vector<std::size_t> chosen(n + 1);
  const std::function<void(std::size_t, std::size_t)> choose = [&](std::size_t k, std::size_t from) {
    if (k <= n) {
      for (chosen[k] = from; chosen[k] < rows.size(); ++chosen[k]) choose(k + 1, chosen[k] + 1);
      return;
    }
    std::vector<Wide> set;
    for (const std::size_t row : chosen) set.push_back(rows[row]);
    const Wide shares = shares_of(set);
    long double sum = 0, size = 0;
    for (std::size_t i = 0; i <= n; ++i) {
      sum += shares[i] * set[i][n];
      size += std::abs(shares[i]);
    }
    highest = std::max(highest, std::abs(sum) / size);
  };
  choose(0, 0);
  return highest;
}

TEST(MinimaxRows, OfALinearFormHaveTheLevelOfTheWorstSet) {
  std::vector<Wide> plain, weighted;
  for (std::size_t i = 0; i < uneven.size(); ++i) {
    const long double x = uneven[i], y = measured[i], w = 1 / (1 + x);
    plain.push_back({1, x, x * x, y});
    weighted.push_back({w, w * x, w * x * x, w * y});
  }
  for (const auto& [weight, rows] : {std::pair("1", plain), std::pair("1/(1 + x)", weighted)}) {
    const StudyFit fit = rows_fit(study_of("a + b x + d x^2", uneven, measured, weight));
    ASSERT_EQ(name(fit.status), "converged") << fit.why;
    EXPECT_TRUE(fit.is_global);
    EXPECT_EQ(fit.digits, 14);
    EXPECT_NEAR(*fit.level, static_cast<double>(reference_level(rows, 3)), 1e-15) << weight;
    EXPECT_EQ(fit.touching.size(), 4u) << weight;
  }
}

// For each rate the rest is linear, so the rate alone is searched.
TEST(MinimaxRows, OfANonlinearFormHaveTheLevelOfASearch) {
  std::vector<double> values;
  for (const double x : uneven) values.push_back(2 * std::exp(-1.3 * x) + x / 2 + std::cos(20 * x) / 20);
  const auto level_at = [&](long double rate) {
    std::vector<Wide> rows;
    for (std::size_t i = 0; i < uneven.size(); ++i)
      rows.push_back({std::exp(-rate * uneven[i]), uneven[i], values[i]});
    return reference_level(rows, 2);
  };
  long double best = HUGE_VALL;
  for (int i = 0; i <= 400; ++i) best = std::min(best, level_at(i / 100.0L));
  const StudyFit fit = rows_fit(study_of("a exp(-b x) + d x", uneven, values));
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_LE(*fit.level, static_cast<double>(best));
  EXPECT_NEAR(static_cast<double>(level_at(fit.parameters[1])), *fit.level, 1e-14);
}

// At x = 0 the form is 0, so that row has the level 1 alone. The others have their own: a - 2 = 4.6 - 2 a.
TEST(MinimaxRows, HaveTheLeastLevelsOneAfterTheOther) {
  const StudyFit fit = rows_fit(study_of("a x", {0, 1, 2}, {1, 2, 4.6}));
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_EQ(*fit.level, 1);
  EXPECT_NEAR(fit.parameters[0], 2.2, 1e-15);
  ASSERT_EQ(fit.touching.size(), 3u);
  EXPECT_NEAR(fit.touching[0].error, -1, 1e-15);
  EXPECT_NEAR(fit.touching[1].error, 0.2, 1e-15);
  EXPECT_NEAR(fit.touching[2].error, -0.2, 1e-15);
}

TEST(MinimaxRows, SayWhereTheyHaveNoAnswer) {
  const StudyFit exact = rows_fit(study_of("a + b x", {0, 1, 2}, {1, 2, 3}));
  EXPECT_EQ(exact.why, "the largest error is down to the rounding of the form: it has no level");
  const StudyFit same = rows_fit(study_of("a x + b (2 x)", {0, 1, 2}, {1, 2, 4.6}));
  EXPECT_EQ(name(same.status), "degenerate") << same.why;
}

/// A number in [-1, 1], the same on every machine.
double spread(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) / 4503599627370496.0 - 1;
}

/// The study of each table that comes with shadefit, and each form of it.
std::vector<std::string> table_studies() {
  std::vector<std::string> ids;
  for (const auto& path : study_files({std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies"}))
    if (load_study(path).study.rows) ids.push_back(path.stem().string());
  return ids;
}

class TableStudy : public ::testing::TestWithParam<std::string> {};

// From the definition: rows have the level, none exceeds it, no step near by lowers it; and no published set
// has a lower one.
TEST_P(TableStudy, HasALeastLevel) {
  const auto folder = std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies";
  const StudyFile file = load_study(folder / (GetParam() + ".toml"));
  std::uint64_t state = 1;
  for (const StudyForm& form : file.forms) {
    Study study = file.study;
    study.form = form.formula;
    study.starts = published_starts(file, form.id, study);
    const ReadStudy read = read_study(study);
    const StudyFit fit = rows_fit(study);
    if (form.id == "gaussian") {  // its width would become infinite at the first roughness, and then negative
      EXPECT_TRUE(fit.why.starts_with("the level falls, below 0.01401, as the form nears a pole")) << fit.why;
      continue;
    }
    ASSERT_EQ(name(fit.status), "converged") << form.id << ": " << fit.why;
    EXPECT_GE(fit.digits, 7) << form.id;  // 14, or half of them where there is a second level
    EXPECT_NEAR(largest_weighted_error(read, fit.parameters).magnitude / *fit.level, 1, 1e-9) << form.id;
    EXPECT_NEAR(std::abs(fit.touching.front().error) / *fit.level, 1, 1e-12) << form.id;
    for (int i = 0; i < 300; ++i) {
      std::vector<double> beside = fit.parameters;
      for (double& parameter : beside) parameter *= 1 + 1e-5 * spread(state) * (i % 3 == 0 ? 1e-3 : 1);
      EXPECT_GE(largest_weighted_error(read, beside).magnitude, *fit.level * (1 - 1e-9)) << form.id;
    }
    for (const PublishedSet& set : file.published) {
      if (set.form != form.id) continue;
      std::vector<double> values;
      for (const std::string& text : values_of(set, read.parameters))
        values.push_back(constant<double>(text));
      EXPECT_GT(largest_weighted_error(read, values).magnitude, *fit.level) << set.source.unescaped();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, TableStudy, ::testing::ValuesIn(table_studies()), [](const auto& study) {
  std::string name = study.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace shadefit
