#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fit/catalogue/read_study_file.hpp"
#include "fit/study/study.hpp"
#include "tests/app/refusal.hpp"
#include "tests/app/studies/line_study.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::line_study;
using testing::replaced;

std::string refusal_of(const std::string& text) {
  return testing::refusal([&] { read_study_file(text, "s.toml"); });
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
  struct Case {
    std::string before, after, line;  ///< of the study, and what is said
  };
  for (
      const auto& [before, after, line] : std::vector<Case>{
          {"schema = 1", "schema = 2", "1: the key 'schema' must be 1"},
          {"id = \"line\"\n[over]", "[over]", "1: the key 'id' is missing"},
          {"id = \"line\"\n[over]", "id = \"../line\"\n[over]",
           "1: id '../line' must be small letters, digits and '-', and not 'index'"},
          {"formula = \"x^2\"", "formulla = \"x^2\"", "6: unknown key 'formulla': did you mean 'formula'?"},
          {"[metric]", "[metrics]", "13: unknown key 'metrics': did you mean 'metric'?"},
          {"a = \"-0.125\"", "a = -0.125", "17: 'a' must be a text in quotes, so that every digit is kept"},
          {"form = \"line\"", "form = \"lime\"", "15: published form 'lime' is not the id of a form"},
          {"id = \"slope\"", "id = \"line\"", "10: the form 'line' is there already"},
          {"\"minimax\"", "\"mini\"", "14: norm 'mini' is unknown: it must be one of least-squares, minimax"},
          {"\"0:1\"", "\"0\"", "4: over 'x=0' is not NAME=A:B or NAME=A:B:DENSITY"},
          {"\"0.125\"", "\"an eighth\"", "19: max_abs_error 'an eighth' is not a number"},
          {"max_abs_error = \"0.125\", ", "",
           "19: a claim states one of max_abs_error, max_rel_error, mean_abs_error, mean_rel_error, rms_error, mean_square_error"},
          {"says = \"an eighth\"", "over = { y = \"0:1\" }", "19: unknown key 'y': it must be one of x"},
          {"says = \"an eighth\"", "over = { x = \"0.5\" }",
           "19: over 'x=0.5' is not NAME=A:B or NAME=A:B:DENSITY"},
          {"says = \"an eighth\"", "over = { x = \"0:1:x\" }",
           "19: over 'x=0:1:x' of a claim has no density"},
          {"says = \"an eighth\"", "over = { x = \"1:0\" }",
           "19: over 'x=1:0' is empty: its first end must be below its second"},
          {"says = \"an eighth\"", "over = \"0:1\"", "19: 'over' must be a table"},
          {"claim = { max_abs_error = \"0.125\", says = \"an eighth\" }", "claim = [ \"0.125\" ]",
           "19: 'claim' must be a table"},
          {"max_abs_error = \"0.125\"", "max_error = \"0.125\"",
           "19: unknown key 'max_error': did you mean 'rms_error'?"},
          {"\"0.125\"", "\"\"", "19: max_abs_error '' is not a number"},
          {"\"0.125\"", "\"-0.125\"", "19: max_abs_error '-0.125' is negative: an error is at least 0"},
          {"\"0.125\"", "0.125", "19: 'max_abs_error' must be a text in quotes, so that every digit is kept"},
          {"\"-0.125\"", "\"-O.125\"", "17: a '-O.125' is not a number"},
          {"\"-0.125\"", "\"\"", "17: a '' is not a number"},
          {"source = \"Chebyshev 1854, on mechanisms\"\n", "", "15: the key 'source' is missing"},
          {"\"Chebyshev 1854, on mechanisms\"", "\"\"", "18: the source is empty: name author, year, title"},
          {"\"1.1\"", "\"l.1\"", "20: b 'l.1' is not a number"},
          {"b = \"1.1\"", "slope = \"1.1\"",
           "20: unknown key 'slope': it must be one of seen, replaced, a, b"},
          {"b = \"1.1\", ", "", "20: a variant needs the value that differs"},
          {"x = \"0:1\"\n", "", "3: [over] needs a variable and its range, for example x = \"0:1\""}})
    EXPECT_EQ(refusal_of(replaced(line_study, before, after)), "study 's.toml', line " + line);
  EXPECT_EQ(refusal_of(line_study), "");
  EXPECT_EQ(refusal_of(replaced(line_study, "values = {", "values = [")).substr(0, 50),
            "study 's.toml', line 17: Error while parsing value");
  EXPECT_EQ(refusal_of("schema = 1\nid = \"a\"\n"), "study 's.toml', line 1: a study needs [over]");
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
