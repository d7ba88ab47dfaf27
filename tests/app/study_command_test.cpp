#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::json_of;
using testing::TemporaryDirectory;
using testing::with;

const std::vector<std::string> acos_linear{"fit",    "--target", "acos(x)", "--form", "sqrt(1-x) (a + b x)",
                                           "--over", "x=0:1"};

// The nearest line to x has b = 1; with b <= 1/2 it goes through the mean, 1/2.
TEST(StudyCommand, KeepsParametersWithinBounds) {
  const std::vector<std::string> line{"fit", "--target", "x", "--form", "a + b x", "--over", "x=0:1"};
  const auto half = with(line, {"--bounds", "b=0:0.5", "--bounds", "a=0:"});
  const std::string text = run_command_line(half).out;
  expect_has(text, "a + b x ~ x, x in 0:1, least squares, b in 0:0.5, a >= 0\n");
  expect_has(text, "b is at its bound 0.5\n");
  const auto json = json_of(half);
  EXPECT_NEAR(json["parameters"]["a"].get<double>(), 0.25, 1e-15);
  EXPECT_EQ(json["at_bounds"].dump(), R"({"b":0.5})");
  EXPECT_EQ(json_of(with(line, {"--bounds", "b=0:2"}))["at_bounds"].dump(), "{}");
  const auto minimax = json_of(with(half, {"--norm", "minimax"}));
  EXPECT_NEAR(minimax["level"].get<double>(), 0.25, 1e-15);
  const TemporaryDirectory folder;
  const std::string rows = folder.file("rows.csv", "x,value\n0,0\n0.5,0.6\n1,1\n");
  const std::vector<std::string> of_rows{"fit", "--table", rows, "--form", "a + b x", "--over", "x"};
  const std::string uncertain = run_command_line(with(of_rows, {"--bounds", "b=:0.5"})).out;
  expect_has(uncertain, "b is at its bound 0.5\nNo standard errors: a parameter is at its bound.\n");
  // Code of a fit within bounds.
  std::vector<std::string> emit = half;
  emit.front() = "emit";
  expect_has(run_command_line(with(emit, {"--lang", "c"})).out, "0.5");
}

TEST(StudyCommand, RefusesBoundsThatCannotBe) {
  expect_refusal(with(acos_linear, {"--bounds", "z=0:1"}),
                 "--bounds 'z=0:1': the form has no parameter 'z', it must be one of a, b");
  expect_refusal(with(acos_linear, {"--bounds", "a=0:1", "--bounds", "a=1:2"}),
                 "--bounds 'a=1:2' gives a a second time: leave one out");
  expect_refusal(with(acos_linear, {"--bounds", "a=0:1", "--fix", "a=2"}),
                 "--bounds 'a=0:1' does not go with --fix 'a=2', which gives a one value: leave one out");
  expect_refusal(with(acos_linear, {"--bounds", "a=1:0"}),
                 "--bounds 'a=1:0' is empty: it must rise, say --bounds a=0:1");
  expect_refusal(with(acos_linear, {"--bounds", "a=0:1", "--round", "float"}),
                 "--round 'float' does not go with --bounds: rounding would break them");
  expect_refusal(with(acos_linear, {"--bounds", "a=0:1", "--sensitivity"}),
                 "--sensitivity does not go with --bounds: rounded constants do not keep to them");
}

// [bounds] of a file counts for the forms with such a parameter; --bounds replaces it.
TEST(StudyCommand, ReadsBoundsOfAFile) {
  const std::string study =
      "schema = 1\nid = \"line\"\n[over]\nx = \"0:1\"\n[target]\nformula = \"x\"\n[[form]]\nid = \"line\"\n"
      "formula = \"a + b x\"\n[[form]]\nid = \"constant\"\nformula = \"a\"\n[bounds]\n";
  const TemporaryDirectory folder;
  const std::string file = folder.file("line.toml", study + "b = \"0:0.5\"\n");
  EXPECT_EQ(json_of({"fit", file})["at_bounds"].dump(), R"({"b":0.5})");
  EXPECT_EQ(json_of({"fit", file, "constant"})["at_bounds"].dump(), "{}");
  EXPECT_EQ(json_of({"fit", file, "--bounds", "b=:0.25"})["at_bounds"].dump(), R"({"b":0.25})");
  EXPECT_EQ(json_of({"fit", file, "--fix", "b=0.75"})["at_bounds"].dump(), "{}");
  const std::string unknown = folder.file("unknown.toml", study + "z = \"0:1\"\n");
  expect_refusal({"fit", unknown},
                 "study '" + unknown + "', line 14: bounds 'z=0:1': no form has a parameter 'z'");
  const std::string empty = folder.file("empty.toml", study + "b = \"1:0\"\n");
  expect_has(run_command_line({"fit", empty}).err,
             "line 14: bounds 'b=1:0' is empty: it must rise, say bounds b=0:1");
}

