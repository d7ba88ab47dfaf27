#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/studies/find_study.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/study/study.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_refusal;
using testing::json_of;

const std::string good = R"(schema = 1
id = "line"
[over]
x = "0:1"
[target]
formula = "x^2"
[[form]]
id = "line"
formula = "a + b x"
[[form]]
id = "slope"
formula = "a x"
[metric]
norm = "minimax"
[[published]]
form = "line"
values = { a = "-0.125", b = "1.0" }
source = "Chebyshev 1854, on mechanisms"
claim = { max_abs_error = "0.125", says = "an eighth" }
variants = [ { b = "1.1", seen = "a copy" } ]
)";

std::string replaced(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

std::string refusal_of(const std::string& text) {
  try {
    read_study_file(text, "s.toml");
  } catch (const UserError& error) {
    return error.what();
  }
  return "none";
}

TEST(StudyFile, ReadsWhatItSays) {
  const StudyFile file = read_study_file(good, "s.toml");
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
      replaced(good, "claim = { max_abs_error = \"0.125\", says = \"an eighth\" }",
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
    return refusal_of(replaced(good, before, after));
  };
  EXPECT_EQ(refusal_of(good), "none");
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
            "study 's.toml', line 19: over 'x=1:0' is empty: it must rise");
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

// Each study of the project is read, each fit of it converges, and its id is its name.
std::vector<std::string> committed_studies() {
  std::vector<std::string> ids;
  for (const auto& path : study_files({std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies"}))
    ids.push_back(path.stem().string());
  return ids;
}

/// Studies with a fit that does not converge: minimax of a form that is exact, or that has no single optimum,
/// or that the exchange does not find.
bool has_fits_that_fail(const std::string& id) {
  return std::set<std::string>{"air-mass",         "burley-albedo",        "fresnel-average",
                               "imageworks-sheen", "oren-nayar-albedo",    "pq-gran-turismo",
                               "pq-patry",         "schlick-average",      "smith-linear",
                               "srgb-encode",      "van-de-hulst-inverse", "zeltner-albedo"}
      .contains(id);
}

/// Each study of the project is read, judged and emitted, and its id is its name.
class CommittedStudy : public ::testing::TestWithParam<std::string> {};

TEST_P(CommittedStudy, Holds) {
  const StudyFile file =
      load_study(std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies" / (GetParam() + ".toml"));
  EXPECT_EQ(file.id, GetParam());
  EXPECT_FALSE(file.title.empty());
  const Outcome outcome = run_command_line({"better", file.id, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const auto& target : json.is_array() ? json : nlohmann::json::array({json})) {
    int fitted = 0;
    for (const auto& contender : target["contenders"]) {
      const bool is_published = contender["kind"] == "published";
      EXPECT_EQ(is_published, contender["verdict"].is_string());
      fitted += is_published ? 0 : 1;
    }
    EXPECT_GT(fitted, 0);
    EXPECT_TRUE(target["left_out"].empty() || has_fits_that_fail(file.id)) << target["left_out"];
  }
  std::vector<std::string> emit{"emit", file.id, "--lang", ""};
  for (const auto& [constant, values] : file.given)
    emit.insert(emit.end(), {"--given", constant + "=" + values.front()});
  for (const Language language : languages) {
    emit[3] = name(language);
    EXPECT_EQ(run_command_line(emit).exit_code, 0) << emit[3];
    // Each language proves the error anew, and these proofs take seconds.
    if (file.id == "ltc-edge" || file.id == "fresnel-average") break;
  }
}

INSTANTIATE_TEST_SUITE_P(Studies, CommittedStudy, ::testing::ValuesIn(committed_studies()),
                         [](const auto& study) {
                           std::string name = study.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// What --fix holds is not judged; the other constants are.
TEST(StudyFile, JudgesTheConstantsThatAreFree) {
  const Outcome outcome = run_command_line({"fit", "atan-quintic", "--fix", "b=0.0872929"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("a = -0.301895 "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("b = 0.0872929"), std::string::npos) << outcome.out;
  EXPECT_EQ(run_command_line({"fit", "atan-quintic", "--fix", "a=-0.3", "--fix", "b=0.09"}).exit_code, 2);
}

// The reference follows the program of the ACES in 40 digits; the study has 17 digits of the end of a spline.
TEST(StudyFile, TheAcesCurveIsThatOfItsReference) {
  const std::filesystem::path source = SHADEFIT_SOURCE_DIR;
  Study study = load_study(source / "studies/aces-narkowicz.toml").study;
  study.form = "a x";
  const Symbolic target = read_formulas(study).target;
  const auto rows = parse_csv(read_file(source / "tests/references/tone.csv"), "tone.csv").rows;
  ASSERT_EQ(rows.size(), 20u);
  for (const auto& row : rows) {
    const Decimal50 x(row[0]), expected(row[1]);
    const auto computed = evaluate<Decimal50>(target, [&](const std::string&) { return x; });
    EXPECT_LT(abs(computed / expected - 1), Decimal50(1e-14)) << "x = " << row[0] << ": " << computed;
  }
}

/// A folder with the study above.
class StudyFolder : public ::testing::Test {
 protected:
  StudyFolder() { write("line.toml", good); }

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
  EXPECT_NE(said.find("Largest error: stated 0.125, computed 0.125: confirmed\n"), std::string::npos) << said;

  const Outcome code = run_command_line({"emit", path("line.toml"), "--lang", "glsl"});
  EXPECT_NE(code.out.find("float line(float x) {\n  return -0.125 + 1.0 * x;\n}\n"), std::string::npos)
      << code.out << code.err;
}

TEST_F(StudyFolder, IsSearchedForItsStudies) {
  const std::string folder = path(".");
  EXPECT_EQ(json_of({"fit", "line", "--studies", folder})["published"][0]["verdict"], "undecidable");
  EXPECT_EQ(json_of({"certify", "line", "--studies", folder})["parameters_from"], "published");
  EXPECT_EQ(run_command_line({"explain", "line", "--studies", folder}).exit_code, 0);
  EXPECT_NE(run_command_line({"list", "--studies", folder}).out.find("\nline "), std::string::npos);
  const Outcome code = run_command_line({"emit", "line", "--studies", folder, "--lang", "c"});
  EXPECT_NE(code.out.find("// Proven: absolute error at most 0.125 for x in [0, 1], in exact arithmetic.\n"),
            std::string::npos)
      << code.out << code.err;
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
  EXPECT_NE(said.find("\nBest: proven, among all finite numbers of the format.\n"), std::string::npos)
      << said;
  EXPECT_NE(said.find("\nthe same form under"), std::string::npos) << said;
}

TEST_F(StudyFolder, ItsBaselineIsHeld) {
  const auto run = run_command_line({"run", path("line.toml"), "--no-plots", "--out", path("out")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run_command_line({"check", path("line.toml"), "--baseline", path("out")}).out,
            "check passed: 60 cells agree with " + path("out") + "\n");
  write("line.toml", replaced(good, "\"-0.125\"", "\"-0.127\""));
  const Outcome changed = run_command_line({"check", path("line.toml"), "--baseline", path("out")});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_NE(changed.out.find("refuted"), std::string::npos) << changed.out;
  expect_refusal({"check", path("line.toml"), "--baseline", path("nothing")},
                 "cannot read '" + path("nothing") + "/better.csv': there is no such file");
}

// The rows of a file beside the study; the line through (0, 1), (1, 3), (2, 5).
TEST_F(StudyFolder, TakesMeasuredRows) {
  directory_.file("rows.csv", "x,value\n0,1\n1,3\n2,5.3\n");
  std::string text = replaced(good, "formula = \"x^2\"", "table = \"rows.csv\"");
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
  EXPECT_NE(run_command_line({"emit", path("line.toml"), "--lang", "c"}).out.find("0.95f + 2.15f * x"),
            std::string::npos);
  write("line.toml", replaced(text, "[metric]\n", "[metric]\nweight = \"1 + x\"\n"));
  const auto weighted = json_of({"better", path("line.toml")});
  EXPECT_NEAR(weighted["contenders"][0]["max_weighted_error"].get<double>(), 0.2, 1e-14);
  write("line.toml", replaced(text, "[target]\n", "[target]\nformula = \"x\"\n"));
  expect_refusal({"fit", path("line.toml")},
                 "study '" + path("line.toml") + "', line 5: a target is a formula or a table, not both");
}

TEST_F(StudyFolder, ATargetMayBeASignal) {
  const auto codes = [&](const std::string& encoded) {
    write("line.toml", replaced(good, "[target]\n", "[target]\n" + encoded));
    return run_command_line({"explain", path("line.toml")}).out;
  };
  EXPECT_NE(codes("").find("as a linear grey "), std::string::npos) << codes("");
  EXPECT_NE(codes("encoded = true\n").find(" codes of 8 bits, "), std::string::npos);
  EXPECT_EQ(codes("encoded = false\n"), codes(""));
  write("line.toml", replaced(good, "[target]\n", "[target]\nencoded = \"yes\"\n"));
  expect_refusal({"fit", path("line.toml")},
                 "study '" + path("line.toml") + "', line 6: the key 'encoded' must be true or false");
}

TEST_F(StudyFolder, RecomputesRowsOfATable) {
  const std::string table = replaced(replaced(good, "x = \"0:1\"", "x = \"\""), "norm = \"minimax\"\n", "");
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
  EXPECT_EQ(run_command_line(check).out.find("recomputed"), std::string::npos);

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
  write("line.toml", replaced(good, "formula = \"x^2\"", "formula = \"x^2\"\nrecompute = \"x^2\""));
  expect_refusal({"fit", path("line.toml")},
                 "study '" + path("line.toml") +
                     "', line 5: 'recompute' goes with a table: it is the formula of its values");
}

TEST_F(StudyFolder, RefusesBadInput) {
  expect_refusal({"fit", "acos-linaer"},
                 "unknown form, constant or study 'acos-linaer': did you mean 'acos-linear'?");
  expect_refusal({"better", path("line.toml"), "--exponent", "5"},
                 "--exponent does not go with a study: name it in the formulas and give it by --given");
  expect_refusal({"emit", "hg-schlick", "--lang", "glsl"},
                 "'hg-schlick' has 3 values of its given constants: name one by --given");
  const auto refused = [&](const std::string& before, const std::string& after, const std::string& line) {
    write("line.toml", replaced(good, before, after));
    for (const char* verb : {"fit", "better", "explain", "certify"})
      expect_refusal({verb, path("line.toml")}, "study '" + path("line.toml") + "'" + line);
  };
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
  refused("\"0:1\"", "\"1:0\"", ", line 4: over 'x=1:0' is empty: it must rise");
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
  write("line.toml", good);
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
