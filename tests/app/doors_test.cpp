#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/commands/command_line.hpp"
#include "tests/app/refusal.hpp"
#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

/// What users type first: other names, other notations, and what the command answers to a slip.
namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_refusal;
using testing::json_of;
using testing::TemporaryDirectory;
using testing::with;

using Words = std::vector<std::string>;

Words fit_of(const std::string& target, const std::string& form, const Words& more) {
  return with({"fit", "--target", target, "--form", form}, more);
}

double first_parameter(const Words& words) {
  return json_of(words)["parameters"].front().get<double>();
}

// What one call says in two ways.
TEST(Doors, OtherNotationsAreTheSame) {
  const auto acos_on = [](const Words& more) { return fit_of("acos(x)", "sqrt(1-x) (a + b x)", more); };
  const Words family{"fit", "fresnel-one-term"};
  const std::array<std::pair<Words, Words>, 13> same{{
      {with(family, {"--domain", "cos(pi/3):1"}), with(family, {"--domain", "0.5:1"})},
      {with(family, {"--domain", "0deg:60deg"}), with(family, {"--domain", "0.5:1"})},
      {with(family, {"--domain", "60deg:1"}), with(family, {"--domain", "0.5:1"})},
      {with(family, {"--domain", "0deg:90deg"}), family},
      {with(family, {"--range", "cos(60deg):1"}), with(family, {"--domain", "0.5:1"})},
      {with(family, {"--range=0.5:1"}), with(family, {"--domain", "0.5:1"})},
      {acos_on({"--over", "x=cos(60deg):1"}), acos_on({"--over", "x=0.5:1"})},
      {acos_on({"--range", "x=0.5:1"}), acos_on({"--over", "x=0.5:1"})},
      {fit_of("sin(t)", "a t", {"--over", "t=0deg:30deg"}), fit_of("sin(t)", "a t", {"--over", "t=0:pi/6"})},
      {fit_of("cos(t + s)", "a t", {"--over", "t=0:1", "--given", "s=30deg"}),
       fit_of("cos(t + s)", "a t", {"--over", "t=0:1", "--given", "s=pi/6"})},
      {fit_of("np.arccos(x)", "np.sqrt(1-x)*(a + b*x**1)", {"--over", "x=0:1"}),
       acos_on({"--over", "x=0:1"})},
      {acos_on({"--over", "x=0:1", "--fix", "b=-0x1.4fp-3"}),
       acos_on({"--over", "x=0:1", "--fix", "b=-0.1635742187500"})},
      {{"fit", "acos-quadratic", "quadratic"}, {"fit", "acos-quadratic", "--form", "quadratic"}},
  }};
  for (const auto& [other, usual] : same)
    EXPECT_DOUBLE_EQ(first_parameter(other), first_parameter(usual)) << other[2] << " " << other.back();
}

