#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::json_of;
using testing::TemporaryDirectory;

TEST(RunCommand, AFormOfComparisonAlone) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_command_line({"run", "--only", "fresnel-cubic", "--no-plots", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(BetterCommand, AFamilyIsComparedWithAllFormsOfItsTarget) {
  const nlohmann::json schlick = json_of({"better", "fresnel-quadratic"});
  EXPECT_EQ(schlick["target"], "(1 - c)^5");
  EXPECT_TRUE(schlick["left_out"].empty());
  const nlohmann::json first = schlick["contenders"][0];
  EXPECT_EQ(first["kind"], "published");
  EXPECT_EQ(first["printed"]["a"], "-5.55473");
  EXPECT_EQ(first["instructions"], 3);
  EXPECT_EQ(schlick["contenders"][static_cast<std::size_t>(first["best"])]["form"], "fresnel-quadratic");
  EXPECT_EQ(json_of({"better", "fresnel-quadratic", "--target", "exact", "--ior", "2"})["given"]["n"], "2");
  EXPECT_EQ(json_of({"better", "fresnel-quadratic-b"})["contenders"].size(), schlick["contenders"].size());
  // The curve of the pair has its largest error at c = 0.055.
  const nlohmann::json part = json_of({"better", "fresnel-quadratic", "--domain", "0.25:1"})["contenders"][0];
  EXPECT_LT(part["max_abs_error"], first["max_abs_error"]);
  EXPECT_GE(part["at"]["c"], 0.25);
}

TEST(BetterCommand, ALobeAtTheEndsOfItsExponents) {
  const auto exponents = [](const std::vector<std::string>& arguments) {
    nlohmann::json found = json_of(arguments);
    if (found.is_object()) found = nlohmann::json::array({found});
    std::vector<std::string> all;
    for (const nlohmann::json& comparison : found) all.push_back(comparison["given"]["k"]);
    return all;
  };
  using Exponents = std::vector<std::string>;
  EXPECT_EQ(exponents({"better", "sg-offset"}), (Exponents{"1", "1e+06"}));
  EXPECT_EQ(exponents({"better", "sg-offset-mean"}), (Exponents{"3", "15"}));
  EXPECT_EQ(exponents({"better", "sg-offset-k5"}), (Exponents{"5"}));
  EXPECT_EQ(exponents({"better", "phong-blinn", "--exponent", "7.3,9"}), (Exponents{"7.3", "9"}));
}

TEST(BetterCommand, Formats) {
  const Outcome csv = run_command_line({"better", "fresnel-one-term", "--csv"});
  ASSERT_EQ(csv.exit_code, 0) << csv.err;
  const CsvTable table = parse_csv(csv.out, "better");
  EXPECT_EQ(table.columns,
            parse_csv(read_file(SHADEFIT_SOURCE_DIR "/reports/baseline/better.csv"), "b").columns);
  EXPECT_EQ(table.rows.size(), 3U + 2 * 7);
  expect_has(run_command_line({"better", "sg-offset-k5"}).out, "Use this: row ");
  EXPECT_EQ(run_command_line({"better", "sg-offset", "--csv", "--json"}).exit_code, 2);
}

// `emit --better` writes what `better` says to use.
TEST(BetterCommand, IsEmitted) {
  const std::string code = run_command_line({"emit", "fresnel-quadratic", "--better", "--lang", "glsl"}).out;
  expect_has(code, "better than Lagarde 2012");
  const nlohmann::json contenders = json_of({"better", "fresnel-quadratic"})["contenders"];
  const nlohmann::json best = contenders[static_cast<std::size_t>(contenders[0]["best"])];
  for (const auto& [name, value] : best["parameters"].items()) {
    std::string digits = fmt::format("{:.5g}", std::abs(static_cast<double>(value)));
    expect_has(code, digits.substr(0, 5));
  }
}

TEST(BetterCommand, BadInput) {
  expect_refusal({"better", "half-banding"},
                 "'half-banding' is a claim, not fitted: see 'shadefit explain half-banding'");
  expect_refusal({"better", "fresnel-quadratic", "--target", "truth"},
                 "--target 'truth' is unknown: it must be one of schlick, exact; a formula needs a --form");
  EXPECT_EQ(run_command_line({"better", "fresnel-quadratic", "--domain", "1:0"}).exit_code, 2);
  EXPECT_EQ(run_command_line({"better"}).exit_code, 2);
}

// Only a run of a family, or of all, has the section.
TEST(BetterSection, WhereAFamilyIsNamed) {
  const TemporaryDirectory directory;
  const auto targets = [&](const std::string& id) {
    const Outcome outcome = run_command_line({"run", "--out", directory / "out", "--only", id, "--no-plots"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const bool has_section =
        read_file(directory / "out/report.md").find("## Published against best") != std::string::npos;
    std::vector<std::string> found;
    for (const auto& row : parse_csv(read_file(directory / "out/better.csv"), "b").rows) {
      if (std::find(found.begin(), found.end(), row[0]) == found.end()) found.push_back(row[0]);
    }
    EXPECT_EQ(has_section, !found.empty()) << id;
    return found;
  };
  EXPECT_EQ(targets("fresnel-one-term"), (std::vector<std::string>{"", "n = 1.5"}));
  EXPECT_EQ(targets("phong-blinn"), (std::vector<std::string>{"k = 5"}));
  EXPECT_TRUE(targets("norm-lambert").empty());
  EXPECT_TRUE(targets("sg-offset-k5").empty());
}

TEST(SensitivityOption, Console) {
  const Outcome outcome = run_command_line({"fit", "fresnel-quadratic", "--sensitivity"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line :
       {"\nHow far the constants may move until the rms error, 0.002238, is worse by 1 % or 0.1 %:\n",
        "\nAll constants within 1 %: 3 digits, a = -5.55, b = -6.98: worse by 0.1 %\n",
        "\nleast squares, c in 0.1:0.9 "}) {
    expect_has(outcome.out, line);
  }
}

TEST(SensitivityOption, Json) {
  const nlohmann::json fit = json_of({"fit", "fresnel-quadratic", "--norm", "minimax", "--sensitivity"});
  const nlohmann::json& sensitivity = fit["sensitivity"];
  EXPECT_NEAR(sensitivity["objective"].get<double>() / fit["level"].get<double>(), 1, 1e-12);
  const double lower = sensitivity["parameters"]["a"]["profile_1_percent"][0],
               upper = sensitivity["parameters"]["a"]["profile_1_percent"][1], a = fit["parameters"]["a"];
  EXPECT_LT(lower, a);
  EXPECT_GT(upper, a);
  EXPECT_EQ(sensitivity["all_within_1_percent"]["parameters"].size(), 2U);
  EXPECT_EQ(sensitivity["contracts"].size(), 4U);
  EXPECT_TRUE(json_of({"fit", "sg-offset", "--exponent", "5,7", "--sensitivity"})[1].contains("sensitivity"));
  EXPECT_FALSE(json_of({"fit", "fresnel-quadratic"}).contains("sensitivity"));
}

TEST(SensitivityOption, BadInput) {
  for (const char* format : {"--csv", "--latex"})
    EXPECT_EQ(run_command_line({"fit", "fresnel-quadratic", "--sensitivity", format}).exit_code, 2) << format;
  expect_refusal({"fit", "fresnel-quadratic", "--norm", "minimax", "--at-most", "1", "--sensitivity"},
                 "--sensitivity does not go with a constraint: rounded constants do not meet it");
  expect_refusal({"fit", "fresnel-quadratic", "--norm", "minimax", "--exact-at", "0", "--sensitivity"},
                 "--sensitivity does not go with a constraint: rounded constants do not meet it");
}

// One meaning of the best set: in the first sentence, in JSON, in the gallery and in the emitted code.
TEST(BetterStudy, OneBestSetEverywhere) {
  const CsvTable gallery = parse_csv(read_file(SHADEFIT_SOURCE_DIR "/docs/gallery/gallery.csv"), "gallery");
  for (const std::string id : {"acos-linear", "acos-cubic", "f0-under-coat", "atan-quintic"}) {
    const nlohmann::json contenders = json_of({"better", id})["contenders"];
    std::vector<std::string> best_errors;
    for (const auto& row : gallery.rows)
      if (row[0] == id) best_errors.push_back(row[8]);
    std::size_t compared = 0;
    for (const nlohmann::json& contender : contenders) {
      if (contender["kind"] == "fitted") {
        EXPECT_TRUE(contender["best"].is_null());
        continue;
      }
      const std::string best =
          contender["best"].is_null()
              ? ""
              : fmt::format("{:.4g}",
                            contenders[contender["best"].get<std::size_t>()]["max_abs_error"].get<double>());
      EXPECT_NE(std::find(best_errors.begin(), best_errors.end(), best), best_errors.end()) << id << best;
      ++compared;
    }
    EXPECT_EQ(compared, best_errors.size()) << id;
  }
}

TEST(BetterStudy, LeadsWithWhatToUse) {
  const auto first_lines = [](const std::vector<std::string>& call) {
    const std::string out = run_command_line(call).out;
    const std::size_t first = out.find('\n');
    return out.substr(0, out.find('\n', first + 1));
  };
  EXPECT_EQ(
      first_lines({"better", "acos-linear"}),
      "Use this: row 5, 2.11 times as accurate as row 1, same cost, keeps all its properties: "
      "shadefit emit acos-linear --better --lang glsl\n"
      "The smallest error at that cost: row 4, 2.81 times as accurate as row 1, but it loses: exact at x = 0");
  EXPECT_EQ(first_lines({"better", "acos-linear", "--over", "x=0:1/2"}).find("--over x=0:1/2 --better"),
            first_lines({"better", "acos-linear", "--over", "x=0:1/2"}).find("--over"))
      << "the command has the options of the call";
  EXPECT_TRUE(
      first_lines({"better", "luma-709"}).starts_with("Keep row 1: no set here errs less at no more cost\n"));
  const Outcome own = run_command_line({"better", "--target", "x^2", "--form", "a x", "--over", "x=0:1"});
  EXPECT_TRUE(own.out.starts_with("x^2, x in 0:1\n")) << "nothing is published: " << own.out;
}

// On a narrow terminal the operations go first; the form and its cost stay.
TEST(BetterStudy, FormAndCostStayOnANarrowTerminal) {
  for (const char* id : {"acos-linear", "fresnel-quadratic"}) {
    std::vector<std::string> call{"better", id};
    if (id[0] == 'f') call.insert(call.end(), {"--target", "schlick"});
    const Outcome outcome = prepare_command_line(call, keep_going, unwatched, {.width = 80});
    const std::string left_out = outcome.out.substr(outcome.out.find("(left out for the width"));
    expect_has(left_out, "terminal: operations");
    for (const char* column : {"form", "instructions"})
      expect_lacks(left_out.substr(0, left_out.find(')')), column);
    expect_has(outcome.out, "instructions");
  }
}

}  // namespace
}  // namespace shadefit
