#include "bench/forms/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "bench/forms/pairing.hpp"
#include "fit/exp2/pair_for_exp2.hpp"

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

/// The row with these cells.
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

void expect_what_is_known() {
  // of the published pair against (1-c)^5: 0.00362/(1 - 0.04) of the report's summary
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

/// What float may add: an exponent A c - A is rounded at most by some ulps of A, which is 2955 and more for
/// the largest gloss and 24 for the fixed lobe.
double allowed_rounding(const std::string& form) {
  return form == "gloss-sg" ? 5e-4 : 2e-5;
}

// Samples in float are within the proven total error plus rounding, and near it, so the bound is not too
// loose.
void expect_what_is_proven() {
  std::map<std::string, int> proven, paired;
  for (const auto& row : table().rows) {
    const std::string form = word(row, "form");
    if (word(row, "total_error").empty() || word(row, "arithmetic") != "float") continue;
    ++proven[form];
    const double total = number(row, "total_error"), error = number(row, "max_abs_error");
    const std::string which = form + " " + word(row, "constants") + " " + word(row, "exp2");
    if (word(row, "paired") == "yes") {
      ++paired[form];
      // four digits, rounded up
      EXPECT_LE(total, 1.0111 * number(row, "own_error")) << which;
    }
    if (word(row, "rounding_error").empty()) {
      EXPECT_EQ(form, "phong-sg");
      EXPECT_LE(error, total) << which << ": lights in many directions";
      continue;
    }
    const double rounding = number(row, "rounding_error");
    EXPECT_LE(error, total + rounding) << which;
    // A gloss is decoded by exp2 too, and its two results need not be worst together. Otherwise the bound is
    // that of the form with its polynomial, and a grid of 4096 steps misses at most 2.1 % at a jump.
    EXPECT_GE(error, (form == "gloss-sg" ? 0.6 : 0.97) * total - rounding) << which;
    EXPECT_LE(rounding, allowed_rounding(form)) << which;
  }
  EXPECT_EQ(proven.size(), 9U) << "all forms with an exp2";
  EXPECT_GE(proven["gloss-sg"], 18) << "three offsets, six exp2";
  EXPECT_GE(proven["phong-sg"], 48) << "two offsets, four numbers of lights";
  for (const auto& [form, count] : proven) EXPECT_GE(paired[form], count / 6) << form;
}

// The cheapest: with a degree less the error is larger.
TEST(Pairing, TakesTheCheapest) {
  const Catalogue all = catalogue();
  const auto pair = [&](std::string_view target, std::string_view form, const Constants& constants) {
    return pair_exp2(target_of(all, target), form, constants);
  };
  const Constants published{"", "", {{"a", "-5.55473", -5.55473}, {"b", "-6.98316", -6.98316}}};
  const auto fresnel = pair("schlick", "fresnel-quadratic", published);
  ASSERT_TRUE(fresnel);
  EXPECT_EQ(fresnel->degree, 4);
  EXPECT_NEAR(fresnel->own_upper, 0.00377, 5e-6);
  EXPECT_LE(fresnel->own_lower, fresnel->own_upper);
  EXPECT_LE(fresnel->total(), 1.01 * fresnel->own_lower);
  // bounds are a thousandth above what they bound
  EXPECT_GT(fresnel->totals[3], 1.01 * 1.002 * fresnel->own_upper) << "degree 3 adds more than a hundredth";
  // The pair that was fitted to the cheapest polynomial is paired with it.
  const Constants fitted{"", "", {{"a", "-5.404911418", 0}, {"b", "-7.032870633", 0}}};
  const auto cheapest = pair("schlick", "fresnel-quadratic", fitted);
  EXPECT_EQ(cheapest->degree, 2);
  EXPECT_GE(cheapest->total(), fit_pair_for_exp2(2).level);
  EXPECT_LE(cheapest->total(), 1.002 * fit_pair_for_exp2(2).level);
  EXPECT_LT(cheapest->total(), fresnel->own_lower);
  EXPECT_FALSE(pair("schlick", "schlick", {}));
  const Constants plain{"", "", {{"x", "0", 0}}};
  const auto lobe = pair("lobe", "sg", plain);
  EXPECT_EQ(lobe->degree, 3);
  const auto lights = pair("phong-16", "phong-sg", plain);
  EXPECT_EQ(lights->degree, 3);
  EXPECT_EQ(lights->total(), 16 * lobe->total());
}

// At gloss 0 the lobe is c^2, and c^2 against exp(-2 (1-c)) errs most of all codes, where c = exp(-2 (1-c)).
TEST(Pairing, OfAGlossIsThatOfTheWidestLobe) {
  const Catalogue all = catalogue();
  const Constants plain{"", "", {{"m", "1.528766", 1.528766}, {"x", "0", 0}}};
  const auto gloss = pair_exp2(target_of(all, "lobe-gloss"), "gloss-sg", plain);
  ASSERT_TRUE(gloss);
  double c = 0.2;
  for (int i = 0; i < 100; ++i) c = std::exp(-2 * (1 - c));
  // bounds are a thousandth apart, and m is log2(2/ln 2) to six digits
  const double near = 1.1e-3 * c * (1 - c);
  EXPECT_NEAR(gloss->own_upper, c - c * c, near);
  EXPECT_LE(gloss->own_lower, gloss->own_upper);
  EXPECT_GE(gloss->own_lower, (1 - 1e-3) * gloss->own_upper);
  for (int degree = least_exp2_degree; degree <= largest_exp2_degree; ++degree) {
    const auto i = static_cast<std::size_t>(degree);
    const double bound = constant<double>(exp2_for_float[i - least_exp2_degree].bound);
    // the result off by the bound, and its power of 2 by 2 bound
    EXPECT_NEAR(gloss->totals[i], std::exp(-2 * (1 - bound) * (1 - c)) * (1 + bound) - c * c, near);
  }
}

// The best constants with the cheapest exp2 are no worse than the published ones with an exact exp2: proven.
void expect_the_cheapest_exp2_to_beat_published_constants() {
  const auto& published = row("sg", "published-sg-offset-mean", "library", "float");
  const auto& cheap = row("sg", "minimax-absolute", "2", "float");
  EXPECT_LT(number(cheap, "total_error") + number(cheap, "rounding_error"), number(published, "own_error"));
  const auto& pair = row("fresnel-quadratic", "published-fresnel-quadratic-a", "library", "float");
  const auto& cheap_pair = row("fresnel-quadratic", "minimax-exp2-2", "2", "float");
  EXPECT_LT(number(cheap_pair, "total_error") + number(cheap_pair, "rounding_error"),
            number(pair, "own_error"));
}

// One test, as each is a process and the table takes seconds.
TEST(Accuracy, OfEveryForm) {
  expect_what_is_known();
  expect_what_is_proven();
  expect_the_cheapest_exp2_to_beat_published_constants();
}

}  // namespace
}  // namespace shadefit::forms