TEST(StudyCommand, PrintsEveryFormat) {
  const auto json = json_of(acos_linear);
  EXPECT_NEAR(json["parameters"]["a"].get<double>(), 1.56515463601461, 2e-14);
  EXPECT_NEAR(json["parameters"]["b"].get<double>(), -0.163889932843928, 2e-15);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["global"], true);
  EXPECT_EQ(json["unique"], true);
  const auto many = json_of({"fit", "burley-albedo", "--form", "mixed-cubic", "--norm", "minimax"});
  EXPECT_EQ(many["unique"], false) << "other constants have its level too";
  EXPECT_EQ(json["at"]["x"], 0);
  EXPECT_EQ(json["over"]["x"]["range"], (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(run_command_line(with(acos_linear, {"--csv"})).out.substr(0, 47),
            "a,b,status,digits,rms error,max abs error,at x\n");
  expect_has(run_command_line(with(acos_linear, {"--latex"})).out, "\\begin{tabular}");
  const std::string text = run_command_line(with(acos_linear, {"--norm", "minimax"})).out;
  expect_has(text, "Level 0.003206963815, the error is - at x = 0, + at x = 0.308664");
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

// What a constraint touches, in words and in JSON.
TEST(StudyCommand, NamesWhereAConstraintTouches) {
  const std::vector<std::string> line{"fit",    "--target", "exp(x)",     "--form", "a + b x",
                                      "--over", "x=0:1",    "--exact-at", "0"};
  const std::string text = run_command_line(line).out;
  expect_has(text, "least squares, exact at x = 0\n");
  expect_has(text, "The optimum sits on the constraint form = target at x = 0\n");
  const auto json = json_of(line);
  ASSERT_EQ(json["alternation"].size(), 1u);
  EXPECT_EQ(json["alternation"][0]["x"], 0);
  EXPECT_EQ(json["alternation"][0]["holds"], "form = target");
}

TEST(StudyCommand, ProvesTheErrorOfAFit) {
  const auto json = json_of(with(acos_linear, {"--certify"}));
  const double lower = json["certified_max_error"][0], upper = json["certified_max_error"][1];
  EXPECT_LE(lower, upper);
  EXPECT_NEAR(json["max_abs_error"].get<double>() / lower, 1, 1e-12);
  const std::string text = run_command_line(with(acos_linear, {"--certify"})).out;
  expect_has(text, "The largest absolute error, proven in 168 bits:\n");
}

TEST(StudyCommand, StopsAtTheTimeLimit) {
  const Outcome stopped = run_command_line(with(acos_linear, {"--time-limit", "1e-9"}));
  EXPECT_EQ(stopped.exit_code, 1);
  EXPECT_EQ(stopped.out, "");
  EXPECT_EQ(stopped.err, "shadefit: the --time-limit of 1e-09 seconds is over, nothing was written\n");
  EXPECT_EQ(run_command_line(with(acos_linear, {"--time-limit", "3600"})).exit_code, 0);
  expect_refusal(with(acos_linear, {"--time-limit", "0"}), "--time-limit '0' must be greater than 0");
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
  expect_has(outcome.err, "shadefit: the fit is ambiguous: another curve is as good, m = ");
}

TEST(StudyCommand, RefusesBadInput) {
  expect_refusal({"fit", "--form", "a x", "--over", "x=0:1"},
                 "--form needs a --target, the formula to approximate, or a --table of measured rows");
  expect_refusal({"fit", "fresnel-quadratic", "--over", "x=0:1"},
                 "study 'fresnel-quadratic': target: formula '(1 - c)^5': expected one of x, pi, ln2 and the "
                 "functions, not 'c' at place 6");
  expect_refusal(with(acos_linear, {"fresnel-quadratic"}),
                 "'fresnel-quadratic' does not go with --form: leave the family out");
  expect_refusal(with(acos_linear, {"--exponent", "5"}),
                 "--exponent k: no formula of the study has this name");
  expect_refusal(with(acos_linear, {"--exact-at", "0.5"}),
                 "--exact-at '0.5' is not an end of the range of x");
  const TemporaryDirectory directory;
  const std::string rows = directory.file("rows.csv", "x,value\n0,1\n1,2\n2,2\n");
  expect_refusal({"fit", "--table", rows, "--form", "a x + b", "--over", "x", "--certify"},
                 "--certify does not go with --table: rows have no error between them");
  expect_refusal(with(acos_linear, {"--given", "k"}), "--given 'k' is not NAME=LIST");
  expect_refusal(with(acos_linear, {"--given", "k=1,,2"}), "--given 'k=1,,2' has an empty value");
  expect_refusal(with(acos_linear, {"--given", "k=1"}), "--given 'k': no formula of the study has this name");
  EXPECT_EQ(run_command_line(with(acos_linear, {"--given", "b=-0.17"})).exit_code, 0) << "a parameter";
  expect_refusal(with(acos_linear, {"--let", "g(t = t"}),
                 "--let 'g(t = t' is not NAME = FORMULA or NAME(A, B) = FORMULA");
  expect_refusal({"fit", "--target", "x", "--form", "a", "--over", "x=0"},
                 "--over 'x=0' is not NAME=A:B or NAME=A:B:DENSITY");
  expect_refusal({"fit", "--target", "x^2", "--form", "a (x + 0 b)", "--over", "x=0:1"},
                 "--form does not depend on its parameter 'b'");
  expect_refusal(with(acos_linear, {"--params", "a,,b"}),
                 "--params 'a,,b' is not a list of names separated by commas");
  expect_refusal(
      with(acos_linear, {"--params", "a"}),
      "--form: formula 'sqrt(1-x) (a + b x)': expected one of x, a, pi, ln2 and the functions, not 'b' "
      "at place 16");
}

// A formula may begin with a sign, and an option is no formula.
TEST(StudyCommand, TakesFormulasThatBeginWithASign) {
  const Outcome outcome = run_command_line({"fit", "--target", "-x^2", "--form", "-a x+b", "--over", "x=0:1",
                                            "--params", "b, a", "--weight", "-x+2"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("-a x+b ~ -x^2, x in 0:1")) << outcome.out;
  for (const char* option : {"--target", "--form", "--weight", "--let"})
    expect_refusal(
        {"fit", option, "--norm", "minimax"},
        std::string(option) + " '--norm' looks like an option: name a value (a path may begin with './')");
}

std::vector<std::string> line_through(const std::string& file) {
  return {"fit", "--table", file, "--form", "a + b x", "--over", "x"};
}

TEST(StudyCommand, FitsMeasuredRows) {
  const TemporaryDirectory folder;
  // The mean slope of 1, 3, 4 is 1.5; the residuals are 1/6, -1/3, 1/6.
  const std::string file = folder.file("line.csv", "x,value\n0,1\n1,3\n2,4\n");
  const auto json = json_of(line_through(file));
  EXPECT_TRUE(json["target"].is_null());
  EXPECT_EQ(json["table"], file);
  EXPECT_EQ(json["rows"], 3);
  EXPECT_EQ(json["over"]["x"]["range"], (std::vector<std::string>{"0", "2"}));
  EXPECT_EQ(json["row"], 2);
  EXPECT_EQ(json["at"]["x"], 1);
  EXPECT_NEAR(json["max_abs_error"].get<double>(), 1.0 / 3, 1e-15);
  EXPECT_NEAR(json["parameters"]["b"].get<double>(), 1.5, 1e-15);
  EXPECT_EQ(json["degrees_of_freedom"], 1);
  EXPECT_TRUE(json["reduced_chi_square"].is_null());
  EXPECT_NEAR(json["residual_deviation"].get<double>(), std::sqrt(1.0 / 6), 1e-15);
  EXPECT_NEAR(json["standard_error"]["b"].get<double>(), std::sqrt(1.0 / 12), 1e-15);
  EXPECT_NEAR(json["covariance"]["a"]["b"].get<double>(), -1.0 / 12, 1e-15);
  EXPECT_NEAR(json["profile"]["b"][0].get<double>(), 1.5 - std::sqrt(1.0 / 12), 1e-9);

  EXPECT_EQ(run_command_line(with(line_through(file), {"--csv"})).out.substr(0, 174),
            "a,b,status,digits,rms error,largest residual,row,s,standard error of a,profile of a from,"
            "profile of a to,standard error of b,profile of b from,profile of b to\n1.1666666666666");
  const std::string page = run_command_line(with(line_through(file), {"--latex"})).out;
  expect_has(page, "\\begin{tabular}{lrr}\n\\toprule\nparameter & $a$ & $b$ \\\\\n");
  for (const char* row : {"\nfitted & ", "\nstandard error & ", "\nprofile from & ", "\nprofile to & "})
    expect_has(page, row);
  const std::string text = run_command_line(line_through(file)).out;
  EXPECT_EQ(text.substr(0, text.find('\n')), "a + b x ~ '" + file + "', 3 rows, over x, least squares");
  expect_has(text,
             "\nThe standard errors follow from the size s of the residuals, with 1 degree of freedom.\n"
             "Within a profile interval the sum of squares grows by at most s^2.\n");
}

// A column sigma weights the rows by 1/sigma, unless there is another weight.
TEST(StudyCommand, WeightsRowsBySigma) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("line.csv", "x,value,sigma\n0,1,1\n1,3,1\n2,4,0.5\n");
  const auto by_default = json_of(line_through(file)),
             same = json_of(with(line_through(file), {"--weight", "1/sigma"})),
             none = json_of(with(line_through(file), {"--weight", "1"}));
  EXPECT_EQ(by_default, same);
  EXPECT_EQ(by_default["weight"], "1/sigma");
  EXPECT_NE(by_default["parameters"], none["parameters"]);
  EXPECT_FALSE(by_default["reduced_chi_square"].is_null());
  EXPECT_TRUE(by_default["residual_deviation"].is_null());
  EXPECT_TRUE(none["reduced_chi_square"].is_null());
  const std::string text = run_command_line(line_through(file)).out;
  expect_has(text, ", least squares, weight 1/sigma\n");
  expect_has(text, "reduced chi-square");
  expect_refusal(
      with(line_through(file), {"--error", "relative"}),
      "--error 'relative' needs a --weight, as the table has sigma: 1/sigma weights errors that are "
      "absolute");
  const auto relative = json_of(with(line_through(file), {"--error", "relative", "--weight", "1/sigma"}));
  EXPECT_TRUE(relative["reduced_chi_square"].is_null());
}

TEST(StudyCommand, SaysWhyRowsGiveNoErrors) {
  const TemporaryDirectory folder;
  const std::string two = folder.file("two.csv", "x,value\n0,1\n1,3\n"),
                    exact = folder.file("exact.csv", "x,value\n0,1\n1,3\n2,5\n"),
                    same = folder.file("same.csv", "x,value\n1,1\n1,3\n1,5\n"),
                    open = folder.file("open.csv", "x,value,sigma\n1,0.5,1\n");
  expect_has(run_command_line(line_through(two)).out,
             "No standard errors: there are as many rows as parameters.\n");
  expect_has(run_command_line(line_through(exact)).out, "No standard errors: the residuals are rounding.\n");
  EXPECT_TRUE(json_of(line_through(exact))["standard_error"].is_null());
  const Outcome outcome = run_command_line(line_through(same));
  EXPECT_EQ(outcome.exit_code, 1);
  expect_lacks(outcome.out, "standard errors");
}

TEST(StudyCommand, PrintsOpenIntervals) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("m.csv", "x,value,sigma\n1,-0.5,1\n2,0.5,1\n3,1.5,1\n");
  const std::vector<std::string> words{"fit", "--table", file, "--form", "exp(a)", "--over", "x"};
  EXPECT_TRUE(json_of(words)["profile"]["a"][0].is_null());
  expect_has(run_command_line(words).out, "  open  ");
}

TEST(StudyCommand, TakesGivenConstantsOfRows) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("line.csv", "x,value\n0,1\n1,3\n2,4\n");
  const std::vector<std::string> words{"fit",    "--table", file,      "--form", "a + b k x",
                                       "--over", "x",       "--given", "k=1,2"};
  const auto json = json_of(words);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_NEAR(json[1]["parameters"]["b"].get<double>(), 0.75, 1e-15);
  expect_has(run_command_line(words).out, "\n2  b  ");
}

