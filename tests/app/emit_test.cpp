#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::snapshot;
using testing::TemporaryDirectory;

std::string emitted(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "emit");
  const Outcome outcome = run_command_line(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

TEST(Emit, ThePublishedPair) {
  const std::string code = emitted({"fresnel-quadratic", "--lang", "glsl"});
  expect_has(code, "// shadefit emit fresnel-quadratic --lang glsl\n");
  expect_has(code, "// a = -5.55473, b = -6.98316 (published: Lagarde");
  // 0.0037664127395.. of the 50-digit references, rounded up
  expect_has(code, "// Proven: absolute error at most 0.003767 for c in [0, 1], in exact arithmetic.\n");
  expect_has(code,
             "float fresnel_quadratic(float c) {\n"
             "  return exp2((-5.55473 * c - 6.98316) * c);\n}\n");
}

// The proof is about the constants as they are printed above the code.
TEST(Emit, HalfSaysThatItsRoundingComesOnTop) {
  const std::string words = "// The rounding of constants and operations to half comes on top.\n";
  for (const char* id : {"fresnel-quadratic", "acos-linear"}) {
    expect_has(emitted({id, "--lang", "glsl", "--precision", "half"}), words);
    expect_lacks(emitted({id, "--lang", "glsl"}), words);
  }
}

TEST(Emit, ALobeOfOnePowerOrOfAny) {
  const std::string any = emitted({"sg-offset-mean", "--lang", "hlsl", "--name", "lobe"});
  expect_has(any, "// shadefit emit sg-offset-mean --lang hlsl --name lobe\n");
  expect_has(any, ", k = 3 to 15 (13 values), in exact");
  expect_has(any, "float lobe(float c, float k) {\n  return exp((k + 0.775f) * (c - 1.0f));\n}\n");
  const std::string one =
      emitted({"sg-offset", "--lang", "cpp", "--exponent", "16", "--parameters", "x=0.75"});
  expect_has(one, "// x = 0.75 (given)\n");
  expect_has(one, "inline float sg_offset(float c) {\n  return std::exp2(24.165142f * (c - 1.0f));\n}\n");
}

// A number that was published without its exponents is proven at those of its family: at k = 0 every lobe
// is 1.
TEST(Emit, ANumberWithoutExponents) {
  const std::string code = emitted({"phong-blinn-gotanda", "--lang", "glsl"});
  expect_has(code, ", k = 1 to 2048 (12 values), in exact");
  expect_lacks(code, "at most 0 for");
}

TEST(Emit, FittedConstantsSayHow) {
  const std::string code = emitted(
      {"fresnel-quadratic", "--lang", "wgsl", "--norm", "minimax", "--target", "exact", "--ior", "1.5"});
  expect_has(code, "--target exact --ior 1.5 --norm minimax\n");
}

// For alpha = 1 the albedo of GGX is 1 - c log(1 + 1/c): at c = 1 it is 1 - log 2.
TEST(Emit, ATruthWithoutAProofIsSampled) {
  const std::string code = emitted({"--target", "ggx_albedo(c, 1)", "--form", "a", "--over", "c=0:1",
                                    "--parameters", "a=1", "--lang", "glsl"});
  expect_has(code, "// Sampled: absolute error at most 0.6931 for c in [0, 1], in exact");
}

TEST(Emit, ACheckedFileIsUpToDateOrNot) {
  const TemporaryDirectory directory;
  const std::string file = directory / "pair.glsl";
  const Outcome written = run_command_line({"emit", "fresnel-quadratic", "--lang", "glsl", "--out", file});
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out, "Code: " + file + "\n");
  EXPECT_EQ(read_file(file), emitted({"fresnel-quadratic", "--lang", "glsl"}));
  const Outcome fresh = run_command_line({"emit", "--check", file});
  EXPECT_EQ(fresh.exit_code, 0) << fresh.err;
  EXPECT_EQ(fresh.out, file + " is what would be generated now\n");

  std::string code = read_file(file);
  code.replace(code.find("-5.55473 *"), 8, "-5.55437");
  directory.file("pair.glsl", code);
  const auto before = snapshot(directory.path());
  const Outcome old = run_command_line({"emit", "--check", file});
  EXPECT_EQ(old.exit_code, 1);
  EXPECT_EQ(old.out, "");
  const auto line =
      1 + std::count(code.begin(), code.begin() + static_cast<long>(code.find("-5.55437")), '\n');
  EXPECT_EQ(old.err, "shadefit: " + file + " is out of date: line " + std::to_string(line) +
                         " is not what shadefit generates now\n");
  EXPECT_EQ(snapshot(directory.path()), before) << "a check writes nothing";
}

TEST(Emit, ANameOfTheLanguageIsRefused) {
  expect_refusal({"emit", "fresnel-quadratic", "--lang", "glsl", "--name", "return"},
                 "--name 'return' cannot be a function's name: it is a word or a function of a language");
  expect_refusal({"emit", "fresnel-quadratic", "--lang", "cpp", "--name", "gl_x"},
                 "--name 'gl_x' cannot be a function's name: names of that form are reserved in a language");
}

