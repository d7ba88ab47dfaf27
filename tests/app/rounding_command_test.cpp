#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "fit/support/hex_float.hpp"
#include "tests/app/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_refusal;
using testing::json_of;
using testing::with;

TEST(FitRound, SaysBothErrorsInJson) {
  const nlohmann::json fit = json_of({"fit", "fresnel-quadratic", "--round", "half"});
  const nlohmann::json& rounded = fit["rounded"];
  EXPECT_EQ(rounded["format"], "half");
  EXPECT_EQ(rounded["parameters"]["a"], -5.4921875);
  EXPECT_EQ(rounded["decimal"]["a"], "-5.492");
  EXPECT_EQ(rounded["hex"]["b"], "-0x1.c08p+2");
  EXPECT_NEAR(rounded["max_error"], 0.0035796, 1e-7);
  EXPECT_NEAR(rounded["at"]["c"], 0.59668, 1e-5);
  EXPECT_NEAR(rounded["naive"]["max_error"], 0.0040267, 1e-7);
  EXPECT_EQ(rounded["published"]["decimal"]["b"], "-6.984");
  EXPECT_GE(rounded["gpu_bound"], rounded["max_error"]);
  EXPECT_EQ(rounded["proven"], true);
  EXPECT_EQ(rounded["searched"], "all finite numbers of the format");
  for (const char* parameter : {"a", "b"})
    EXPECT_EQ(parse_hex(rounded["hex"][parameter].get<std::string>()),
              rounded["parameters"][parameter].get<double>());
}

TEST(FitRound, EveryFormat) {
  for (const char* format : {"half", "bfloat16", "float", "decimal:3"}) {
    const nlohmann::json rounded = json_of({"fit", "fresnel-one-term", "--round", format})["rounded"];
    EXPECT_EQ(rounded["format"], format);
    EXPECT_LT(rounded["max_error"], rounded["naive"]["max_error"]) << format;
    EXPECT_EQ(rounded["gpu_bound"].is_null(), format == std::string("decimal:3"));
    EXPECT_EQ(rounded["real_error"].is_null(), rounded["srgb_codes"].is_number()) << format;
  }
}

TEST(FitRound, ForTheConsole) {
  const Outcome outcome = run_command_line({"fit", "sg-offset", "--exponent", "5,10", "--round", "half"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part :
       {"best", "fitted, rounded", "published, rounded", "0x1.", "on a GPU at most",
        "every operation rounded, at every half of the range", "exp2 within 4 ulp of a float",
        "Best: proven, among all finite numbers of the format."})
    expect_has(outcome.out, part);
}

// A sweep of the record's own exponents goes on where the format cannot hold one.
TEST(FitRound, OfARecordsSweepLeavesOutWhatDoesNotFit) {
  const nlohmann::json fits = json_of({"fit", "phong-blinn", "--round", "bfloat16"});
  EXPECT_FALSE(fits.front()["rounded"].is_null());
  const nlohmann::json sweep = json_of({"fit", "sg-offset", "--round", "half"});
  EXPECT_FALSE(sweep.front()["rounded"].is_null());
  EXPECT_TRUE(sweep.back()["rounded"].is_null());
  EXPECT_EQ(sweep.back()["rounded_reason"], "--round 'half': k = 1e+06 overflows: the largest is 65504");
}

const std::vector<std::string> pair_as_study{"fit",    "--target", "(1-c)^5", "--form", "exp2((a c + b) c)",
                                             "--over", "c=0:1"};

// A formula that is read has the answers of the one that is compiled in.
TEST(FitRound, OfAStudyIsThatOfTheFamily) {
  for (const char* format : {"half", "bfloat16", "float"}) {
    const nlohmann::json study = json_of(with(pair_as_study, {"--round", format}))["rounded"];
    const nlohmann::json family = json_of({"fit", "fresnel-quadratic", "--round", format})["rounded"];
    for (const char* same : {"decimal", "hex", "searched", "proven", "srgb_codes", "gpu_model"})
      EXPECT_EQ(study[same], family[same]) << format << " " << same;
    for (const char* near : {"gpu_bound", "real_error", "rounding_error"}) {
      ASSERT_EQ(study[near].is_null(), family[near].is_null()) << format << " " << near;
      if (family[near].is_null()) continue;
      EXPECT_NEAR(study[near].get<double>() / family[near].get<double>(), 1, 1e-6) << format << " " << near;
    }
    EXPECT_NEAR(study["max_error"].get<double>() / family["max_error"].get<double>(), 1, 1e-8) << format;
  }
}

TEST(FitEvaluate, SaysWhatItFound) {
  const nlohmann::json evaluated = json_of(with(pair_as_study, {"--evaluate", "half"}))["evaluated"];
  EXPECT_EQ(evaluated["format"], "half");
  EXPECT_EQ(evaluated["proven"], false);
  EXPECT_LT(evaluated["max_error"], evaluated["naive"]["max_error"]);
  const std::string text = run_command_line(with(pair_as_study, {"--evaluate", "half"})).out;
  expect_has(text, "Max error: every operation rounded, at every half of the range.");
  expect_has(text, "reach from the fits, not proven.");
  // a published set is a start and a row
  expect_has(run_command_line({"fit", "acos-linear", "--evaluate", "half"}).out, "published, rounded");
}

TEST(FitEvaluate, BadInput) {
  expect_refusal(with(pair_as_study, {"--evaluate", "bfloat16"}),
                 "--evaluate 'bfloat16' is unknown: it must be one of half, float");
  expect_refusal(
      {"fit", "--table", SHADEFIT_SOURCE_DIR "/docs/examples/fog.csv", "--over", "x", "--form",
       "a exp(-b x) + d", "--evaluate", "half"},
      "--evaluate 'half' does not go with --table: rows are measured, and have no largest error to keep");
  expect_refusal(with(pair_as_study, {"--evaluate", "half", "--exact-at", "0", "--norm", "minimax"}),
                 "--evaluate 'half' does not go with a constraint: rounding would break it");
  const Outcome both = run_command_line(with(pair_as_study, {"--evaluate", "half", "--round", "half"}));
  EXPECT_EQ(both.exit_code, 2);
  expect_has(both.err, "excludes");
}

TEST(FitRound, BadInput) {
  const auto with = [](const std::string& format) {
    return std::vector<std::string>{"fit", "fresnel-quadratic", "--round", format};
  };
  const std::string known = "is unknown: it must be one of float, half, bfloat16, decimal:N";
  expect_refusal(with("double"), "--round 'double' " + known);
  expect_refusal(with(""), "--round '' " + known);
  const std::string rule = ": decimal:N takes a whole number N of significant digits from 1 to 17";
  for (const char* text : {"decimal:0", "decimal:18", "decimal:x", "decimal:", "decimal:3.5"})
    expect_refusal(with(text), "--round '" + std::string(text) + "'" + rule);
  expect_refusal({"fit", "sg-offset", "--exponent", "70000", "--round", "half"},
                 "--round 'half': k = 70000 overflows: the largest is 65504");
  const Outcome both = run_command_line({"fit", "fresnel-quadratic", "--round", "half", "--csv"});
  EXPECT_EQ(both.exit_code, 2);
  expect_has(both.err, "excludes");
}

}  // namespace
}  // namespace shadefit
