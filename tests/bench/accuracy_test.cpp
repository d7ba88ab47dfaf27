#include "bench/forms/accuracy.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

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

/// A number of the row with these cells.
double number(const std::string& form, const std::string& constants, const std::string& exp2,
              const std::string& arithmetic, const std::string& of) {
  const std::vector<Cell>* found = nullptr;
  for (const auto& row : table().rows) {
    if (word(row, "form") != form || word(row, "constants") != constants || word(row, "exp2") != exp2 ||
        word(row, "arithmetic") != arithmetic)
      continue;
    EXPECT_EQ(found, nullptr) << form << " twice";
    found = &row;
  }
  if (found == nullptr) throw std::logic_error("no row " + form + " " + constants + " " + exp2);
  return std::get<Number>(found->at(column(of))).value;
}

// One test, as each is a process and the table takes a second.
TEST(Accuracy, OfEveryForm) {
  // of the published pair against (1-c)^5: 0.00362/(1 - 0.04) of the report's summary
  EXPECT_NEAR(
      number("fresnel-quadratic", "published-fresnel-quadratic-a", "library", "double", "max_abs_error"),
      0.00377, 5e-6);
  // a target against itself, correctly rounded functions: half an ulp
  EXPECT_LE(number("lobe-pow", "none", "", "double", "max_ulps"), 0.51);
  EXPECT_LE(number("lobe-pow", "none", "", "float", "max_ulps"), 0.51);
  // four squarings double a rounding each time: 1/2 (8 + 4 + 2 + 1) ulps at most, twice that across a power
  // of two
  EXPECT_LE(number("lobe-squarings", "none", "", "float", "max_ulps"), 15);
  EXPECT_GE(number("lobe-squarings", "none", "", "half", "max_ulps"), 1);
  // The best constants with the cheapest exp2 are no worse than the published ones with an exact exp2.
  EXPECT_LT(number("sg", "minimax-absolute", "2", "float", "max_abs_error"),
            number("sg", "published-sg-offset-mean", "library", "float", "max_abs_error"));
  EXPECT_LT(
      number("fresnel-quadratic", "minimax-exp2-2", "2", "float", "max_abs_error"),
      number("fresnel-quadratic", "published-fresnel-quadratic-a", "library", "float", "max_abs_error"));

  std::map<std::string, int> in_float;
  for (const auto& row : table().rows) {
    if (!word(row, "exp2").empty() && word(row, "arithmetic") == "float") ++in_float[word(row, "form")];
  }
  EXPECT_EQ(in_float.size(), 9U) << "all forms with an exp2";
  EXPECT_GE(in_float["gloss-sg"], 18) << "three offsets, six exp2";
  EXPECT_GE(in_float["phong-sg"], 48) << "two offsets, four numbers of lights";
}

}  // namespace
}  // namespace shadefit::forms
