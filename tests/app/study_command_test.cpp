#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "tests/app/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_refusal;
using testing::json_of;

const std::vector<std::string> acos_linear{"fit",    "--target", "acos(x)", "--form", "sqrt(1-x) (a + b x)",
                                           "--over", "x=0:1"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(StudyCommand, PrintsEveryFormat) {
  const auto json = json_of(acos_linear);
  EXPECT_NEAR(json["parameters"]["a"].get<double>(), 1.56515463601461, 2e-14);
  EXPECT_NEAR(json["parameters"]["b"].get<double>(), -0.163889932843928, 2e-15);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["global"], true);
  EXPECT_EQ(json["at"]["x"], 0);
  EXPECT_EQ(json["over"]["x"]["range"], (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(run_command_line(with(acos_linear, {"--csv"})).out.substr(0, 47),
            "a,b,status,digits,rms error,max abs error,at x\n");
  EXPECT_NE(run_command_line(with(acos_linear, {"--latex"})).out.find("\\begin{tabular}"), std::string::npos);
  const std::string text = run_command_line(with(acos_linear, {"--norm", "minimax"})).out;
  EXPECT_NE(text.find("Level 0.003206963815, the error is - at x = 0, + at x = 0.308664"), std::string::npos)
      << text;
}

// A list of --given is a fit for each value; --fix and --start name parameters.
TEST(StudyCommand, TakesGivenConstants) {
  const std::vector<std::string> lobe{"fit",    "--target", "c^k",     "--form", "exp((k + x)(c - 1))",
                                      "--over", "c=0:1",    "--given", "k=3:5:1"};
  const auto all = json_of(lobe);
  const auto family = json_of({"fit", "sg-offset", "--exponent", "3:5:1"});
  ASSERT_EQ(all.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = family[i]["parameters"]["x"];
    EXPECT_NEAR(all[i]["parameters"]["x"].get<double>() / expected, 1, 1e-13) << i;
    EXPECT_EQ(all[i]["given"]["k"], std::to_string(3 + i));
  }
  const auto fixed = json_of(with(acos_linear, {"--fix", "a=1.5"}));
  EXPECT_FALSE(fixed["parameters"].contains("a"));
  EXPECT_TRUE(fixed["parameters"].contains("b"));
}

TEST(StudyCommand, AngleIsADensity) {
  // E cos(theta) with theta uniform in [0, pi/2] is 2/pi.
  const auto json = json_of({"fit", "--target", "c", "--form", "a + 0 c", "--over", "c=0:1:angle"});
  EXPECT_NEAR(json["parameters"]["a"].get<double>(), 0.63661977236758138, 1e-15);
}

TEST(StudyCommand, SaysWhatDidNotConverge) {
  const Outcome outcome =
      run_command_line({"fit", "--target", "abs(x)", "--form", "exp(-4 (x - m)^2)", "--over", "x=-1:1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("shadefit: the fit: ambiguous, another curve is as good\nshadefit: m = "),
            std::string::npos)
      << outcome.err;
}

TEST(StudyCommand, RefusesBadInput) {
  expect_refusal({"fit", "--form", "a x", "--over", "x=0:1"},
                 "--form needs a --target: the formula to approximate");
  expect_refusal({"fit", "fresnel-quadratic", "--over", "x=0:1"},
                 "--over belongs to --form, a formula of your own, or to a study");
  expect_refusal({"fit", "fresnel-quadratic", "--target", "acos(x)"},
                 "--target 'acos(x)' is unknown: it must be one of schlick, exact; a formula needs a --form");
  expect_refusal(with(acos_linear, {"fresnel-quadratic"}),
                 "'fresnel-quadratic' does not go with --form: leave the family out");
  expect_refusal(with(acos_linear, {"--exponent", "5"}),
                 "--exponent does not go with --form: name it in the formulas and give it by "
                 "--given");
  expect_refusal(with(acos_linear, {"--domain", "0.2:1"}),
                 "--domain does not go with --form: give the range by --over");
  expect_refusal(with(acos_linear, {"--one-sided", "above"}),
                 "--one-sided 'above' does not apply to least squares: it belongs to --norm minimax");
  expect_refusal(with(acos_linear, {"--given", "k"}), "--given 'k' is not NAME=LIST");
  expect_refusal(with(acos_linear, {"--given", "k=1,,2"}), "--given 'k=1,,2' has an empty value");
  expect_refusal(with(acos_linear, {"--let", "g(t = t"}),
                 "--let 'g(t = t' is not NAME = FORMULA or NAME(A, B) = FORMULA");
  expect_refusal({"fit", "--target", "x", "--form", "a", "--over", "x=0"},
                 "--over 'x=0' is not NAME=A:B or NAME=A:B:DENSITY");
  expect_refusal({"fit", "--target", "x^2", "--form", "a (x + 0 b)", "--over", "x=0:1"},
                 "--form does not depend on its parameter 'b'");
}

}  // namespace
}  // namespace shadefit
