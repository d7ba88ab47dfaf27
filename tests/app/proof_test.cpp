#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_refusal;
using testing::json_of;
using testing::TemporaryDirectory;

TEST(Certify, ThePublishedValuesWhereThereAreAny) {
  const nlohmann::json form = json_of({"certify", "fresnel-quadratic"});
  EXPECT_EQ(form["parameters_from"], "published");
  EXPECT_EQ(form["parameters"]["a"], "-5.55473");
  EXPECT_LE(form["certified_max_error"][0], 3.7664127395073188e-3);
  EXPECT_GE(form["certified_max_error"][1], 3.7664127395073188e-3);
  const auto from = [](const std::vector<std::string>& call) { return json_of(call)["parameters_from"]; };
  EXPECT_EQ(from({"certify", "sg-offset", "--exponent", "5"}), "published");
  EXPECT_EQ(from({"certify", "sg-offset", "--exponent", "7"}), "fitted");
  EXPECT_EQ(from({"certify", "sg-offset-mean", "--exponent", "7"}), "published");
  EXPECT_EQ(from({"certify", "fresnel-quadratic", "--parameters", "b=-7,a=-5.5"}), "given");
}

TEST(Certify, WritesACertificateThatHolds) {
  const TemporaryDirectory directory;
  const std::string file = directory / "pair.json";
  const Outcome made = run_command_line({"certify", "fresnel-quadratic", "--width", "1e-12", "--out", file});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_has(made.out, "published");
  const Outcome holds = run_command_line({"verify", file});
  EXPECT_EQ(holds.exit_code, 0) << holds.err;
  expect_has(holds.out, "holds: the largest absolute error of exp2((a c + b) c) is in [0.0037664127395");
  // The statement, with constants as numbers.
  expect_has(holds.out,
             "\n  form     exp2((a c + b) c)\n  with     a = -5.55473\n  with     b = -6.98316\n"
             "  target   (1 - c)^5\n  error    absolute: form - target\n  range    c from 0 to 1\n"
             "  largest  at least 0.0037664127395");
}

/// Exponent, surface and the kind of error are part of the statement.
TEST(Verify, SaysWhatHolds) {
  const TemporaryDirectory directory;
  const std::string file = directory / "some.json";
  const auto said = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--width", "0.1", "--out", file});
    EXPECT_EQ(run_command_line(arguments).exit_code, 0);
    return run_command_line({"verify", file}).out;
  };
  const auto expect_lines = [](const std::string& text, const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
      EXPECT_NE(text.find("\n  " + line + "\n"), std::string::npos) << line << "\n" << text;
  };
  expect_lines(
      said({"certify", "sg-offset", "--exponent", "5", "--parameters", "x=0x1.8p-1", "--error", "relative"}),
      {"form     exp((k + x) (c - 1))", "with     x = 0.75", "target   c^k", "given    k = 5",
       "error    relative: (form - target)/target"});
  expect_lines(said({"certify", "fresnel-one-term", "--target", "exact", "--ior", "0.25", "--extinction",
                     "3.5", "--error", "relative", "--domain", "0.25:0.75"}),
               {"target   weight_of_reflectance(conductor_reflectance(c, n, k), f0)", "given    k = 3.5",
                "given    n = 0.25", "let      f0 = conductor_reflectance_at_normal(n, k)",
                "range    c from 0.25 to 0.75"});
  expect_lines(said({"certify", "fresnel-one-term", "--ior", "1.5"}),
               {"target   (1 - c)^5", "given    n = 1.5", "error    absolute: (1 - f0) (form - target)"});
  expect_lines(said({"certify", "fresnel-one-term", "--error", "relative"}),
               {"let      f0 = 0.04",
                "error    absolute: ((1 - f0)/schlick_reflectance(f0, (1 - c)^5)) (form - target)"});
}

/// From inside glass the error is largest at the critical angle, where the target falls like a square root.
TEST(Certify, ReachesTheLeastWidthAtAKink) {
  const nlohmann::json at = json_of({"certify", "fresnel-quadratic", "--target", "exact", "--ior", "0.6667",
                                     "--width", "1e-15"})["certified_max_error_at"];
  EXPECT_NEAR(at["c"], std::sqrt(1 - 0.6667 * 0.6667), 1e-9);
}

