#include "fit/formula/named_formulas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/formula/parse_formula.hpp"
#include "reports/io/files.hpp"

namespace shadefit {
namespace {

/// A formula in the language at numbers.
double value_of(const std::string& formula, const std::vector<double>& numbers) {
  const FormulaNames names{.variables = {"p", "q", "r", "s"}, .takes_integrals = true};
  return evaluate<double>(read_formula(formula, names).formula, [&](const std::string& name) {
    return numbers.at(static_cast<std::size_t>(name.front() - 'p'));
  });
}

// The arguments have the order of the templates, and the branches of `choose` are both taken.
TEST(NamedFormulas, AreTheirTemplates) {
  EXPECT_EQ(value_of("gaussian_lobe(p, q, r)", {0.7, 9, 0.77}), gaussian_lobe(0.7, 9.0, 0.77));
  EXPECT_EQ(value_of("scaled_gaussian_lobe(p, q, r, s)", {0.7, 9, 1.1, 0.77}),
            scaled_gaussian_lobe(0.7, 9.0, 1.1, 0.77));
  EXPECT_EQ(value_of("blinn_lobe_of_cosine(p, q, r)", {0.7, 9, 4.2}), blinn_lobe_of_cosine(0.7, 9.0, 4.2));
  for (const double c : {0.2, 0.8})
    EXPECT_EQ(value_of("lobe_log_ratio(p, q, r)", {c, 1 - c, 5}), lobe_log_ratio(c, 1 - c, 5.0)) << c;
  EXPECT_EQ(value_of("schlick_reflectance(p, q)", {0.04, 0.3}), schlick_reflectance(0.04, 0.3));
  EXPECT_EQ(value_of("fresnel_quartic(p, q, r, s, 2)", {0.5, -1, 2, -3}),
            fresnel_quartic(0.5, -1.0, 2.0, -3.0, 2.0));
  for (const double c : {0.3, 0.9})  // of total reflection and beyond
    EXPECT_EQ(value_of("dielectric_reflectance(p, q)", {c, 0.75}), dielectric_reflectance(c, 0.75)) << c;
}

TEST(NamedFormulas, AreListedInTheDocs) {
  const std::string docs = read_file(SHADEFIT_SOURCE_DIR "/docs/truths.md");
  for (const NamedFormula& named : named_formulas()) {
    std::string call = "`" + std::string(named.name) + "(";
    for (const std::string& argument : named.definition.arguments)
      call += (call.ends_with("(") ? "" : ", ") + argument;
    EXPECT_NE(docs.find(call + ")`"), std::string::npos) << call;
  }
  EXPECT_EQ(find_formula("gaussian_lob"), nullptr);
}

// A name is one of the language only before a parenthesis; a definition of the user comes first.
TEST(NamedFormulas, GiveWayToTheUser) {
  FormulaNames names{.variables = {"x"}, .takes_integrals = true};
  names.definitions.emplace("schlick_weight", Definition{{"c"}, Symbolic::variable("c")});
  EXPECT_EQ(to_text(read_formula("schlick_weight(x)", names).formula), "x");
  names.definitions.clear();
  EXPECT_EQ(to_text(read_formula("schlick_weight(x)", names).formula), "(1 - x)^5");
  names.takes_parameters = true;
  EXPECT_EQ(read_formula("x schlick_weight", names).parameters, std::vector<std::string>{"schlick_weight"});
  EXPECT_THROW(read_formula("gaussian_lobe(x, 1)", names), std::invalid_argument);
}

}  // namespace
}  // namespace shadefit
