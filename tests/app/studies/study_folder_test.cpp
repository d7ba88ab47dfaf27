#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "tests/app/refusal.hpp"
#include "tests/app/studies/line_study.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::json_of;
using testing::line_study;
using testing::replaced;

class StudyFolder : public ::testing::Test {
 protected:
  StudyFolder() { write("line.toml", line_study); }

  void write(const std::string& name, const std::string& text) { directory_.file(name, text); }
  std::string path(const std::string& name) const { return directory_ / name; }

  testing::TemporaryDirectory directory_;
};

// Chebyshev: the best line for x^2 on [0, 1] is x - 1/8, with error 1/8.
TEST_F(StudyFolder, EveryVerbTakesAFile) {
  const auto fit = json_of({"fit", path("line.toml")});
  EXPECT_NEAR(fit["parameters"]["a"].get<double>(), -0.125, 1e-15);
  // Three digits of a decide little, and b does not depend on the norm.
  EXPECT_EQ(fit["published"][0]["verdict"], "undecidable");
  EXPECT_EQ(fit["published"][0]["objective"], "minimax");
  EXPECT_EQ(fit["published"][0]["fits_tried"], 4);
  const auto other = json_of({"fit", path("line.toml"), "--form", "slope", "--norm", "least-squares"});
  EXPECT_NEAR(other["parameters"]["a"].get<double>(), 0.75, 1e-15);
  const auto narrower = json_of({"fit", path("line.toml"), "--over", "x=0:2"});
  EXPECT_NEAR(narrower["parameters"]["a"].get<double>(), -0.5, 1e-15);

  const auto better = json_of({"better", path("line.toml")});
  EXPECT_EQ(better["contenders"][0]["kind"], "published");
  EXPECT_EQ(better["contenders"][0]["claims"][0]["verdict"], "confirmed");
  EXPECT_EQ(better["contenders"].size(), 5u);

  const std::string said = run_command_line({"explain", path("line.toml")}).out;
  expect_has(said, "Largest error: stated 0.125, computed 0.125: confirmed\n");

  const Outcome code = run_command_line({"emit", path("line.toml"), "--lang", "glsl"});
  expect_has(code.out, "float line(float x) {\n  return -0.125 + 1.0 * x;\n}\n");
}

TEST_F(StudyFolder, AnErrorOfAFormIsItsDifferenceOrRefused) {
  const auto study_with = [](const std::string& error) {
    return "schema = 1\nid = \"small\"\n[over]\nx = \"0:1\"\n[target]\nformula = \"x^2\"\n[[form]]\nid = "
           "\"line\"\nformula = \"a x\"\nerror = \"" +
           error + "\"\n";
  };
  write("small.toml", study_with("x (a - x)"));
  EXPECT_NEAR(json_of({"fit", path("small.toml")})["parameters"]["a"].get<double>(), 0.75, 1e-15);
  write("small.toml", study_with("x (a + x)"));
  const Outcome refused = run_command_line({"fit", path("small.toml")});
  EXPECT_EQ(refused.exit_code, 2);
  expect_has(refused.err, "small.toml'");
  expect_has(refused.err, "error 'x = ");
  expect_has(refused.err, ", but form - target is ");
}

TEST_F(StudyFolder, IsSearchedForItsStudies) {
  const std::string folder = path(".");
  EXPECT_EQ(json_of({"fit", "line", "--studies", folder})["published"][0]["verdict"], "undecidable");
  EXPECT_EQ(json_of({"certify", "line", "--studies", folder})["parameters_from"], "published");
  EXPECT_EQ(run_command_line({"explain", "line", "--studies", folder}).exit_code, 0);
  expect_has(run_command_line({"list", "--studies", folder}).out, "\nline ");
  const Outcome code = run_command_line({"emit", "line", "--studies", folder, "--lang", "c"});
  expect_has(code.out, "// Proven: absolute error at most 0.125 for x in [0, 1], in exact arithmetic.\n");
  expect_refusal({"fit", "line", "--studies", path("none")},
                 "--studies '" + path("none") + "' is not a folder");
}

TEST_F(StudyFolder, HasTheDigitsThatMatter) {
  const auto fit = json_of({"fit", path("line.toml"), "--round", "decimal:2", "--sensitivity"});
  EXPECT_EQ(fit["rounded"]["decimal"]["b"], "1.0");
  EXPECT_EQ(fit["rounded"]["proven"], true);
  EXPECT_NEAR(fit["rounded"]["max_error"].get<double>(), 0.13, 1e-6);
  EXPECT_EQ(fit["sensitivity"]["parameters"]["a"]["within_1_percent"], "-0.125");
  EXPECT_EQ(fit["sensitivity"]["contracts"].size(), 4u);
  const std::string said =
      run_command_line({"fit", path("line.toml"), "--round", "float", "--sensitivity"}).out;
  expect_has(said,
             "\nBest: proven, among all finite numbers of the format by their error in real numbers.\n");
  expect_has(said, "\nthe same form under");
}

