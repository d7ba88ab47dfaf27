#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "fit/formula/parse_formula.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

namespace shadefit {
namespace {

/// The formula of a reference: its function is a truth, but for one that follows from a truth.
std::string formula_of_reference(const std::vector<std::string>& row) {
  if (row[0] == "fresnel_average_inside") return "1 - (1 - fresnel_average(" + row[1] + "))/" + row[1] + "^2";
  std::string arguments = row[1];
  for (const std::string& argument : {row[2], row[3]})
    if (!argument.empty()) arguments += ", " + argument;
  return row[0] + "(" + arguments + ")";
}

TEST(Truths, AgreeWithReferencesOf20Digits) {
  const CsvTable table =
      parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/references/truths.csv"), "truths.csv");
  std::map<std::string, int> count;
  for (const auto& row : table.rows) {
    const std::string text = formula_of_reference(row);
    const Symbolic formula = read_formula(text, {.variables = {}, .takes_integrals = true}).formula;
    const double value = evaluate<double>(formula, [](const std::string&) { return 0.0; });
    const double truth = std::stod(row[4]);
    // A phase function may be greater than 1.
    EXPECT_NEAR(value, truth, 1e-12 * std::max(1.0, truth)) << text;
    ++count[row[0]];
  }
  const std::map<std::string, int> expected{{"burley_albedo", 15},
                                            {"oren_nayar_albedo", 15},
                                            {"fon_albedo", 15},
                                            {"fon_average", 3},
                                            {"eon_albedo", 30},
                                            {"fresnel_average", 5},
                                            {"fresnel_average_inside", 5},
                                            {"conductor_reflectance", 20},
                                            {"conductor_average", 4},
                                            {"hg", 12}};
  EXPECT_EQ(count, expected);
}

}  // namespace
}  // namespace shadefit
