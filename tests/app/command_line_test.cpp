#include "app/commands/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studies/find_study.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/support/sweep.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/accuracy.hpp"
#include "tests/app/refusal.hpp"
#include "tests/references.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::is_close;
using testing::json_of;
using testing::TemporaryDirectory;

// The user reads the computed digits: 14, through the command and its JSON.
TEST(FitCommand, JsonHasFourteenDigitsOfEveryReference) {
  for (const auto& reference : testing::read_references()) {
    std::vector<std::string> arguments{"fit",      reference.constant, "--measure", reference.measure,
                                       "--domain", reference.domain};
    if (reference.exponent)
      arguments.insert(arguments.end(), {"--exponent", nlohmann::json(*reference.exponent).dump()});
    const auto parsed = json_of(arguments);
    EXPECT_TRUE(is_close(reference.describe(), reference.value,
                         parsed["parameters"][reference.parameter].get<double>(), 1e-14));
    EXPECT_EQ(parsed["status"], "converged");
  }
}

TEST(FitCommand, JsonHasTheFieldsOfItsSchema) {
  const auto parsed = json_of({"fit", "fresnel-quadratic", "--measure", "angle"});
  EXPECT_EQ(parsed["schema"], 1);
  EXPECT_EQ(parsed["target"], "(1 - c)^5");
  EXPECT_EQ(parsed["form"], "exp2((a c + b) c)");
  EXPECT_EQ(parsed["over"]["c"]["range"], nlohmann::json::parse(R"(["0", "1"])"));
  EXPECT_EQ(parsed["over"]["c"]["density"], "1/sqrt((1 - c) (1 + c))");
  EXPECT_EQ(parsed["norm"], "least-squares");
  EXPECT_EQ(parsed["digits"], 14);
  EXPECT_EQ(parsed["published"][0]["values"], nlohmann::json::parse(R"({"a": "-5.55473", "b": "-6.98316"})"));
  EXPECT_EQ(json_of({"fit", "fresnel-quadratic"})["published"][0]["verdict"], "confirmed");
  EXPECT_TRUE(json_of({"fit", "sg-offset", "--exponent", "4"})["published"].empty());
}

// Where the lobe is below 1/255 a relative error has no meaning.
TEST(FitCommand, TheRelativeErrorOfALobeCountsWhereItIsVisible) {
  const auto parsed = json_of({"fit", "sg-offset", "--exponent", "5", "--error", "relative"});
  EXPECT_EQ(parsed["over"]["c"]["range"][0], "exp(-log(255)/k)");
  const Fit fit = find_family("sg-offset")->fit(5, {.error = Error::relative});
  EXPECT_EQ(parsed["parameters"]["x"], fit.parameters[0]);
}

TEST(FitCommand, ASweepIsAnArray) {
  const auto sweep = json_of({"fit", "sg-offset", "--exponent", "3:15:1"});
  ASSERT_EQ(sweep.size(), 13U);
  double mean = 0;
  for (const auto& fit : sweep) mean += fit["parameters"]["x"].get<double>() / 13;
  EXPECT_TRUE(is_close("mean", Decimal50("0.775364258522491148"), mean, 1e-14));
  EXPECT_EQ(sweep[2]["given"]["k"], "5");
  EXPECT_EQ(sweep[2]["published"][0]["values"]["x"], "0.788");
  EXPECT_EQ(json_of({"fit", "sg-offset"}).size(), 21U) << "the record's own sweep";
}

TEST(FitCommand, PublishedConstantsNameTheirOwnFit) {
  EXPECT_EQ(json_of({"fit", "sg-offset-k5"})["given"]["k"], "5");
  EXPECT_EQ(json_of({"fit", "fresnel-quadratic-b"})["form"], "exp2((a c + b) c)");
}