TEST_F(StudyFolder, ItsBaselineIsHeld) {
  const auto run = run_command_line({"run", path("line.toml"), "--no-plots", "--out", path("out")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run_command_line({"check", path("line.toml"), "--baseline", path("out")}).out,
            "check passed: 60 cells agree with " + path("out") + "\n");
  write("line.toml", replaced(line_study, "\"-0.125\"", "\"-0.127\""));
  const Outcome changed = run_command_line({"check", path("line.toml"), "--baseline", path("out")});
  EXPECT_EQ(changed.exit_code, 1);
  expect_has(changed.out, "refuted");
  expect_refusal({"check", path("line.toml"), "--baseline", path("nothing")},
                 "cannot read '" + path("nothing") + "/better.csv': there is no such file");
}

// The rows of a file beside the study; the line through (0, 1), (1, 3), (2, 5).
TEST_F(StudyFolder, TakesMeasuredRows) {
  directory_.file("rows.csv", "x,value\n0,1\n1,3\n2,5.3\n");
  std::string text = replaced(line_study, "formula = \"x^2\"", "table = \"rows.csv\"");
  text = replaced(replaced(text, "x = \"0:1\"", "x = \"\""), "norm = \"minimax\"\n", "");
  text = replaced(replaced(text, "\"-0.125\"", "\"0.95\""), "\"1.0\"", "\"2.15\"");
  write("line.toml", text);
  const auto fit = json_of({"fit", path("line.toml")});
  EXPECT_EQ(fit["rows"], 3);
  EXPECT_NEAR(fit["parameters"]["a"].get<double>(), 0.95, 1e-14);
  EXPECT_NEAR(fit["parameters"]["b"].get<double>(), 2.15, 1e-14);
  EXPECT_EQ(fit["published"][0]["verdict"], "undecidable") << "two digits of each";
  const auto better = json_of({"better", path("line.toml")});
  EXPECT_EQ(better["contenders"].size(), 5u) << "a published set, and two fits of each norm";
  EXPECT_NEAR(better["contenders"][0]["max_abs_error"].get<double>(), 0.1, 1e-14);
  expect_has(run_command_line({"emit", path("line.toml"), "--lang", "c"}).out, "0.95f + 2.15f * x");
  write("line.toml", replaced(text, "[metric]\n", "[metric]\nweight = \"1 + x\"\n"));
  const auto weighted = json_of({"better", path("line.toml")});
  EXPECT_NEAR(weighted["contenders"][0]["max_weighted_error"].get<double>(), 0.2, 1e-14);
  write("line.toml", replaced(text, "[target]\n", "[target]\nformula = \"x\"\n"));
  expect_refusal({"fit", path("line.toml")},
                 "study '" + path("line.toml") + "', line 5: a target is a formula or a table, not both");
}

TEST_F(StudyFolder, ATargetMayBeASignal) {
  const auto codes = [&](const std::string& encoded) {
    write("line.toml", replaced(line_study, "[target]\n", "[target]\n" + encoded));
    return run_command_line({"explain", path("line.toml")}).out;
  };
  EXPECT_NE(codes("").find("as a linear grey "), std::string::npos) << codes("");
  expect_has(codes("encoded = true\n"), " codes of 8 bits, ");
  EXPECT_EQ(codes("encoded = false\n"), codes(""));
  write("line.toml", replaced(line_study, "[target]\n", "[target]\nencoded = \"yes\"\n"));
  expect_refusal({"fit", path("line.toml")},
                 "study '" + path("line.toml") + "', line 6: the key 'encoded' must be true or false");
}

TEST_F(StudyFolder, RecomputesRowsOfATable) {
  const std::string table =
      replaced(replaced(line_study, "x = \"0:1\"", "x = \"\""), "norm = \"minimax\"\n", "");
  const auto with = [&](const std::string& target) {
    write("line.toml", replaced(table, "formula = \"x^2\"", target));
  };
  const std::vector<std::string> check{"check", path("line.toml"), "--baseline", path("out")};
  const std::string recomputed = "table = \"rows.csv\"\nrecompute = \"x^2\"";
  directory_.file("rows.csv", "x,value\n0,0\n0.5,0.25\n1,1\n");
  with(recomputed);
  ASSERT_EQ(run_command_line({"run", path("line.toml"), "--no-plots", "--out", path("out")}).exit_code, 0);
  EXPECT_TRUE(
      run_command_line(check).out.starts_with("3 of 3 rows of rows.csv recomputed: x^2\ncheck passed"))
      << run_command_line(check).out;

  directory_.file("rows.csv", "x,value\n0,0\n0.5,0.26\n1,1\n");
  const Outcome changed = run_command_line(check);
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_EQ(changed.out, "");
  EXPECT_EQ(changed.err,
            "shadefit: line 3 of 'rows.csv' has 0.26, where x^2 is 0.25: 1 of 3 recomputed rows differs\n");
  with("table = \"rows.csv\"");
  expect_lacks(run_command_line(check).out, "recomputed");

  const auto refused = [&](const std::string& target, const std::string& rule) {
    with(target);
    for (const char* verb : {"fit", "explain"}) {
      expect_refusal({verb, path("line.toml")}, "study '" + path("line.toml") + "'" + rule);
    }
  };
  refused(
      "table = \"rows.csv\"\nrecompute = \"x^k\"",
      ", line 7: recompute: formula 'x^k': expected one of x, pi, ln2 and the functions, not 'k' at place 3");
  refused(
      "table = \"rows.csv\"\nrecompute = \"value\"",
      ", line 7: recompute: formula 'value': expected one of x, pi, ln2 and the functions, not 'value' at place 1");
  refused("table = \"rows.csv\"\nrecompute = 2",
          ", line 7: 'recompute' must be a text in quotes, so that every digit is kept");
  write("line.toml", replaced(line_study, "formula = \"x^2\"", "formula = \"x^2\"\nrecompute = \"x^2\""));
  expect_refusal({"fit", path("line.toml")},
                 "study '" + path("line.toml") +
                     "', line 5: 'recompute' goes with a table: it is the formula of its values");
}

// A study of others may name no file elsewhere, and a file that is no table says nothing about its content.
TEST_F(StudyFolder, ATableLiesInItsFolder) {
  namespace fs = std::filesystem;
  fs::create_directories(path("studies/sub"));
  const std::string secret = directory_.file("secret", "root:*:19000\n"), study = path("studies/line.toml");
  write("studies/sub/rows.csv", "x,value\n0,1\n1,3\n2,5.3\n");
  fs::create_symlink(secret, path("studies/link"));
  fs::create_symlink("circle", path("studies/circle"));
  fs::create_symlink("sub", path("studies/inner"));
  fs::create_symlink(path("studies"), path("elsewhere"));
  const auto with_table = [&](const std::string& table) {
    const std::string text = replaced(line_study, "formula = \"x^2\"", "table = \"" + table + "\"");
    write("studies/line.toml",
          replaced(replaced(text, "x = \"0:1\"", "x = \"\""), "max_abs_error", "rms_error"));
  };
  for (const std::string& table :
       {secret, std::string("../secret"), std::string("link"), std::string("sub/../../secret"),
        std::string("/etc/shadow"), std::string("circle")}) {
    with_table(table);
    expect_refusal({"explain", study}, "study '" + study + "', line 6: table '" + table +
                                           "' leads out of the folder of the study: a table lies in it");
  }
  for (const char* table : {"sub/rows.csv", "inner/rows.csv", "./sub/../sub/rows.csv"}) {
    with_table(table);
    for (const char* folder : {"studies", "elsewhere"})
      EXPECT_EQ(json_of({"fit", path(std::string(folder) + "/line.toml")})["table"], table);
  }
  expect_refusal({"fit", "--table", secret, "--over", "x", "--form", "a x"},
                 "'" + secret + "' has no column 'x'; it has column 1");
}

// Two lists of 100000 values, ten thousand definitions: one line, at once.
TEST_F(StudyFolder, LimitsItsSize) {
  const std::string many = "the given constants have 1e+10 combinations of values: at most 10000";
  write("many.toml",
        replaced(line_study, "[target]", "[given]\nk = \"1:100000:1\"\nm = \"1:100000:1\"\n[target]"));
  expect_refusal({"explain", path("many.toml")}, "study '" + path("many.toml") + "': " + many);
  expect_refusal({"fit", path("line.toml"), "--given", "k=1:100000:1", "--given", "m=1:100000:1"}, many);
  const auto definitions = [](int count) {
    std::string text = "[let]\n";
    for (int i = 0; i < count; ++i)
      text += "f" + std::to_string(i) + " = \"" + (i == 0 ? "1" : "f" + std::to_string(i - 1)) + "\"\n";
    return text + "[target]";
  };
  write("line.toml", replaced(line_study, "[target]", definitions(1000)));
  EXPECT_EQ(run_command_line({"list", path("line.toml")}).exit_code, 0);
  write("line.toml", replaced(line_study, "[target]", definitions(1001)));
  expect_refusal({"list", path("line.toml")},
                 "study '" + path("line.toml") + "', line 5: let has 1001 definitions: at most 1000");
  write("line.toml", replaced(
                         line_study, "[target]", "[let]\nf = { of = [\"" + [] {
                           std::string names = "t0";
                           for (int i = 1; i < 17; ++i) names += "\", \"t" + std::to_string(i);
                           return names;
                         }() + "\"], is = \"t0\" }\n[target]"));
  expect_refusal({"list", path("line.toml")},
                 "study '" + path("line.toml") + "', line 6: let 'f' has 17 arguments: at most 16");
  write("line.toml", replaced(line_study, "\"0:1\"", "\"-1e308:1e308\""));
  expect_refusal(
      {"fit", path("line.toml")},
      "study '" + path("line.toml") + "', line 4: over 'x=-1e308:1e308' is wider than the largest number");
}

// A study that is refused does not end what goes over all of them.
TEST_F(StudyFolder, ABadStudyIsALine) {
  write("bad.toml", "schema = 2\n");
  const std::string line =
      "shadefit: study '" + path("bad.toml") + "', line 1: the key 'schema' must be 1; it is left out\n";
  const std::string source = directory_.file("a.glsl", "float a = 1.0;\n");
  const Outcome list = run_command_line({"list", "--studies", path(".")});
  EXPECT_EQ(list.exit_code, 0);
  expect_has(list.out, "\nline ");
  EXPECT_EQ(list.err, replaced(line, path("bad.toml"), path("./bad.toml")));
  for (const char* format : {"text", "json"}) {
    const Outcome lint = run_command_line({"lint", source, "--studies", path("."), "--format", format});
    EXPECT_EQ(lint.exit_code, 0) << lint.out;
    EXPECT_EQ(lint.err, replaced(line, path("bad.toml"), path("./bad.toml")));
  }
  expect_refusal({"explain", "bad", "--studies", path(".")},
                 "study '" + path("./bad.toml") + "', line 1: the key 'schema' must be 1");
}

TEST_F(StudyFolder, RefusesBadInput) {
  expect_refusal(
      {"emit", "hg-schlick", "--lang", "glsl"},
      "'hg-schlick' has 3 values of its given constants, and these constants are for one: name it by "
      "--given");
  const auto refused = [&](const std::string& before, const std::string& after, const std::string& line) {
    write("line.toml", replaced(line_study, before, after));
    for (const char* verb : {"fit", "better", "explain", "certify"})
      expect_refusal({verb, path("line.toml")}, "study '" + path("line.toml") + "'" + line);
  };
  refused("id = \"slope\"", "id = \"a'b\"",
          ", line 10: form id 'a'b' must be letters, digits, '-' and '_', no '-' first");
  refused("a = \"-0.125\"", "c = \"-0.125\"", ": published values of 'line' lack the parameter 'a'");
  refused("b = \"1.0\"", "b = \"1.0\", c = \"1\"",
          ": published value 'c' is not a parameter of the form 'line'");
  refused(
      "\"x^2\"", "\"sqr(x)\"",
      ", line 6: target: formula 'sqr(x)': expected one of x, pi, ln2 and the functions, not 'sqr' (did you mean "
      "'sqrt'?) at place 1");
  refused("\"a x\"", "\"a sine(x)\"",
          ", line 12: form: formula 'a sine(x)': expected a function before '(', not 'sine' (did you mean "
          "'sin'?) at place 3");
  refused("\"0:1\"", "\"1:0\"", ", line 4: over 'x=1:0' is empty: its first end must be below its second");
  refused(
      "\"0:1\"", "{ range = \"0:1\", density = \"1/y\" }",
      ", line 4: over 'x=0:1': formula '1/y': expected one of x, pi, ln2 and the functions, not 'y' at place 3");
  refused("[target]", "[given]\nk = \"1/0.\"\nx = \"2\"\n[target]",
          ", line 7: given 'x' is a variable already");
  refused("[target]", "[let]\nf = \"g + 1\"\ng = { of = [\"t\"], is = \"t f\" }\n[target]",
          ", line 6: let 'f' is defined by itself: f, g, f");
  refused("norm = \"minimax\"", "norm = \"minimax\"\nweight = \"w\"",
          ", line 15: weight: formula 'w': expected one of x, pi, ln2 and the functions, not 'w' at place 1");
  // What options leave of a file: the fault is that of the part that no option gave.
  write("line.toml", line_study);
  expect_refusal(
      {"fit", path("line.toml"), "--over", "t=0:1"},
      "study '" + path("line.toml") +
          "', line 6: target: formula 'x^2': expected one of t, pi, ln2 and the functions, not 'x' at "
          "place 1");
  expect_refusal({"fit", path("line.toml"), "--target", "y"},
                 "--target: formula 'y': expected one of x, pi, ln2 and the functions, not 'y' at place 1");
  expect_refusal({"fit", path("line.toml"), "--params", "a,b,d"},
                 "--params 'd': the form has no such parameter");
}

}  // namespace
}  // namespace shadefit