TEST(Emit, BadInput) {
  const TemporaryDirectory directory;
  expect_refusal(
      {"emit", "--lang", "c"},
      "emit needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help emit')");
  expect_refusal({"emit", "fresnel-quadratic"},
                 "emit needs --lang: one of glsl, hlsl, c, cpp, wgsl, msl, cuda, opencl");
  expect_refusal({"emit", "fresnel-quadratic", "--lang", "rust"},
                 "--lang 'rust' is unknown: it must be one of glsl, hlsl, c, cpp, wgsl, msl, cuda, opencl");
  expect_refusal({"emit", "fresnel-quadratic", "--lang", "glsl", "--precision", "double"},
                 "--precision 'double' is unknown: it must be one of float, half");
  expect_refusal({"emit", "fresnel-quadratic", "--lang", "c", "--precision", "half"},
                 "--precision 'half' does not apply to --lang 'c': it has no half");
  expect_refusal({"emit", "fresnel-quadratic", "--lang", "glsl", "--name", "2fast"},
                 "--name '2fast' is not the name of a function: letters, digits and '_', no digit first");
  expect_refusal(
      {"emit", "sg-offset", "--lang", "glsl"},
      "'sg-offset' has 21 values of its given constants, and these constants are for one: name it by "
      "--exponent");
  expect_refusal(
      {"emit", "sg-offset", "--lang", "glsl", "--exponent", "3:15:1"},
      "'sg-offset' has 13 values of its given constants, and these constants are for one: name it by "
      "--exponent");
  const std::string no_command = directory.file("a.glsl", "float f(float c) { return c; }\n");
  expect_refusal(
      {"emit", "--check", no_command},
      "--check '" + no_command + "' names no command '// shadefit emit ..' or '// shadefit scene ..'");
  const std::string recursive = directory.file("b.glsl", "// shadefit emit --check b.glsl\n");
  expect_refusal(
      {"emit", "--check", recursive},
      "--check '" + recursive + "' names no command '// shadefit emit ..' or '// shadefit scene ..'");
  expect_refusal({"emit", "fresnel-quadratic", "--check", no_command},
                 "--check '" + no_command + "' takes no other argument: the file names its own command");
}

TEST(Emit, TheBetterSetOfAStudy) {
  const std::string code = emitted({"acos-linear", "--better", "--lang", "glsl"});
  expect_has(code, "// shadefit emit acos-linear --lang glsl --better\n");
  expect_has(code,
             "(fitted: minimax, exact at x = 0, exact at x = 1, form falls; better than Eberly, as cited");
  expect_has(code, "// Proven: absolute error at most 0.004262 for x in [0, 1]");
  const std::string quadratic =
      emitted({"f0-under-coat", "--form", "quadratic", "--better", "--lang", "hlsl"});
  expect_has(quadratic, "// f (b f + d) + a for ");
  expect_refusal({"emit", "acos-linear", "--better", "--norm", "minimax", "--lang", "glsl"},
                 "--better does not go with --norm: it names the constants");
  expect_refusal({"emit", "acos-linear", "--better", "--parameters", "a=1,b=2", "--lang", "glsl"},
                 "--better does not go with --parameters: it names the constants");
  expect_refusal(
      {"emit", "--better", "--target", "x^2", "--form", "a x", "--over", "x=0:1", "--lang", "glsl"},
      "--better needs a published set to start from: the study has none");
  expect_refusal(
      {"emit", "luma-709", "--better", "--lang", "glsl"},
      "--better: no set of 'luma-709' errs less than the published one at no more cost and keeps its "
      "properties: see 'shadefit better luma-709'");
}

TEST(Emit, TakesTheConstraintsOfAFit) {
  const std::pair<std::vector<std::string>, const char*> cases[]{
      {{"--exact-at", "0"}, "(fitted: minimax, exact at x = 0)"},
      {{"--one-sided", "above"}, "(fitted: minimax, form >= target)"},
      {{"--at-most", "1.6"}, "(fitted: minimax, form <= 1.6)"},
      {{"--at-least", "0"}, "(fitted: minimax, form >= 0)"},
      {{"--monotone", "falls"}, "(fitted: minimax, form falls)"},
      {{"--fix", "b=-0.16"}, "b = -0.16 (fitted: minimax"},
      {{"--round", "decimal:4"},
       "a = 1.568, b = -0.1691 (fitted: the smallest largest error of constants in decimal:4)"},
  };
  for (const auto& [options, words] : cases)
    expect_has(emitted(testing::with({"acos-linear", "--lang", "glsl"}, options)), words);
  // Published constants are not the answer to a question about a fit.
  const std::string pair = emitted({"fresnel-quadratic", "--norm", "minimax", "--lang", "c"});
  expect_has(pair, "(fitted: minimax)");
  const std::string rounded = emitted({"fresnel-one-term", "--round", "half", "--lang", "c"});
  expect_has(rounded, "A = 8.24 (fitted: the smallest largest error of constants in half)");
  expect_refusal({"emit", "fresnel-quadratic", "--parameters", "a=1,b=2", "--fix", "a=1", "--lang", "c"},
                 "--fix does not go with --parameters: nothing is fitted");
}

TEST(Emit, ChecksSeveralFilesAndNamesEachThatIsOld) {
  const TemporaryDirectory directory;
  std::vector<std::string> call{"emit", "--check"};
  for (const char* name : {"a.glsl", "b.glsl", "c.glsl"}) {
    const std::string code = emitted({"fresnel-quadratic", "--lang", "glsl"});
    call.push_back(directory.file(name, code + (name[0] == 'b' ? "" : "// changed\n")));
  }
  const Outcome outcome = run_command_line(call);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, call[3] + " is what would be generated now\n");
  EXPECT_EQ(outcome.err, "shadefit: " + call[2] +
                             " is out of date: line 11 is not what shadefit generates now; " + call[4] +
                             " is out of date: line 11 is not what shadefit generates now\n");
}

}  // namespace
}  // namespace shadefit