TEST(FitCommand, ExactTarget) {
  const auto exact = json_of({"fit", "fresnel-quadratic", "--target", "exact", "--ior", "1.5"});
  EXPECT_TRUE(
      is_close("a", Decimal50("-0.352485440363659108"), exact["parameters"]["a"].get<double>(), 1e-14));
  EXPECT_TRUE(
      is_close("b", Decimal50("-8.38688185141008383"), exact["parameters"]["b"].get<double>(), 1e-14));
  EXPECT_EQ(exact["given"]["n"], "1.5");
  EXPECT_EQ(exact["target"], "weight_of_reflectance(dielectric_reflectance(c, n), f0)");
  EXPECT_EQ(exact["published"][0]["verdict"], "refuted") << "the published pair was fitted to Schlick";
  const auto glass = json_of({"fit", "fresnel-quadratic", "--ior", "1.5"});
  EXPECT_EQ(glass["weight"], "1 - f0");
  EXPECT_NEAR(glass["parameters"]["a"].get<double>(), -5.5547278126488, 1e-13) << "as without a surface";
  const auto gold =
      json_of({"fit", "fresnel-one-term", "--target", "exact", "--ior", "0.43", "--extinction", "2.455"});
  EXPECT_EQ(gold["target"], "weight_of_reflectance(conductor_reflectance(c, n, k), f0)");
  EXPECT_NEAR(gold["parameters"]["A"].get<double>(), 9.2492, 0.0001);
}

TEST(FitCommand, CsvAndConsole) {
  const Outcome csv = run_command_line({"fit", "fresnel-one-term", "--csv"});
  EXPECT_EQ(csv.exit_code, 0);
  const auto table = parse_csv(csv.out, "stdout");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.columns[0], "A");
  EXPECT_TRUE(is_close("A", Decimal50("8.3496619217284116641387127987659889163987122776482"),
                       std::stod(table.rows[0][0]), 1e-14));

  const Outcome console = run_command_line({"fit", "sg-offset", "--exponent", "5,6"});
  EXPECT_EQ(console.exit_code, 0);
  EXPECT_TRUE(console.out.starts_with("sg-offset: exp((k + x) (c - 1)) ~ c^k, c in 0:1, least squares\n"));
  expect_has(console.out, "0.78754461967478");
  expect_has(console.out, "0.788");
}

TEST(FitCommand, Latex) {
  const Outcome one = run_command_line({"fit", "fresnel-quadratic", "--latex"});
  EXPECT_EQ(one.exit_code, 0);
  expect_has(one.out, "\\begin{tabular}{rrlrrrrll}\n");
  expect_has(one.out, "$-5.5547278");
}

