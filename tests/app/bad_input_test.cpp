#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/command_line.hpp"
#include "reports/files.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::TemporaryDirectory;

/// Bad usage and bad input: exit 2, nothing on standard output, exactly this line on standard error.
void expect_refusal(const std::vector<std::string>& arguments, const std::string& line) {
  const Outcome outcome = run_command_line(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << line;
  EXPECT_EQ(outcome.out, "") << line;
  EXPECT_EQ(outcome.err, "shadefit: " + line + "\n");
}

TEST(BadInput, UnknownIdsSuggestTheNearest) {
  expect_refusal({"fit", "fresnel-quadratc"},
                 "unknown constant to fit 'fresnel-quadratc': did you mean 'fresnel-quadratic'?");
  expect_refusal({"fit", "sg-ofset"}, "unknown constant to fit 'sg-ofset': did you mean 'sg-offset'?");
  expect_refusal({"run", "--only", "norm-fong"}, "unknown constant 'norm-fong': did you mean 'norm-phong'?");
  expect_refusal({"fit", "norm-phong"},
                 "'norm-phong' is integrated, not fitted: see 'shadefit run --only norm-phong'");
  expect_refusal({"plot"}, "unknown command 'plot': it must be one of list, run, fit, check");
  expect_refusal({"fit", "sg\n-offset"},
                 "unknown constant to fit 'sg\\x0a-offset': did you mean 'sg-offset'?");
  expect_refusal({"chekc"}, "unknown command 'chekc': did you mean 'check'?");
}

TEST(BadInput, Exponents) {
  const std::string rule = ": give K or A:B:STEP, by commas";
  expect_refusal({"fit", "sg-offset", "--exponent", "0"}, "--exponent '0' is not greater than 0" + rule);
  expect_refusal({"fit", "sg-offset", "--exponent", "-1"}, "--exponent '-1' is not greater than 0" + rule);
  expect_refusal({"fit", "sg-offset", "--exponent=-2.5"}, "--exponent '-2.5' is not greater than 0" + rule);
  for (const char* text : {"nan", "inf", "-inf", "five", ""}) {
    expect_refusal({"fit", "sg-offset", "--exponent", text},
                   "--exponent '" + std::string(text) + "' is not a finite number" + rule);
  }
  expect_refusal({"fit", "sg-offset", "--exponent", "1e400"},
                 "--exponent '1e400' is beyond the range of a double" + rule);
  expect_refusal({"fit", "sg-offset", "--exponent", "1:2"},
                 "--exponent '1:2' is not a range A:B:STEP" + rule);
  expect_refusal({"fit", "fresnel-quadratic", "--exponent", "5"},
                 "--exponent '5' does not apply: fresnel-quadratic has no exponent");
  expect_refusal({"fit", "sg-offset-mean", "--exponent", "5"},
                 "--exponent '5' does not apply: sg-offset-mean names its own exponents");
  expect_refusal({"fit", "sg-offset", "--measure", "sine"},
                 "--measure 'sine' is unknown: it must be one of cosine, angle, cosine-weighted");
}

TEST(BadInput, Domains) {
  for (const char* text : {"", "0.5", "0:x", "nan:1", "0:inf", ":1"}) {
    expect_refusal({"fit", "sg-offset", "--domain", text},
                   "--domain '" + std::string(text) + "' is not a pair A:B of finite numbers");
  }
  for (const char* text : {"0.5:0.5", "0.75:0.25"}) {
    expect_refusal({"fit", "sg-offset", "--domain", text},
                   "--domain '" + std::string(text) + "' is empty or reversed: A must be less than B");
  }
  expect_refusal({"fit", "sg-offset", "--domain", "0:2"},
                 "--domain '0:2' leaves [0, 1]: A and B are cosines");
  expect_refusal({"fit", "sg-offset", "--domain=-1:1"}, "--domain '-1:1' leaves [0, 1]: A and B are cosines");
}

TEST(BadInput, Targets) {
  expect_refusal({"fit", "fresnel-quadratic", "--target", "snell"},
                 "--target 'snell' is unknown: it must be one of schlick, exact");
  expect_refusal({"fit", "fresnel-quadratic", "--ior", "1.5"},
                 "--ior '1.5' does not apply: it belongs to --target exact");
  expect_refusal({"fit", "sg-offset", "--target", "exact"},
                 "--target 'exact' does not apply: sg-offset is no Fresnel form");
  for (const char* ior : {"0", "-1.5", "1"}) {
    expect_refusal(
        {"fit", "fresnel-quadratic", "--target", "exact", "--ior", ior},
        "--ior '" + std::string(ior) + "' is no index of an interface: it must be greater than 0, and not 1");
  }
  expect_refusal({"fit", "fresnel-quadratic", "--target", "exact", "--ior", "nan"},
                 "--ior 'nan' is not a finite number");
}

TEST(BadInput, OutputPaths) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("file", "kept");
  const std::string rule = ": it must be a directory, or free to become one";
  expect_refusal({"run", "--out", file}, "output directory '" + file + "' is no directory" + rule);
  expect_refusal({"run", "--out", file + "/below"}, "output directory '" + file + "/below' lies below '" +
                                                        file + "', which is no directory" + rule);
  expect_refusal({"run", "--out", "--no-plots"},
                 "--out '--no-plots' looks like an option: name a value (a path may begin with './')");
  EXPECT_FALSE(std::filesystem::exists("--no-plots"));
  expect_refusal({"run", "--out", ""}, "output directory '' is empty: name a directory");
  EXPECT_EQ(read_file(file), "kept");
}