TEST(Doors, SlipsAreAnsweredInOneLine) {
  const Words acos{"fit", "--target", "acos(x)", "--form", "a + b x"};
  const auto over = [&](const std::string& range) { return with(acos, {"--over", range}); };
  const auto form = [&](const std::string& text) { return fit_of("acos(x)", text, {"--over", "x=0:1"}); };
  const auto target = [&](const std::string& text) { return fit_of(text, "a x", {"--over", "x=0.5:1"}); };
  const std::array<std::pair<Words, std::string>, 39> all{{
      {over("0:1"), "--over '0:1' names no variable: say --over x=0:1"},
      {over("x,y"), "--over 'x,y' names several variables: say --over x --over y"},
      {over("x=0:1,y=0:2"), "--over 'x=0:1,y=0:2' names several variables: say --over x=0:1 --over y=0:2"},
      {over("x=0:2"), "--target has no finite value at x = 1."},
      {target("log(x - 0.75)"), "--target has no finite value at x = 0.5003"},
      {fit_of("x", "a x", {"--over", "x=0:1", "--weight", "0"}),
       "--weight '0' is 0 in the whole range: no error would count"},
      {form("float y = a*x; return y;"),
       "--form: formula 'float y = a*x; return y;': expected one expression, not statements (a definition, as of "
       "--let, can name a part) at place 9"},
      {form("return a*x"),
       "--form: formula 'return a*x': expected one expression, not statements (a definition, as of --let, can name "
       "a part) at place 1"},
      {form("a*x; b"),
       "--form: formula 'a*x; b': expected one expression, not statements (a definition, as of --let, can name a "
       "part) at place 4"},
      {form("a + ln(x)"),
       "--form: formula 'a + ln(x)': expected log for the natural logarithm, not 'ln' at place 5"},
      {form("a ln x"),
       "--form: formula 'a ln x': expected log for the natural logarithm, not 'ln' at place 3"},
      {target("ln(x)"),
       "--target: formula 'ln(x)': expected log for the natural logarithm, not 'ln' at place 1"},
      {form("a e^(-b x)"), "--form: formula 'a e^(-b x)': expected exp(x) for e^x, not 'e' at place 3"},
      {target("e**x"), "--target: formula 'e**x': expected exp(x) for e^x, not 'e' at place 1"},
      {form("a |x|"), "--form: formula 'a |x|': expected abs(x) for |x|, not '|' at place 3"},
      {target("|x|"), "--target: formula '|x|': expected abs(x) for |x|, not '|' at place 1"},
      {target("np.arcos(x)"),
       "--target: formula 'np.arcos(x)': expected a function after 'np.', not 'arcos' (did you mean 'acos'?) at "
       "place 4"},
      {target("0x1.80p+1 x"),
       "--target: formula '0x1.80p+1 x': expected a hexadecimal double as shadefit prints it, such as 0x1.8p+3 at "
       "place 1"},
      {{"fit", "acos-linear", "linaer"}, "unknown form of the study 'linaer': did you mean 'linear'?"},
      {{"fit", "acos-linear", "--form", "linaer"},
       "unknown form of the study 'linaer': did you mean 'linear'?"},
      {{"fit", "acos-linear", "a x"}, "unknown form of the study 'a x': it must be one of "},
      {{"fit", "acos-linear", "linear", "--form", "linear"},
       "'linear' does not go with --form: both name a form"},
      {{"fit", "fresnel-quadratic", "quadratic"}, "'fresnel-quadratic' has one form: leave 'quadratic' out"},
      {{"fit", "acos-linear", "--value", "y"}, "--value 'y' belongs to --table: it names its column"},
      {{"fit", "fresnel-quadratic", "--value", "y"},
       "--value belongs to --form, a formula of your own, or to a study"},
      {{"emit", "--table", "-", "--form", "a x", "--over", "x", "--lang", "c"},
       "--table '-' does not go with emit: the code names its table, for --check"},
      {{"run", "--only", "acos-linear"}, "--only 'acos-linear' is a study: see 'shadefit run acos-linear'"},
      {{"run", "fresnel-quadratic"},
       "'fresnel-quadratic' is built in, no study: see 'shadefit run --only fresnel-quadratic'"},
      {{"check", "acos-linear"},
       "check needs --baseline for a study: DIR of an earlier 'shadefit run acos-linear --out DIR'"},
      {{"list", "acos-linear", "--verdict", "refuted"},
       "no claim with 'acos-linear' in its id passes --verdict 'refuted'; 'acos-linear' is a study: see 'shadefit "
       "explain acos-linear'"},
      {{"list", "nowhere", "--verdict", "refuted"},
       "no claim with 'nowhere' in its id passes --verdict 'refuted'"},
      {{"lnit"}, "unknown command 'lnit': did you mean 'lint'?"},
      {{"lits"}, "unknown command 'lits': did you mean 'list'?"},
      {{"be"}, "unknown command 'be': 2 begin so: better, bench"},
      {{"better", "agx"},
       "unknown form, constant or study 'agx': 3 begin so: agx-godot, agx-septic, agx-sextic"},
      {{"fit", "acos"},
       "unknown form, constant or study 'acos': 3 begin so: acos-cubic, acos-linear, acos-quadratic"},
      {{"run", "acos"}, "unknown study 'acos': 3 begin so: acos-cubic, acos-linear, acos-quadratic"},
      {{"fit", "acos-l"}, "unknown form, constant or study 'acos-l': did you mean 'acos-linear'?"},
  }};
  for (const auto& [words, line] : all) {
    const Outcome outcome = run_command_line(words);
    EXPECT_EQ(outcome.exit_code, 2) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_TRUE(outcome.err.starts_with("shadefit: " + line)) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

// A power of a parameter e, and a list of parameters, are no slips.
TEST(Doors, AParameterMayHaveTheNameOfMathematics) {
  EXPECT_EQ(run_command_line(fit_of("x", "x e^2", {"--over", "x=0:1"})).exit_code, 0);
  EXPECT_EQ(run_command_line(fit_of("2^x", "e^x", {"--over", "x=0:1", "--params", "e"})).exit_code, 0);
  EXPECT_EQ(run_command_line(fit_of("x", "ln x", {"--over", "x=0:1", "--params", "ln"})).exit_code, 0);
  EXPECT_EQ(run_command_line({"fit", "acos-linear", "--form", "sqrt(1-x) a"}).exit_code, 0) << "a formula";
}

// The value, and the numbers that the function takes.
TEST(Doors, AValueThatIsMissingIsExplained) {
  const auto error_of = [](const std::string& target, const std::string& range) {
    return run_command_line(fit_of(target, "a + b x", {"--over", "x=" + range})).err;
  };
  expect_has(error_of("acos(x)", "0:2"), "at x = 1.");
  expect_has(error_of("acos(x)", "0:2"), ") is nan, and acos takes -1 to 1");
  expect_has(error_of("1 + log(x - 1)", "0:2"), ") is nan, and log takes numbers above 0");
  expect_has(error_of("x < 0.5 ? 1 : sqrt(x - 1)", "0:1"), ") is nan, and sqrt takes 0 and numbers above");
  expect_has(error_of("pow(x - 1, 0.5)", "0:1"), " is nan, and a power takes a base of 0 or more");
  expect_has(error_of("exp(1000 x)", "0:1"), ") is inf");
}

// Numbers that are all given: their errors, and no fit.
TEST(Doors, FixOfAllParametersPrintsTheErrors) {
  const Words given = fit_of("acos(x)", "sqrt(1-x) (a + b x)",
                             {"--over", "x=0:1", "--fix", "a=1.5707963", "--fix", "b=-0.156583"});
  const auto json = json_of(given);
  EXPECT_EQ(json["status"], "given");
  EXPECT_TRUE(json["parameters"].empty());
  const auto better = json_of({"better", "acos-linear", "--form", "linear"});
  EXPECT_EQ(better["contenders"][0]["printed"]["a"], "1.5707963");
  EXPECT_NEAR(json["max_abs_error"].get<double>(), better["contenders"][0]["max_abs_error"].get<double>(),
              1e-12);
  EXPECT_GT(json["rms_error"].get<double>(), 0.002);
  const std::string text = run_command_line(given).out;
  expect_has(text, "Nothing was fitted: a = 1.5707963, b = -0.156583 are given.");
  const TemporaryDirectory directory;
  const std::string rows = directory.file("rows.csv", "x,value\n0,1\n1,2.5\n2,2.5\n");
  const auto of_rows =
      json_of({"fit", "--table", rows, "--form", "a x + b", "--over", "x", "--fix", "a=1", "--fix", "b=1"});
  EXPECT_NEAR(of_rows["rms_error"].get<double>(), std::sqrt(0.5 / 3), 1e-15);
  EXPECT_EQ(of_rows["max_abs_error"], 0.5);
  EXPECT_EQ(of_rows["row"], 2);
  const auto proven = json_of(fit_of("x", "a x", {"--over", "x=0:1", "--fix", "a=1.25", "--certify"}));
  EXPECT_NEAR(proven["certified_max_error"][1].get<double>(), 0.25, 1e-12);
}

// Columns of any name, between blanks, below comments, from a pipe.
TEST(Doors, TablesComeAsOtherToolsWriteThem) {
  const TemporaryDirectory directory;
  const std::string savetxt = directory.file(
      "a.txt", "# of a test\n# x y\n0.000e+00 1.000e+00\n1.000e+00 3.000e+00\n2.000e+00 5.500e+00\n");
  const Words fit{"fit", "--form", "a x + b", "--over", "x", "--value", "y", "--table"};
  const auto of = [&](const std::string& file) { return with(fit, {file}); };
  EXPECT_NEAR(first_parameter(of(savetxt)), 2.25, 1e-14);
  const std::string bad = directory.file("b.txt", "# of a test\n# x y\n0 1\n1 two\n");
  expect_refusal(of(bad), "'" + bad + "', line 4: y 'two' is not a finite number");
  // The place of a row is that in its file.
  const std::string low = directory.file("c.txt", "# of a test\n# x y\n0 1\n1 2\n3 4\n");
  expect_refusal(with(of(low), {"--weight", "x"}),
                 "--weight must be finite and greater than 0; it is not at line 3 of '" + low + "'");
  const auto from_pipe = [&](const std::string& text) {
    return testing::run_process(of("-"), [&] {
      std::array<int, 2> input{};
      if (::pipe(input.data()) != 0 || ::write(input[1], text.data(), text.size()) < 0) ::_exit(127);
      ::dup2(input[0], STDIN_FILENO);
      ::close(input[1]);
    });
  };
  const auto piped = from_pipe("x\ty\n0\t1\n1\t3\n2\t5.5\n");
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  expect_has(piped.out, "a x + b ~ 'standard input', 3 rows, over x");
  EXPECT_EQ(from_pipe("x y\n0\n").err, "shadefit: 'standard input', line 2: has 1 cell, the header has 2\n");
}

// One line says all that failed.
TEST(Doors, ExitOneHasOneLine) {
  const Outcome outcome = run_command_line(fit_of(
      "abs(x - k)", "exp(-4 (x - k - m)^2)", {"--over", "x=-1:1", "--given", "k=0,0", "--time-limit", "60"}));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}

}  // namespace
}  // namespace shadefit
