#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_refusal;
using testing::json_of;
using testing::TemporaryDirectory;
using testing::with;

const std::vector<std::string> acos_linear{"certify", "--target", "acos(x)", "--form", "sqrt(1-x) (a + b x)",
                                           "--over",  "x=0:1"};

TEST(CertifyStudy, TakesGivenConstants) {
  const auto json = json_of(with(acos_linear, {"--parameters", "b=-0.156583,a=1.5707963"}));
  EXPECT_EQ(json["parameters_from"], "given");
  EXPECT_EQ(json["parameters"].dump(), R"({"a":"1.5707963","b":"-0.156583"})");
  EXPECT_NEAR(json["certified_max_error"][0].get<double>(), 0.0090127371, 1e-10);
  EXPECT_NEAR(json["certified_max_error_at"]["x"].get<double>(), 0.36083, 1e-4);
  EXPECT_EQ(json["over"]["x"]["doubles"], (std::vector<double>{0, 1}));
  EXPECT_EQ(json["reached"], true);
  EXPECT_GT(json["boxes"], 2);
}

TEST(CertifyStudy, TakesFittedConstants) {
  const auto json = json_of(with(acos_linear, {"--norm", "minimax"}));
  EXPECT_EQ(json["parameters_from"], "fitted");
  // The best a lies between two doubles. The nearer one or the other adds at most this to the level.
  constexpr double ulp_of_a = 0x1p-52;
  EXPECT_NEAR(std::strtod(json["parameters"]["a"].get<std::string>().c_str(), nullptr), 1.5675893629794234,
              ulp_of_a);
  EXPECT_LE(json["certified_max_error"][0], 0.003206963815473175 + ulp_of_a);
  EXPECT_GE(json["certified_max_error"][1], 0.003206963815473165);
  const auto held = json_of(with(acos_linear, {"--fix", "b=-0.15"}));
  EXPECT_EQ(held["parameters"]["b"], "-0.15");
  EXPECT_EQ(held["parameters"].begin().key(), "a");
}

TEST(CertifyStudy, PrintsEachGivenConstantAndInexactEnds) {
  const Outcome outcome = run_command_line({"certify", "--target", "sin(k x)", "--form", "a x", "--over",
                                            "x=0:pi/2", "--given", "k=1,2", "--error", "absolute"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, outcome.out.find('\n')),
            "a x ~ sin(k x), x in 0:pi/2, absolute error, proven in 168 bits");
  expect_has(outcome.out, "\n1  0x");
  expect_has(outcome.out, "\n2  ");
  expect_has(outcome.out,
             "\nx ends at 1.5707963267948966 = 0x1.921fb54442d18p+0, the double nearest to "
             "pi/2.\n");
}

// Unless an option asks for a fit, the constants are those that were published for the form.
TEST(CertifyStudy, TakesThePublishedConstantsOfANamedStudy) {
  const auto published = json_of({"certify", "acos-linear"});
  EXPECT_EQ(published["parameters_from"], "published");
  EXPECT_EQ(published["parameters"].dump(), R"({"a":"1.5707963","b":"-0.156583"})");
  EXPECT_NEAR(published["certified_max_error"][1].get<double>(), 0.0090127371, 1e-10);
  for (const auto& more :
       {std::vector<std::string>{"--norm", "minimax"}, {"--fix", "b=-0.17"}, {"--form", "a x + b"}})
    EXPECT_EQ(json_of(with({"certify", "acos-linear"}, more))["parameters_from"], "fitted") << more[0];
  // The error alone asks for no fit.
  EXPECT_EQ(
      json_of({"certify", "acos-linear", "--over", "x=0:0.9", "--error", "relative"})["parameters_from"],
      "published");
  const Outcome each = run_command_line({"certify", "hg-schlick"});
  EXPECT_EQ(each.exit_code, 0) << each.err;
  EXPECT_EQ(each.out.substr(0, each.out.find(' ')), "hg-schlick:");
  expect_has(each.out, "\n0.6  ");
}