TEST(BadInput, Baselines) {
  const TemporaryDirectory directory;
  const std::string committed = SHADEFIT_SOURCE_DIR "/reports/baseline";
  const std::string none = directory / "none";
  expect_refusal(
      {"check", "--baseline", none},
      "baseline '" + none +
          "' is missing: name the directory with --baseline, or make one with 'shadefit run --out DIR'");
  const std::string file = directory.file("file", "");
  expect_refusal({"check", "--baseline", file},
                 "baseline '" + file +
                     "' is not a directory: it must hold fits.csv, normalization.csv and reflectance.csv");
  const std::string empty = directory / "empty";
  std::filesystem::create_directories(empty);
  expect_refusal({"check", "--baseline", empty},
                 "cannot read '" + empty + "/fits.csv': there is no such file");

  directory.file("cut/normalization.csv", read_file(committed + "/normalization.csv"));
  directory.file("cut/reflectance.csv", read_file(committed + "/reflectance.csv"));
  const auto fits = read_file(committed + "/fits.csv");
  const std::string cut = directory.file("cut/fits.csv", fits.substr(0, fits.size() - 10));
  expect_refusal({"check", "--baseline", directory / "cut"},
                 "'" + cut + "' is truncated: its last line has no end");
  directory.file("cut/fits.csv", fits.substr(0, fits.find('\n') + 1) + "sg-offset,x\n");
  expect_refusal({"check", "--baseline", directory / "cut"},
                 "'" + cut + "' line 2 has 2 cells: the header has 18");
  directory.file("cut/fits.csv", "constant,fitted\nsg-offset,1\n");
  const Outcome other = run_command_line({"check", "--baseline", directory / "cut"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(other.err.starts_with(
      "shadefit: '" + cut + "' has other columns (constant,fitted): they must be constant,parameter,"))
      << other.err;
}

TEST(BadInput, AVeryLongValueIsShortened) {
  const Outcome outcome = run_command_line({"fit", std::string(100000, 'x')});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_LT(outcome.err.size(), 700U);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

TEST(BadInput, Usage) {
  const std::string help = " (see 'shadefit --help')";
  expect_refusal({}, "A subcommand is required" + help);
  expect_refusal({"--verison"}, "unexpected argument '--verison' before a command");
  expect_refusal({"fit"}, "id is required" + help);
  expect_refusal({"run", "--outt", "x"}, "unexpected argument '--outt'" + help);
  expect_refusal({"list", "everything"}, "unexpected argument 'everything'" + help);
  expect_refusal({"run", "--out"}, "--out: 1 required DIR missing" + help);
  expect_refusal({"fit", "sg-offset", "--json", "--csv"}, "--json excludes --csv" + help);
  expect_refusal({"fit", "sg-offset", "--json", "--latex"}, "--json excludes --latex" + help);
  expect_refusal({"fit", "sg-offset", "--csv", "--latex"}, "--csv excludes --latex" + help);
  expect_refusal({"list", "--latex", "--json"}, "--json excludes --latex" + help);
}

}  // namespace
}  // namespace shadefit