// The slope is that of the chord, and the errors are a - 1, a - 1.5 and a - 1.
TEST(StudyCommand, FitsRowsByMinimax) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("line.csv", "x,value\n0,1\n1,3\n2,4\n");
  const std::string text = run_command_line(with(line_through(file), {"--norm", "minimax"})).out;
  expect_has(text, "\nLevel 0.25, the error is + at x = 0, - at x = 1, + at x = 2\n");
  expect_lacks(text, "standard error");
}

TEST(StudyCommand, RefusesBadTables) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("line.csv", "x,value\n0,1\n1,3\n2,4\n"), none = folder / "none.csv";
  expect_refusal(line_through(none), "cannot read '" + none + "': there is no such file");
  expect_refusal(line_through(folder.path().string()),
                 "cannot read '" + folder.path().string() + "': it is a directory");
  const std::string large = folder.file("large.csv", std::string((1 << 20) + 1, ' '));
  expect_refusal(line_through(large), "'" + large + "', line 1: more than 1048576 bytes");
  std::filesystem::resize_file(large, (1 << 30) + 1);  // a hole, which takes no space
  expect_refusal(line_through(large),
                 "cannot read '" + large + "': it has 1073741825 bytes, more than 1073741824");
  expect_refusal({"fit", "--table", file, "--form", "a + b t", "--over", "t"},
                 "'" + file + "' has no column 't'; it has 'x', 'value'");
  expect_refusal(with(line_through(file), {"--target", "x"}),
                 "--table does not go with --target: the rows are the target");
  expect_refusal(with(line_through(file), {"--norm", "minimax", "--exact-at", "0"}),
                 "--exact-at does not go with --table: a row has no range");
  expect_refusal({"fit", "sg-offset", "--table", file},
                 "--table belongs to --form, a formula of your own, or to a study");
}

}  // namespace
}  // namespace shadefit
