#include "bench/forms/accuracy.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "bench/forms/pairing.hpp"

namespace shadefit::forms {
namespace {

const Table& table() {
  static const Table made = accuracy_table();
  return made;
}

std::size_t column(const std::string& name) {
  for (std::size_t i = 0; i < table().columns.size(); ++i) {
    if (table().columns[i] == name) return i;
  }
  ADD_FAILURE() << "no column " << name;
  return 0;
}

std::string word(const std::vector<Cell>& row, const std::string& name) {
  return text(row.at(column(name)), Precision::report);
}

double number(const std::vector<Cell>& row, const std::string& name) {
  return std::get<Number>(row.at(column(name))).value;
}

/// The one row that is meant.
const std::vector<Cell>& row(const std::string& form, const std::string& constants, const std::string& exp2,
                             const std::string& arithmetic, const std::string& target = {}) {
  const std::vector<Cell>* found = nullptr;
  for (const auto& row : table().rows) {
    if (word(row, "form") != form || word(row, "constants") != constants || word(row, "exp2") != exp2 ||
        word(row, "arithmetic") != arithmetic || (!target.empty() && word(row, "target") != target))
      continue;
    EXPECT_EQ(found, nullptr) << form << " twice";
    found = &row;
  }
  if (found == nullptr) throw std::logic_error("no row " + form + " " + constants + " " + exp2);
  return *found;
}

TEST(Accuracy, KnowsWhatIsKnown) {
  // of the published pair against (1-c)^5: 0.00362/(1 - 0.04) of the README's table
  EXPECT_NEAR(
      number(row("fresnel-quadratic", "published-fresnel-quadratic-a", "library", "double"), "max_abs_error"),
      0.00377, 5e-6);
  // a target against itself, correctly rounded functions: half an ulp
  EXPECT_LE(number(row("lobe-pow", "none", "", "double"), "max_ulps"), 0.51);
  EXPECT_LE(number(row("lobe-pow", "none", "", "float"), "max_ulps"), 0.51);
  // four squarings double a rounding each time: 1/2 (8 + 4 + 2 + 1) ulps at most, twice that across a power
  // of two
  EXPECT_LE(number(row("lobe-squarings", "none", "", "float"), "max_ulps"), 15);
  EXPECT_GE(number(row("lobe-squarings", "none", "", "half"), "max_ulps"), 1);
}

// What was sampled in float keeps what was proven: the total error and the rounding.
TEST(Accuracy, KeepsWhatIsProven) {
  int paired = 0;
  for (const auto& row : table().rows) {
    if (word(row, "paired") != "yes" || word(row, "arithmetic") != "float") continue;
    ++paired;
    EXPECT_LE(number(row, "max_abs_error"), number(row, "total_error") + number(row, "rounding_error"))
        << word(row, "form") << " " << word(row, "constants");
    EXPECT_LE(number(row, "total_error"), 1.0101 * number(row, "own_error"));
    EXPECT_LE(number(row, "rounding_error"), 0.01 * number(row, "own_error") + 1e-4);
  }
  EXPECT_GT(paired, 30);
}

// The cheapest: with a degree less, what is sampled is more than 1 % above the form's own error or cannot be
// proven not to be: the bound of the polynomial adds what it adds at the worst place.
TEST(Pairing, TakesTheCheapest) {
  const Constants published{"", "", {{"a", "-5.55473", -5.55473}, {"b", "-6.98316", -6.98316}}};
  const auto pair = pair_exp2("fresnel-quadratic", published);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->degree, 4);
  EXPECT_NEAR(pair->own_upper, 0.00377, 5e-6);
  EXPECT_LE(pair->own_lower, pair->own_upper);
  EXPECT_LE(pair->total, 1.01 * pair->own_lower);
  const Constants plain{"", "", {{"x", "0", 0}}};
  EXPECT_EQ(pair_exp2("sg", plain)->degree, 3);
  EXPECT_FALSE(pair_exp2("schlick", {}));
  EXPECT_FALSE(pair_exp2("phong-sg", plain)) << "sampled";
}

// The goal of the lobe: the best constants with the cheapest exp2 are no worse than the published ones with
// an exact exp2.
TEST(Accuracy, TheCheapestExp2BeatsThePublishedConstants) {
  const double published =
      number(row("sg", "published-sg-offset-mean", "library", "double", "lobe"), "max_abs_error");
  EXPECT_LT(number(row("sg", "minimax-absolute", "2", "float", "lobe"), "max_abs_error"), published);
  const double pair =
      number(row("fresnel-quadratic", "published-fresnel-quadratic-a", "library", "double"), "max_abs_error");
  EXPECT_LT(number(row("fresnel-quadratic", "minimax-absolute", "3", "float"), "max_abs_error"), pair);
}

}  // namespace
}  // namespace shadefit::forms
