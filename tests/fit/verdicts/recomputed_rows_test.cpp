#include "fit/verdicts/recomputed_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>

#include "app/studies/find_study.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

using Rows = std::vector<std::size_t>;

TEST(RecomputedRows, AreOneInAHundredAndAtLeastFive) {
  EXPECT_EQ(drawn_rows(0), Rows{});
  EXPECT_EQ(drawn_rows(1), Rows{1});
  EXPECT_EQ(drawn_rows(5), (Rows{1, 2, 3, 4, 5}));
  EXPECT_EQ(drawn_rows(500).size(), 5u);
  EXPECT_EQ(drawn_rows(501).size(), 6u);
  EXPECT_EQ(drawn_rows(100'000).size(), 1000u);
}

// The generator as the C++ standard defines it: x <- 48271 x mod 2^31 - 1, from 1.
TEST(RecomputedRows, AreTheSameOnEachMachine) {
  std::uint64_t x = 1;
  Rows expected;
  for (const std::size_t begin : {0U, 100U, 200U, 300U, 400U, 500U}) {
    x = x * 48271 % 2147483647;
    expected.push_back(begin + x % 100 + 1);
  }
  EXPECT_EQ(drawn_rows(600), expected);
}

/// The rows x = 1 .. 100 of x^2.
Study squares() {
  Study study{.target = "", .form = "a x", .over = {{"x", "", ""}}};
  MeasuredRows rows{.file = OthersText("squares.csv"), .places = {{}}, .value = {}, .sigma = {}};
  for (int x = 1; x <= 100; ++x) {
    rows.places[0].push_back(x);
    rows.value.push_back(x * x);
  }
  study.rows = std::make_shared<const MeasuredRows>(rows);
  return study;
}

Study changed(Study study, std::size_t row, double by) {
  MeasuredRows rows = *study.rows;
  rows.value[row - 1] += by;
  study.rows = std::make_shared<const MeasuredRows>(rows);
  return study;
}

TEST(RecomputedRows, FindsAChangedValueInADrawnRow) {
  const RecomputedRows right = recompute_rows(squares(), "x^2");
  EXPECT_EQ(right.drawn, 5u);
  EXPECT_TRUE(right.wrong.empty());
  const std::size_t row = drawn_rows(100)[2];
  // The largest value is 10^4: a difference of 10^-6 is the largest that agrees.
  EXPECT_TRUE(recompute_rows(changed(squares(), row, 0.99e-6), "x^2").wrong.empty());
  for (const double by : {1.01e-6, -1.01e-6, 1.0}) {
    const RecomputedRows found = recompute_rows(changed(squares(), row, by), "x^2");
    ASSERT_EQ(found.wrong.size(), 1u) << by;
    EXPECT_EQ(found.wrong[0].row, row);
    EXPECT_EQ(found.wrong[0].recomputed, std::pow(static_cast<double>(row), 2));
    EXPECT_DOUBLE_EQ(found.wrong[0].value, found.wrong[0].recomputed + by);
  }
  EXPECT_TRUE(recompute_rows(changed(squares(), row + 1, 1), "x^2").wrong.empty()) << "not drawn";
}

TEST(RecomputedRows, TakesDefinitionsAndNoValueAgreesWithNothing) {
  Study study = squares();
  study.definitions = {{"twice", {"y"}, "2 y"}};
  EXPECT_TRUE(recompute_rows(study, "twice(x)*x/2").wrong.empty());
  EXPECT_EQ(recompute_rows(study, "log(-x)").wrong.size(), 5u);
  EXPECT_EQ(testing::refusal([&] { recompute_rows(study, "twice(z)"); }),
            "recompute: formula 'twice(z)': expected one of x, twice, pi, ln2 and the functions, not "
            "'z' at place 7");
}

// The tables were computed by tests/references/make_albedo_tables.py.
TEST(RecomputedRows, OfShippedTablesAgree) {
  std::size_t tables = 0;
  for (const auto& path : study_files({std::string(SHADEFIT_SOURCE_DIR) + "/studies"})) {
    const StudyFile file = load_study(path);
    if (!file.recompute) continue;
    ++tables;
    for (const WrongRow& wrong : recompute_rows(file.study, *file.recompute).wrong)
      ADD_FAILURE() << file.table.unescaped() << ", row " << wrong.row << ": " << wrong.value << ", "
                    << wrong.recomputed;
  }
  EXPECT_GT(tables, 0u);
}

}  // namespace
}  // namespace shadefit
