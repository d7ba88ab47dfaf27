#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fit/catalogue/read_study_file.hpp"
#include "fit/study/study.hpp"
#include "fit/support/user_error.hpp"
#include "tests/app/refusal.hpp"
#include "tests/app/studies/line_study.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::line_study;
using testing::replaced;

std::string refusal_of(const std::string& text) {
  try {
    read_study_file(text, "s.toml");
  } catch (const UserError& error) {
    return error.what();
  }
  return "none";
}

TEST(StudyFile, ReadsWhatItSays) {
  const StudyFile file = read_study_file(line_study, "s.toml");
  EXPECT_EQ(file.id, "line");
  EXPECT_EQ(file.study.target, "x^2");
  ASSERT_EQ(file.forms.size(), 2u);
  EXPECT_EQ(file.forms[1].formula, "a x");
  EXPECT_EQ(file.norm, Norm::minimax);
  ASSERT_EQ(file.published.size(), 1u);
  EXPECT_EQ(file.published[0].values[0].second, "-0.125");
  EXPECT_EQ(file.published[0].claims[0].says, "an eighth");
}

TEST(StudyFile, ReadsAListOfClaims) {
  const StudyFile file = read_study_file(
      replaced(line_study, "claim = { max_abs_error = \"0.125\", says = \"an eighth\" }",
               "claim = [ { max_abs_error = \"0.125\", rms_error = \"0.1\" }, { mean_rel_error = \"0.3\", "
               "over = { x = \"1/2:1\" } } ]"),
      "s.toml");
  const auto& claims = file.published[0].claims;
  ASSERT_EQ(claims.size(), 3u);
  EXPECT_EQ(claims[1].error, StatedError::rms_error);
  EXPECT_TRUE(claims[1].over.empty());
  EXPECT_EQ(claims[2].error, StatedError::mean_rel_error);
  ASSERT_EQ(claims[2].over.size(), 1u);
  EXPECT_EQ(claims[2].over[0].lower, "1/2");
}

// Tables of TOML have no order of their own; definitions and variables have the order of the file.
TEST(StudyFile, KeepsTheOrderOfTheFile) {
  const StudyFile file = read_study_file(
      "schema = 1\nid = \"o\"\n[over]\ny = { range = \"0:1\", density = \"y\" }\nx = \"0:pi/2\"\n"
      "[given]\nk = \"3:5:1\"\n[let]\nz = \"1 - x\"\nf = { of = [\"t\"], is = \"t^2 z\" }\n"
      "[target]\nformula = \"f(y) k\"\n[[form]]\nid = \"p\"\nformula = \"a x\"\n"
      "[metric]\nerror = \"relative\"\nweight = \"1 + x\"\nexact_at = [0, \"1\"]\none_sided = \"above\"\n"
      "at_most = 2.5\nat_least = \"-1\"\n",
      "o.toml");
  EXPECT_EQ(file.study.over[0].variable, "y");
  EXPECT_EQ(file.study.over[0].density, "y");
  EXPECT_EQ(file.study.over[1].upper, "pi/2");
  EXPECT_EQ(file.given[0].second, (std::vector<std::string>{"3", "4", "5"}));
  EXPECT_EQ(file.study.definitions[0].name, "z");
  EXPECT_EQ(file.study.definitions[1].arguments, std::vector<std::string>{"t"});
  EXPECT_EQ(file.study.error, Error::relative);
  EXPECT_EQ(file.study.weight, "1 + x");
  EXPECT_EQ(file.constraints.exact_at, (std::vector<double>{0, 1}));
  EXPECT_EQ(file.constraints.one_sided, Side::above);
  EXPECT_EQ(file.constraints.at_most, 2.5);
  EXPECT_EQ(file.constraints.at_least, -1);
}