TEST(Verify, RefusesWithTheReason) {
  const TemporaryDirectory directory;
  const std::string file = directory / "pair.json";
  ASSERT_EQ(run_command_line({"certify", "fresnel-quadratic", "--out", file}).exit_code, 0);
  std::string text = read_file(file);
  // A changed field with the old digest: an accident.
  auto fields = nlohmann::ordered_json::parse(text);
  fields["parameters"]["a"] = "-5.55437";
  const Outcome changed = run_command_line({"verify", directory.file("changed.json", fields.dump(1))});
  EXPECT_EQ(changed.exit_code, 1);
  expect_has(changed.err, "is refused: its digest is");
  // A false bound with a new digest: the mathematics refuses it.
  StudyCertificate certificate = read_study_certificate(text, file).certificate;
  certificate.upper = certificate.lower;
  certificate.lower *= 0.5;
  certificate.upper *= 0.75;
  const Outcome wrong =
      run_command_line({"verify", directory.file("false.json", certificate_text(certificate))});
  EXPECT_EQ(wrong.exit_code, 1);
  expect_has(wrong.err, "is refused: the error may exceed");
  const std::string former =
      directory.file("former.json", R"({"file": "shadefit certificate", "schema": 1})");
  expect_refusal({"verify", former},
                 "certificate '" + former +
                     "' is of a family, by an earlier build: families are proven as studies "
                     "now; make it again with 'shadefit certify'");
  const std::string half = text.substr(0, text.size() / 2);
  const std::string cut = directory.file("cut.json", half);
  const std::string cut_line = fmt::format("{}, column {}", std::count(half.begin(), half.end(), '\n') + 1,
                                           half.size() - half.rfind('\n'));
  expect_refusal({"verify", cut}, "certificate '" + cut + "', line " + cut_line + ": the JSON ends early");
  // A file that is too large is not read: this one has no content, only a size.
  const std::string sparse = directory.file("sparse.json", "");
  std::filesystem::resize_file(sparse, std::uintmax_t{1} << 30);
  expect_refusal({"verify", sparse},
                 "cannot read '" + sparse + "': it has 1073741824 bytes, more than 4194304");
  const std::string none = directory / "none.json";
  EXPECT_EQ(run_command_line({"verify", none}).exit_code, 2);
}

TEST(BadInput, Certificates) {
  const auto pair = [](const char* parameters) {
    return std::vector<std::string>{"certify", "fresnel-quadratic", "--parameters", parameters};
  };
  expect_refusal(pair("a=-5,c=2"), "parameter 'c' is unknown: the form has none of that name");
  expect_refusal(pair("a=-5"), "parameter 'b' of the form is missing");
  expect_refusal(pair("a=-5,b=-6,a=1"), "parameter 'a' is given twice");
  expect_refusal(pair("a=nan,b=-6"), "parameter a 'nan' is not a finite number");
  for (const char* text : {"", "a", "a=1,", "=1"})
    expect_refusal(pair(text), "--parameters '" + std::string(text) +
                                   "' is not a list of NAME=VALUE separated by commas");
  const auto width = [](const char* text) {
    return std::vector<std::string>{"certify", "fresnel-quadratic", "--width", text};
  };
  expect_refusal(width("x"), "--width 'x' is not a finite number");
  for (const char* text : {"0", "1", "2"})
    expect_refusal(width(text), "--width '" + std::string(text) +
                                    "' is not a relative width: it must be greater than 0 and less than 1");
  expect_refusal(width("1e-20"),
                 "--width '1e-20' cannot be reached: the bounds are doubles, 1e-15 is the least");
  expect_refusal({"certify", "fresnel-quadratic", "--error", "squared"},
                 "--error 'squared' is unknown: it must be one of absolute, relative");
  expect_refusal({"certify", "sg-offset", "--out", "x.json"},
                 "--out 'x.json' takes one certificate, not 21: give one value of each --given");
  expect_refusal({"certify", "fresnel-quadratic", "--out", "."},
                 "--out '.' names no file for the certificate");
}

}  // namespace
}  // namespace shadefit
