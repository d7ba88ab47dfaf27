#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::json_of;
using testing::snapshot;
using testing::TemporaryDirectory;
using testing::with;

const std::vector<std::string> metal{"fresnel-rational", "--target", "exact", "--ior", "0.476",
                                     "--extinction",     "1.52"};

TEST(Pole, AFitThatEndsAtTheBorderSaysSo) {
  const std::vector<std::string> fit = with(with({"fit"}, metal), {"--norm", "minimax"});
  const Outcome text = run_command_line(fit);
  EXPECT_EQ(text.exit_code, 1);
  expect_has(
      text.err,
      "the fit of k = 1.52, n = 0.476 is at-border: the way down leads to a pole of the form, at c = 0.92");
  const Outcome machine = run_command_line(with(fit, {"--json"}));
  const nlohmann::json told = nlohmann::json::parse(machine.out);
  EXPECT_EQ(machine.exit_code, 1);
  EXPECT_EQ(told["status"], "at-border");
  EXPECT_TRUE(told["parameters"].is_null());
  expect_has(told["why"].get<std::string>(), "a pole of the form");
}

TEST(Pole, ConstraintsThatOnlyAPoleMeets) {
  const Outcome outcome = run_command_line({"fit", "fresnel-rational", "--target", "exact", "--ior", "1.5",
                                            "--norm", "minimax", "--one-sided", "above"});
  EXPECT_EQ(outcome.exit_code, 1);
  expect_has(outcome.err, "at-border: the way down leads to a pole of the form");
}

TEST(Pole, GivenParametersWithOneHaveNoProof) {
  const auto expect_no_bound = [](const std::vector<std::string>& arguments, const std::string& place) {
    const Outcome outcome = run_command_line(arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, "the formulas have no finite bound near c = " + place + "\n");
  };
  expect_no_bound({"certify", "fresnel-rational", "--parameters", "a=-2"}, "0.5");
  expect_no_bound({"certify", "fresnel-rational", "--parameters", "a=-2", "--domain", "0:0.5"}, "0.5");
  // below -1 by less than a double can hold
  expect_no_bound({"certify", "fresnel-rational", "--parameters", "a=-1.00000000000000000000001"}, "1");
  expect_no_bound({"emit", "fresnel-rational", "--lang", "c", "--parameters", "a=-1.5"},
                  "0.6666666666666666");
  EXPECT_EQ(run_command_line({"certify", "fresnel-rational", "--parameters", "a=-2", "--domain", "0:0.4"})
                .exit_code,
            0);
  EXPECT_EQ(run_command_line({"certify", "fresnel-rational", "--parameters", "a=-0.99"}).exit_code, 0);
}

TEST(Pole, NothingIsEmittedOfAFitThatHasNoAnswer) {
  const Outcome outcome =
      run_command_line(with(with({"emit"}, metal), {"--norm", "minimax", "--lang", "glsl"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  expect_has(outcome.err, "is at-border: the way down leads to a pole");
}

// exp2(2000 c) is beyond any double: an upper bound of infinity proves nothing.
TEST(Bound, AnInfiniteOneIsNoProof) {
  const TemporaryDirectory directory;
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"certify", "fresnel-one-term", "--parameters", "A=-2000"},
           {"certify", "fresnel-one-term", "--parameters", "A=-2000", "--out", directory / "proof.json"},
           {"certify", "fresnel-one-term", "--parameters", "A=-2000", "--json"},
           {"emit", "fresnel-one-term", "--parameters", "A=-2000", "--lang", "c"}}) {
    const Outcome outcome = run_command_line(arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(
        outcome.err,
        "shadefit: no double was proven to bound the largest error: the formulas have no finite bound near "
        "c = 1\n");
  }
  EXPECT_TRUE(snapshot(directory.path()).empty());
}

// Half of all numbers have a pole: the search rules them out at once, and rounds to none of them.
TEST(Pole, NoConstantsAreRoundedToOne) {
  const nlohmann::json rounded = json_of(
      {"fit", "fresnel-rational", "--target", "exact", "--ior", "0.97", "--round", "decimal:1"})["rounded"];
  EXPECT_EQ(rounded["proven"], true);
  EXPECT_GT(rounded["parameters"]["a"], -1);
}

// The best float is next to -1, and rounding near its pole has no finite bound.
// The best float of a is next to -1, where the denominator is 0 at c = 1.
TEST(Bound, OfRoundedConstantsNextToAPole) {
  const Outcome outcome =
      run_command_line({"fit", "fresnel-rational", "--target", "exact", "--ior", "0.97", "--round", "float"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_has(outcome.out, "-0x1.fffffep-1");
  expect_has(outcome.out, "Max error: a proven bound");
}

TEST(ExactFit, IsPrintedWithoutAnAlternation) {
  const Outcome outcome = run_command_line({"fit", "fresnel-one-term", "--target", "exact", "--ior", "0.853",
                                            "--domain", "0:0.298", "--norm", "minimax"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_has(outcome.out, "\nLevel 0: the form is its target.\n");
}

}  // namespace
}  // namespace shadefit
