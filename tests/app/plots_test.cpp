#include <gtest/gtest.h>

#include <set>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/output.hpp"
#include "tests/fake_gnuplot.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::expect_has;
using testing::expect_lacks;
using testing::fake_gnuplot;
using testing::TemporaryDirectory;
namespace fs = std::filesystem;

Outcome run_fresnel(const TemporaryDirectory& directory, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"run", "--out", directory / "out", "--only", "fresnel-quadratic"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_command_line(arguments);
}

std::set<std::string> plots_in(const TemporaryDirectory& directory) {
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(directory / "out/plots"))
    found.insert(entry.path().filename().string());
  return found;
}

const std::set<std::string> data_and_scripts{"fresnel.csv", "fresnel.gnuplot", "fresnel-errors.csv",
                                             "fresnel-errors.gnuplot"};

TEST(RunPlots, StandBesideTheReportThatShowsThem) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin");
  const Outcome outcome = run_fresnel(directory);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  expect_has(outcome.out, "\nPlots: 2 of 2 drawn in " + (directory / "out/plots") + "\n");
  auto expected = data_and_scripts;
  expected.insert({"fresnel.svg", "fresnel-errors.svg"});
  EXPECT_EQ(plots_in(directory), expected) << "and nothing that is half-written";
  const std::string report = read_file(directory / "out/report.md");
  expect_has(report, "](plots/fresnel.svg)");
  expect_has(report, "](plots/fresnel-errors.svg)");
}

TEST(RunPlots, WithoutGnuplotAreSkippedAndSaidSo) {
  const TemporaryDirectory directory;
  const EnvironmentVariable path("PATH", directory / "bin");
  const Outcome outcome = run_fresnel(directory);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  expect_has(outcome.out, "\nPlots skipped: gnuplot was not found; their data and scripts are in " +
                              (directory / "out/plots") + "\n");
  EXPECT_EQ(plots_in(directory), data_and_scripts);
  expect_lacks(read_file(directory / "out/report.md"), "plots/");
}

TEST(RunPlots, OneThatFailsIsToldAndNotShown) {
  const TemporaryDirectory directory;
  fake_gnuplot(
      directory,
      "[ $script = fresnel.gnuplot ] || { echo '\"fresnel-errors.gnuplot\" line 3: no' >&2; exit 1; }\n"
      "echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin");
  const Outcome outcome = run_fresnel(directory);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "shadefit: plot fresnel-errors was not drawn: \"fresnel-errors.gnuplot\" line 3: no\n");
  expect_has(outcome.out, "\nPlots: 1 of 2 drawn in ");
  auto expected = data_and_scripts;
  expected.insert("fresnel.svg");
  EXPECT_EQ(plots_in(directory), expected);
  const std::string report = read_file(directory / "out/report.md");
  expect_has(report, "](plots/fresnel.svg)");
  expect_lacks(report, "](plots/fresnel-errors.svg)");
}

TEST(RunPlots, AnOlderPictureDoesNotStandBesideNewData) {
  const TemporaryDirectory directory;
  const EnvironmentVariable path("PATH", directory / "bin");
  directory.file("out/plots/mine.svg", "of the user");
  auto expected = data_and_scripts;
  expected.insert({"fresnel.svg", "mine.svg"});
  for (const std::string name : {"fresnel", "fresnel-errors"})
    directory.file("out/plots/" + name + ".svg", marked_picture("older"));
  fake_gnuplot(directory, "[ $script = fresnel.gnuplot ] && echo '</svg>' > \"$picture\"");
  EXPECT_EQ(run_fresnel(directory).exit_code, 1);
  EXPECT_EQ(plots_in(directory), expected) << "not the one that failed";
  EXPECT_EQ(read_file(directory / "out/plots/fresnel.svg"), marked_picture("</svg>\n"));

  fs::remove(directory / "bin/gnuplot");
  EXPECT_EQ(run_fresnel(directory).exit_code, 0);
  expected.erase("fresnel.svg");
  EXPECT_EQ(plots_in(directory), expected) << "without gnuplot none";
}

TEST(RunPlots, WhatIsPrintedOfThemIsPrintable) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "printf '\\033[2J%01000d\\n' 0; exit 1");
  const EnvironmentVariable path("PATH", directory / "bin");
  const Outcome outcome =
      run_command_line({"run", "--out", directory / "\x1B[31m", "--only", "fresnel-one-term"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ((outcome.out + outcome.err).find('\x1B'), std::string::npos);
  expect_has(outcome.err, "was not drawn: \\x1b[2J000");
  EXPECT_NE(outcome.err.find("000 .. 000"), std::string::npos) << "and not endless";
  expect_has(outcome.out, "drawn in " + (directory / "\\x1b[31m/plots\n"));
  expect_has(outcome.out, "\nReport: " + (directory / "\\x1b[31m/report.md\n"));
}

TEST(RunPlots, NoPlotsMeansNoneOfTheirFiles) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin");
  const Outcome outcome = run_fresnel(directory, {"--no-plots"});
  EXPECT_EQ(outcome.exit_code, 0);
  expect_lacks(outcome.out, "\nPlots");
  EXPECT_FALSE(fs::exists(directory / "out/plots"));
  expect_lacks(read_file(directory / "out/report.md"), "plots/");
}

// If gnuplot is installed, as in our CI, it draws every script without a message; else its absence is
// reported.
TEST(RunPlots, TheGnuplotOfThisMachineDrawsThemAll) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_command_line({"run", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const std::string said = find_gnuplot() ? "Plots: 7 of 7 drawn" : "Plots skipped: gnuplot was not found";
  expect_has(outcome.out, said);
  EXPECT_EQ(plots_in(directory).size(), find_gnuplot() ? 21U : 14U);
  if (!find_gnuplot()) return;
  EXPECT_EQ(run_command_line({"run", "--out", directory / "out"}).err, "") << "what was drawn is ours";
}

}  // namespace
}  // namespace shadefit
