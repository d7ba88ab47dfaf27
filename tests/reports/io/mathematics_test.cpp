#include "reports/io/mathematics.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <stdexcept>

#include "fit/ledger/ledger.hpp"
#include "reports/io/writers.hpp"
#include "reports/sections/ledger_section.hpp"

namespace shadefit {
namespace {

TEST(Mathematics, RelationsHaveSeveralSides) {
  EXPECT_EQ(mathematics("a = b != 2"), "$a = b \\ne 2$");
  EXPECT_EQ(mathematics("c <= 1, k = 3"), "$c \\le 1$, $k = 3$");
  EXPECT_EQ(mathematics("c in [0,1/2]"), "$c \\in \\left[0, \\frac{1}{2}\\right]$");
  for (const char* words : {"a = ", "a =b", "c in 3 steps", "[0, 1", "[0]", "0 .. 0.7957"})
    EXPECT_EQ(mathematics(words), words);
}

TEST(StatementMathematics, IsWhatStandsBetweenMarks) {
  EXPECT_EQ(without_marks("`c^k` falls, `k > 2`"), "c^k falls, k > 2");
  EXPECT_EQ(with_mathematics("`c^k` falls, `k > 2`"), "$c^{k}$ falls, $k > 2$");
  EXPECT_EQ(with_mathematics("no formula, c^k"), "no formula, c^k");
  EXPECT_EQ(with_mathematics("`albedo + F0 <= 1`"), "$\\mathrm{albedo} + F_{0} \\le 1$");
  EXPECT_EQ(with_mathematics("`k = 3..15`"), "$k = 3, \\ldots, 15$");
  EXPECT_EQ(with_mathematics("`log(a) = log2(a*log(2))`"),
            "$\\ln\\left(a\\right) = \\log_2\\left(a \\ln\\left(2\\right)\\right)$");
  EXPECT_EQ(with_mathematics("`cos^rho(theta) ~ cos^(x rho)(theta/2)`"),
            "$\\cos^{\\rho} \\theta \\approx \\cos^{x \\rho} \\frac{\\theta}{2}$");
  EXPECT_EQ(with_mathematics("`round(2^g)`"), "$\\operatorname{round}\\left(2^{g}\\right)$");
  EXPECT_EQ(with_mathematics("the pair (`a`, `b`)"), "the pair $(a$, $b$)");
  EXPECT_EQ(with_mathematics("`D(m) (n.m)^a`"), "$D(m) \\left(n \\cdot m\\right)^{a}$");
  const std::string latex = write_latex(
      {{"v"}, {{std::string("50% of `c^k` and `c^`")}, {std::string("50% of `c^k`")}}}, Precision::report);
  EXPECT_NE(latex.find("\n50\\% of $c^{k}$ \\\\\n"), std::string::npos) << latex;
  EXPECT_NE(latex.find("\n50\\% of `c\\textasciicircum{}k` and"), std::string::npos)
      << "a user's text stays text: " << latex;
}

TEST(StatementMathematics, RefusesWhatCannotBeRead) {
  EXPECT_THROW(with_mathematics("`c^k falls"), std::invalid_argument);
  for (const char* unread : {"`c^`", "`1/2 pi`", "`unknown + 1`", "`c <= `", "``"})
    EXPECT_THROW(with_mathematics(unread), std::invalid_argument) << unread;
}

std::vector<JudgedClaim> unjudged_claims() {
  std::vector<JudgedClaim> all;
  for (const Topic& part : ledger()) {
    for (const Claim& record : part.claims) all.push_back({&part, &record, {}});
  }
  return all;
}

/// Why GitHub would not show a text as it is meant; empty if it does. A dollar opens mathematics after a
/// space alone (github/markup, issue 1742), and does not close it before a letter or digit. Markdown takes an
/// underscore after another sign for emphasis, a backslash before a sign for an escape, and reads < and |.
std::string fault_on_github(const std::string& text) {
  const auto is_alphanumeric = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  bool is_inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
    if (text[i] == '$') {
      if (is_inside ? is_alphanumeric(after) : before != ' ') return "a dollar next to a letter";
      if ((is_inside ? before : after) == ' ') return "a space inside a dollar";
      is_inside = !is_inside;
    }
    if (!is_inside) continue;
    if (text[i] == '_' && !is_alphanumeric(before)) return "an underscore after a sign";
    if (text[i] == '\\' && !is_alphanumeric(after)) return "an escaped sign";
    if (std::string_view("<|*`").find(text[i]) != std::string_view::npos) return "a sign of Markdown";
  }
  return is_inside ? "an open dollar" : "";
}

TEST(StatementMathematics, OfEveryClaimIsReadAndShown) {
  EXPECT_NE(fault_on_github("$a_{b}_{c}$"), "");
  EXPECT_NE(fault_on_github("($a$)"), "");
  EXPECT_NE(fault_on_github("$a$s"), "");
  EXPECT_NE(fault_on_github("$a"), "");
  for (const JudgedClaim& row : unjudged_claims()) {
    const std::string statement = with_mathematics(row.claim->statement);
    EXPECT_EQ(fault_on_github(statement), "") << row.claim->id << ": " << statement;
  }
}

/// The letters of formulas that stand in no word.
constexpr std::string_view signs_of_formulas = "^=~<>_*";

TEST(StatementMathematics, NoFormulaOfAClaimIsLeftUnmarked) {
  for (const JudgedClaim& row : unjudged_claims()) {
    bool is_formula = false;
    for (const char c : row.claim->statement) {
      if (c == '`') is_formula = !is_formula;
      EXPECT_TRUE(is_formula || signs_of_formulas.find(c) == std::string_view::npos)
          << row.claim->id << ": " << row.claim->statement;
    }
  }
}

TEST(StatementMathematics, MarksAreNotShown) {
  const std::vector<JudgedClaim> claims = unjudged_claims();
  const std::string csv = write_csv(claims_list(claims, false, true), Precision::report) +
                          write_csv(claims_table(claims), Precision::report);
  EXPECT_EQ(csv.find('`'), std::string::npos);
  for (const JudgedClaim& row : claims) {
    const std::string text = explanation(row), says = text.substr(0, text.find("\nsource"));
    EXPECT_EQ(says.find('`'), std::string::npos) << says;
    EXPECT_EQ(explanation_json(row)["statement"], without_marks(row.claim->statement));
  }
}

}  // namespace
}  // namespace shadefit