TEST(StudyFile, RefusesWithTheLine) {
  const auto refused = [](const std::string& before, const std::string& after) {
    return refusal_of(replaced(line_study, before, after));
  };
  EXPECT_EQ(refusal_of(line_study), "none");
  EXPECT_EQ(refused("schema = 1", "schema = 2"), "study 's.toml', line 1: the key 'schema' must be 1");
  EXPECT_EQ(refused("id = \"line\"\n[over]", "[over]"), "study 's.toml', line 1: the key 'id' is missing");
  EXPECT_EQ(refused("id = \"line\"\n[over]", "id = \"../line\"\n[over]"),
            "study 's.toml', line 1: id '../line' must be small letters, digits and '-', and not 'index'");
  EXPECT_EQ(refused("formula = \"x^2\"", "formulla = \"x^2\""),
            "study 's.toml', line 6: unknown key 'formulla': did you mean 'formula'?");
  EXPECT_EQ(refused("[metric]", "[metrics]"),
            "study 's.toml', line 13: unknown key 'metrics': did you mean 'metric'?");
  EXPECT_EQ(refused("a = \"-0.125\"", "a = -0.125"),
            "study 's.toml', line 17: 'a' must be a text in quotes, so that every digit is kept");
  EXPECT_EQ(refused("form = \"line\"", "form = \"lime\""),
            "study 's.toml', line 15: published form 'lime' is not the id of a form");
  EXPECT_EQ(refused("id = \"slope\"", "id = \"line\""),
            "study 's.toml', line 10: the form 'line' is there already");
  EXPECT_EQ(refused("\"minimax\"", "\"mini\""),
            "study 's.toml', line 14: norm 'mini' is unknown: it must be one of least-squares, minimax");
  EXPECT_EQ(refused("\"0:1\"", "\"0\""),
            "study 's.toml', line 4: over 'x=0' is not NAME=A:B or NAME=A:B:DENSITY");
  EXPECT_EQ(refused("\"0.125\"", "\"an eighth\""),
            "study 's.toml', line 19: max_abs_error 'an eighth' is not a number");
  EXPECT_EQ(refused("max_abs_error = \"0.125\", ", ""),
            "study 's.toml', line 19: a claim states one of max_abs_error, max_rel_error, mean_abs_error, "
            "mean_rel_error, rms_error, mean_square_error");
  EXPECT_EQ(refused("says = \"an eighth\"", "over = { y = \"0:1\" }"),
            "study 's.toml', line 19: unknown key 'y': it must be one of x");
  EXPECT_EQ(refused("says = \"an eighth\"", "over = { x = \"0.5\" }"),
            "study 's.toml', line 19: over 'x=0.5' is not NAME=A:B or NAME=A:B:DENSITY");
  EXPECT_EQ(refused("says = \"an eighth\"", "over = { x = \"0:1:x\" }"),
            "study 's.toml', line 19: over 'x=0:1:x' of a claim has no density");
  EXPECT_EQ(refused("says = \"an eighth\"", "over = { x = \"1:0\" }"),
            "study 's.toml', line 19: over 'x=1:0' is empty: its first end must be below its second");
  EXPECT_EQ(refused("says = \"an eighth\"", "over = \"0:1\""),
            "study 's.toml', line 19: 'over' must be a table");
  EXPECT_EQ(refused("claim = { max_abs_error = \"0.125\", says = \"an eighth\" }", "claim = [ \"0.125\" ]"),
            "study 's.toml', line 19: 'claim' must be a table");
  EXPECT_EQ(refused("max_abs_error = \"0.125\"", "max_error = \"0.125\""),
            "study 's.toml', line 19: unknown key 'max_error': did you mean 'rms_error'?");
  EXPECT_EQ(refused("\"0.125\"", "\"\""), "study 's.toml', line 19: max_abs_error '' is not a number");
  EXPECT_EQ(refused("\"0.125\"", "\"-0.125\""),
            "study 's.toml', line 19: max_abs_error '-0.125' is negative: an error is at least 0");
  EXPECT_EQ(refused("\"0.125\"", "0.125"),
            "study 's.toml', line 19: 'max_abs_error' must be a text in quotes, so that every digit is kept");
  EXPECT_EQ(refused("\"-0.125\"", "\"-O.125\""), "study 's.toml', line 17: a '-O.125' is not a number");
  EXPECT_EQ(refused("\"-0.125\"", "\"\""), "study 's.toml', line 17: a '' is not a number");
  EXPECT_EQ(refused("source = \"Chebyshev 1854, on mechanisms\"\n", ""),
            "study 's.toml', line 15: the key 'source' is missing");
  EXPECT_EQ(refused("\"Chebyshev 1854, on mechanisms\"", "\"\""),
            "study 's.toml', line 18: the source is empty: name author, year, title");
  EXPECT_EQ(refused("\"1.1\"", "\"l.1\""), "study 's.toml', line 20: b 'l.1' is not a number");
  EXPECT_EQ(refused("b = \"1.1\"", "slope = \"1.1\""),
            "study 's.toml', line 20: unknown key 'slope': it must be one of seen, replaced, a, b");
  EXPECT_EQ(refused("b = \"1.1\", ", ""), "study 's.toml', line 20: a variant needs the value that differs");
  EXPECT_EQ(refused("values = {", "values = [").substr(0, 50),
            "study 's.toml', line 17: Error while parsing value");
  EXPECT_EQ(refusal_of("schema = 1\nid = \"a\"\n"), "study 's.toml', line 1: a study needs [over]");
  EXPECT_EQ(refused("x = \"0:1\"\n", ""),
            "study 's.toml', line 3: [over] needs a variable and its range, for example x = \"0:1\"");
}

TEST(StudyFile, ReadsTheFieldsOfASource) {
  const auto with_cite = [](const std::string& fields) {
    return replaced(line_study, "values = {", "cite = { " + fields + " }\nvalues = {");
  };
  const StudyFile file = read_study_file(
      with_cite(R"(author = ["A", "B, C"], title = "T", year = "2016", url = "https://a.org/b")"), "s.toml");
  ASSERT_TRUE(file.published[0].cite.has_value());
  EXPECT_EQ(file.published[0].cite->authors, (std::vector{OthersText("A"), OthersText("B, C")}));
  EXPECT_EQ(file.published[0].cite->url, "https://a.org/b");
  expect_has(refusal_of(with_cite(R"(year = "2016")")), "'cite' needs an author or a title");
  expect_has(refusal_of(with_cite(R"(author = "A", yaer = "2016")")), "did you mean 'year'?");
  for (const char* url : {"a.org", "javascript:x", "https://a b", "https://a}"})
    expect_has(refusal_of(with_cite(std::string(R"(title = "T", url = ")") + url + "\"")),
               "is not an address");
}

}  // namespace
}  // namespace shadefit
