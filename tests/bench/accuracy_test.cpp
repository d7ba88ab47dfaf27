#include "bench/forms/accuracy.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
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
                             const std::string& arithmetic) {
  const std::vector<Cell>* found = nullptr;
  for (const auto& row : table().rows) {
    if (word(row, "form") != form || word(row, "constants") != constants || word(row, "exp2") != exp2 ||
        word(row, "arithmetic") != arithmetic)
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

// What was sampled in float keeps what was proven: the total error and the rounding; and the proven bound is
// not one of something else.
TEST(Accuracy, KeepsWhatIsProven) {
  int proven = 0, paired = 0;
  for (const auto& row : table().rows) {
    if (word(row, "total_error").empty() || word(row, "arithmetic") != "float") continue;
    ++proven;
    const double total = number(row, "total_error"), rounding = number(row, "rounding_error");
    const std::string which = word(row, "form") + " " + word(row, "constants") + " " + word(row, "exp2");
    EXPECT_LE(number(row, "max_abs_error"), total + rounding) << which;
    // at the place where |error| + bound |form| is largest the polynomial need not be at its worst, but near
    // it is
    EXPECT_GE(number(row, "max_abs_error"), 0.6 * total - rounding) << which;
    EXPECT_LE(rounding, 2e-5) << which;
    if (word(row, "paired") != "yes") continue;
    ++paired;
    EXPECT_LE(total, 1.0101 * number(row, "own_error")) << which;
  }
  EXPECT_GT(proven, 200);
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
  EXPECT_LE(pair->total(), 1.01 * pair->own_lower);
  const Constants plain{"", "", {{"x", "0", 0}}};
  EXPECT_EQ(pair_exp2("sg", plain)->degree, 3);
  EXPECT_FALSE(pair_exp2("schlick", {}));
  EXPECT_FALSE(pair_exp2("phong-sg", plain)) << "sampled";
}

// The best constants with the cheapest exp2 are no worse than the published ones with an exact exp2: proven.
TEST(Accuracy, TheCheapestExp2BeatsThePublishedConstants) {
  const auto& published = row("sg", "published-sg-offset-mean", "library", "float");
  const auto& cheap = row("sg", "minimax-absolute", "2", "float");
  EXPECT_LT(number(cheap, "total_error") + number(cheap, "rounding_error"), number(published, "own_error"));
  const auto& pair = row("fresnel-quadratic", "published-fresnel-quadratic-a", "library", "float");
  const auto& cheap_pair = row("fresnel-quadratic", "minimax-absolute", "3", "float");
  EXPECT_LT(number(cheap_pair, "total_error") + number(cheap_pair, "rounding_error"),
            number(pair, "own_error"));
}

}  // namespace
}  // namespace shadefit::forms