TEST(CertifyStudy, WritesACertificateThatHolds) {
  const TemporaryDirectory directory;
  const std::string file = directory / "acos.json";
  const auto made = with(acos_linear, {"--parameters", "a=1.5707963,b=-0.156583", "--weight", "1 + x",
                                       "--error", "absolute", "--params", "b,a", "--out", file});
  const Outcome first = run_command_line(made);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  expect_has(first.out, "\nCertificate: " + file + "\n");
  const Outcome holds = run_command_line({"verify", file});
  EXPECT_EQ(holds.exit_code, 0) << holds.err;
  expect_has(holds.out, "holds: the largest weighted absolute error of sqrt(1-x) (a + b x) is in [0.0125");
  expect_has(holds.out, "\n  error    absolute: (1 + x) (form - target)\n");
  // Its own file is replaced, also with other constants.
  EXPECT_EQ(run_command_line(with(acos_linear, {"--out", file})).exit_code, 0);

  auto fields = nlohmann::ordered_json::parse(read_file(file));
  fields["schema"] = 2;
  const std::string newer = directory.file("newer.json", fields.dump(1));
  expect_refusal({"verify", newer}, "certificate '" + newer + "': version 2: this shadefit reads version 1");
  fields["schema"] = 1;
  fields.erase("boxes");
  const std::string without = directory.file("without.json", fields.dump(1));
  expect_refusal({"verify", without}, "certificate '" + without + "': key 'boxes' not found");
}

TEST(CertifyStudy, SaysWhereThereIsNoBound) {
  const Outcome pole = run_command_line(
      {"certify", "--target", "1/x", "--form", "a", "--over", "x=-1:1", "--parameters", "a=0"});
  EXPECT_EQ(pole.exit_code, 1);
  EXPECT_EQ(pole.out, "");
  EXPECT_EQ(
      pole.err,
      "shadefit: no double was proven to bound the largest error: the formulas have no finite bound near x "
      "= 0\n");
}

// Both formulas are the same function, but intervals cannot see it.
TEST(CertifyStudy, SaysWhichWidthWasNotReached) {
  const Outcome outcome = run_command_line(
      {"certify", "--target", "(x + 1)^3", "--form", "x^3 + 3 x^2 + 3 x + 1", "--over", "x=0:1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err.substr(0, 82),
            "shadefit: the proof: the width 1e-09 was not reached: the largest error is in [0, ");
  expect_has(outcome.out, "x^3 + 3 x^2 + 3 x + 1 ~ (x + 1)^3");
}

TEST(CertifyStudy, RefusesBadInput) {
  const auto given = [](const std::vector<std::string>& more) {
    return with(with(acos_linear, {"--parameters", "a=1,b=2"}), more);
  };
  expect_refusal(
      {"certify"},
      "certify needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help certify')");
  expect_refusal({"certify", "--target", "x", "--form", "a x"},
                 "--form needs --over, a variable and its range: for example --over x=0:1");
  expect_refusal(with(acos_linear, {"--over", "y=0:1", "--over", "z=0:1", "--over", "t=0:1"}),
                 "--over 't': a study has at most three variables");
  for (const auto& [option, value] :
       {std::pair("--norm", "minimax"), {"--start", "a=1"}, {"--fix", "a=1"}, {"--monotone", "falls"}})
    expect_refusal(given({option, value}),
                   option + std::string(" does not go with --parameters: nothing is fitted"));
  expect_refusal(
      {"certify", "--target", "x", "--form", "a x", "--over", "x=0:1:angle", "--parameters", "a=1"},
      "--over 'x' with a density does not go with --parameters: nothing is fitted");
  expect_refusal(with(acos_linear, {"--parameters", "a=1,b=0xg"}),
                 "parameter b '0xg' is not a hexadecimal double as shadefit prints it");
  expect_refusal({"certify", "--target", "abs(x)", "--form", "exp(-4 (x - m)^2)", "--over", "x=-1:1"},
                 "the fit is ambiguous: another curve is as good; give --parameters");
  const TemporaryDirectory directory;
  const std::string rows = directory.file("rows.csv", "x,value\n0,1\n1,2\n2,2\n");
  expect_refusal({"certify", "--table", rows, "--form", "a x + b", "--over", "x"},
                 "certify proves the error over a range: '" + rows + "' has rows of measured values alone");
  expect_refusal({"certify", "fresnel-quadratic", "--given", "k=1"},
                 "--given 'k': no formula of the study has this name");
}

}  // namespace
}  // namespace shadefit