TEST(FitCommand, ExitsWithOneWhereItDidNotConverge) {
  const Outcome outcome = run_command_line({"fit", "sg-offset", "--exponent", "5,1e160"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "shadefit: the fit of k = 1e+160 is degenerate: the curve stays the same while x changes\n");
  // A fit without an answer has no digits.
  const auto refused =
      nlohmann::json::parse(run_command_line({"fit", "sg-offset", "--exponent", "1e160", "--json"}).out);
  EXPECT_TRUE(refused["digits"].is_null());
  EXPECT_EQ(refused["why"], "the curve stays the same while x changes");
  EXPECT_NE(outcome.out.find("0.78754461967478"), std::string::npos) << "the others are still printed";
}

TEST(FitCommand, MinimaxSaysWhatItFound) {
  const Outcome text =
      run_command_line({"fit", "fresnel-quadratic", "--norm", "minimax", "--error", "relative"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  expect_has(text.out, "minimax, weight (1 - f0)/schlick_reflectance(f0, (1 - c)^5)");
  expect_has(text.out,
             "Level 0.02806530078, the error is + at c = 0.11586, - at c = 0.410036, + at c = 0.693332");
  const Outcome bound = run_command_line(
      {"fit", "sg-scaled", "--exponent", "5", "--norm", "minimax", "--at-most", "1", "--fix", "x=0.75"});
  expect_has(bound.out, "The optimum sits on the constraint form <= 1 at c = 1\n");

  const auto parsed = json_of({"fit", "fresnel-quadratic", "--norm", "minimax", "--error", "relative", "--f0",
                               "0.02", "--weight", "1 + 4 c", "--at-most", "1"});
  EXPECT_EQ(parsed["norm"], "minimax");
  EXPECT_EQ(parsed["weight"], "(1 + 4 c) ((1 - f0)/schlick_reflectance(f0, (1 - c)^5))");
  ASSERT_EQ(parsed["alternation"].size(), 3U);
  for (const auto& point : parsed["alternation"]) {
    EXPECT_EQ(point["holds"], "level");
    EXPECT_NEAR(std::abs(point["error"].get<double>()), parsed["level"].get<double>(), 1e-14);
  }
}

TEST(FitCommand, LeastSquaresTakesGivenParametersAndRelativeErrors) {
  const auto parsed = json_of({"fit", "fresnel-quadratic", "--error", "relative", "--fix", "b=-7"});
  const Fit fit = find_family("fresnel-quadratic")
                      ->fit({}, {.error = Error::relative, .constraints = {.held = {{"b", -7}}}});
  EXPECT_EQ(parsed["parameters"].size(), 1U);
  EXPECT_EQ(parsed["parameters"]["a"], fit.parameters[0]);
  EXPECT_TRUE(parsed["level"].is_null());
}

TEST(ListCommand, NamesEveryClaimOnce) {
  const Outcome outcome = run_command_line({"list"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto parsed = json_of({"list"});
  EXPECT_EQ(parsed["schema"], 1);
  std::size_t claims = 0;
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      expect_has(outcome.out, "\n" + std::string(claim.id) + " ");
      EXPECT_EQ(parsed["constants"][claims++]["id"], claim.id);
    }
  }
  for (const Family& family : families()) {
    if (!family.is_comparison) continue;
    expect_has(outcome.out, "\n" + std::string(family.id) + " ");
    EXPECT_EQ(parsed["constants"][claims++]["id"], family.id) << "forms of comparison follow the claims";
  }
  EXPECT_EQ(parsed["constants"].size(), claims + known_study_files(study_folders({})).size());
  EXPECT_EQ(parsed["constants"][0]["printed"], "x = 0.775") << "as printed, not as a number";
  EXPECT_TRUE(std::string(parsed["constants"][0]["source"]).starts_with("Lagarde 2012, Spherical Gaussian"));
}

TEST(ListCommand, TakesAnIdOrAFile) {
  const auto ids = [](const std::string& id) {
    std::vector<std::string> found;
    const auto list = json_of({"list", id});
    for (const auto& row : list["constants"]) found.push_back(row["id"]);
    return found;
  };
  EXPECT_EQ(ids("acos-l"), std::vector<std::string>{"acos-linear"});
  EXPECT_EQ(ids("fresnel-quad"), (std::vector<std::string>{"fresnel-quadratic", "fresnel-quadratic-at-1"}));
  EXPECT_EQ(ids(SHADEFIT_SOURCE_DIR "/studies/acos-linear.toml"), std::vector<std::string>{"acos-linear"});
  EXPECT_EQ(parse_csv(run_command_line({"list", "--csv"}).out, "list").rows.size(),
            json_of({"list"})["constants"].size());
}

TEST(ListCommand, FiltersByVerdict) {
  std::size_t filtered = 0;
  for (const Verdict verdict : all_verdicts) {
    const auto parsed = json_of({"list", "--verdict", std::string(name(verdict))});
    for (const auto& row : parsed["constants"]) EXPECT_EQ(row["verdict"], name(verdict)) << row["id"];
    filtered += parsed["constants"].size();
  }
  const auto comparisons = std::ranges::count_if(families(), &Family::is_comparison);
  const auto all = json_of({"list"})["constants"].size();
  EXPECT_EQ(filtered + static_cast<std::size_t>(comparisons) + known_study_files(study_folders({})).size(),
            all)
      << "forms of comparison and studies are not claims";
}

TEST(ExplainCommand, AConstantStandsForItsClaim) {
  const Outcome of_claim = run_command_line({"explain", "fresnel-quadratic"});
  EXPECT_EQ(of_claim.exit_code, 0) << of_claim.err;
  for (const char* constant : {"fresnel-quadratic-a", "fresnel-quadratic-b"})
    EXPECT_EQ(run_command_line({"explain", constant}).out, of_claim.out) << constant;
}

TEST(ExplainCommand, SaysWhatIsClaimedAndWhatIsComputed) {
  const Outcome outcome = run_command_line({"explain", "sg-offset-mean"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* line : {"sg-offset-mean\n", "\nprinted   x = 0.775\n", "\ncomputed  x = 0.7753642585\n",
                           "\nverdict   confirmed\n", "\nplot      plots/offset.svg\n"}) {
    expect_has(outcome.out, line);
  }
}

TEST(RunCommand, WritesTheReportAndTheTables) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_command_line({"run", "--out", directory / "out", "--no-plots"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.ends_with("\nReport: " + (directory / "out/report.md") + "\n"));
  for (const char* name : {"report.md", "summary.md", "better.csv", "claims.csv", "fits.csv", "fresnel.csv",
                           "normalization.csv", "reflectance.csv", "tables.tex"}) {
    EXPECT_TRUE(read_file(directory / (std::string("out/") + name)) ==
                read_file(SHADEFIT_SOURCE_DIR "/reports/baseline/" + std::string(name)))
        << name
        << " differs from the committed one: renew it with ./run run --no-plots --out reports/baseline";
  }
}

TEST(RunCommand, OnlyWhatIsNamed) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_command_line(
      {"run", "--out", directory / "out", "--only", "norm-lambert", "fresnel-one-term", "--no-plots"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(parse_csv(read_file(directory / "out/normalization.csv"), "n").rows.size(), 1U);
  EXPECT_TRUE(parse_csv(read_file(directory / "out/reflectance.csv"), "r").rows.empty());
  EXPECT_EQ(parse_csv(read_file(directory / "out/fits.csv"), "f").rows.size(), 6U)
      << "two published numbers, three measures";
  EXPECT_EQ(parse_csv(read_file(directory / "out/claims.csv"), "c").rows.size(), 3U)
      << "a family stands for the claims that bear its name";
}

TEST(RunCommand, OnlyOneClaim) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_command_line({"run", "--out", directory / "out", "--only", "gloss-ln2-over-8", "--no-plots"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_has(outcome.out, "Ledger: 1 claim: 1 confirmed");
  EXPECT_TRUE(parse_csv(read_file(directory / "out/fits.csv"), "f").rows.empty());
}

/// The rows of fits.csv when only that is run, and its report.
std::pair<std::size_t, std::string> fits_and_report(const std::string& id) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_command_line({"run", "--out", directory / "out", "--only", id, "--no-plots"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return {parse_csv(read_file(directory / "out/fits.csv"), "f").rows.size(),
          read_file(directory / "out/report.md")};
}

TEST(RunCommand, OnlyTheFitsThatANumberNeeds) {
  const auto [of_k5, k5_report] = fits_and_report("sg-offset-k5");
  EXPECT_EQ(of_k5, 3U) << "k = 5 under three measures";
  expect_has(k5_report, "`sg-offset-k5`");
  EXPECT_EQ(k5_report.find("`sg-offset-mean`"), std::string::npos) << "another number of the family";
  EXPECT_EQ(fits_and_report("sg-offset-mean").first, 42U) << "k = 3 to 15 and the mean, three measures";
  EXPECT_EQ(fits_and_report("sg-offset-limit").first, 6U) << "k = 1e6 and the limit, three measures";
  const auto sweep = static_cast<std::size_t>(parse_sweep(find_family("phong-blinn")->sweep).size());
  EXPECT_EQ(fits_and_report("phong-blinn-gotanda").first, 3 * (sweep + 1)) << "printed without its exponent";
}

TEST(CheckCommand, PassesOnTheCommittedBaselineAndFailsOnAChangedDigit) {
  const std::string committed = SHADEFIT_SOURCE_DIR "/reports/baseline";
  const Outcome good = run_command_line({"check", "--baseline", committed});
  EXPECT_EQ(good.exit_code, 0) << good.out;
  EXPECT_TRUE(good.out.starts_with("check passed: "));

  const TemporaryDirectory directory;
  auto fits = read_file(committed + "/fits.csv");
  fits.replace(fits.find("0.7875446197"), 12, "0.7875446198");
  for (const File& table : read_baseline(committed).files) directory.file(table.name, table.content);
  directory.file("fits.csv", fits);
  const Outcome bad = run_command_line({"check", "--baseline", directory.path().string()});
  EXPECT_EQ(bad.exit_code, 1);
  expect_has(bad.out,
             "fits.csv  sg-offset x 5 cosine  fitted  0.7875446198  0.7875446197  moves the curve by up to");
  EXPECT_TRUE(bad.out.ends_with("check failed: 1 difference from " + directory.path().string() + "\n"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()),
                          std::filesystem::directory_iterator()),
            6)
      << "a check writes nothing";
}

TEST(CommandLine, Version) {
  expect_has(run_command_line({"--version"}).out, "shadefit 0.1.0\nwith Boost 1.");
}

}  // namespace
}  // namespace shadefit
