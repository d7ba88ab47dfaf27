#include <gtest/gtest.h>

#include <filesystem>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "reports/io/gnuplot.hpp"
#include "tests/app/refusal.hpp"
#include "tests/fake_gnuplot.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::fake_gnuplot;
using testing::TemporaryDirectory;
using testing::with;

TEST(PlotOption, DrawsTheSameEachTime) {
  if (!find_gnuplot()) return;
  const TemporaryDirectory directory;
  const std::string file = directory / "a.svg";
  const std::vector<std::string> call{"fit", "fresnel-quadratic", "--norm", "minimax", "--plot", file};
  EXPECT_EQ(run_command_line(call).exit_code, 0);
  const std::string picture = read_file(file);
  EXPECT_TRUE(picture.starts_with("<?xml"));
  EXPECT_EQ(run_command_line(call).exit_code, 0) << "a picture of ours is replaced";
  EXPECT_TRUE(read_file(file) == picture);
}

TEST(PlotOption, DrawsAComparison) {
  if (!find_gnuplot()) return;
  const TemporaryDirectory directory;
  const std::string file = directory / "better.svg";
  EXPECT_EQ(
      run_command_line({"better", "fresnel-one-term", "--target", "exact", "--ior", "1.5", "--plot", file})
          .exit_code,
      0);
  expect_has(read_file(file), "Schlick 1994");
}

TEST(PlotOption, SaysWhichFileItWroteAndElseTheSame) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin");
  const std::vector<std::string> call{"fit", "fresnel-one-term"};
  const auto with_plot = with(call, {"--plot", directory / "a.svg"});
  EXPECT_EQ(run_command_line(with_plot).out,
            run_command_line(call).out + "Picture: " + directory / "a.svg" + "\n");
  const Outcome for_program = run_command_line(with(with_plot, {"--json"}));
  EXPECT_EQ(for_program.out, run_command_line({"fit", "fresnel-one-term", "--json"}).out);
  EXPECT_EQ(for_program.err, "shadefit: picture: " + directory / "a.svg" + "\n");
}

TEST(PlotOption, RefusesWhatItCannotDraw) {
  const TemporaryDirectory directory;
  const EnvironmentVariable path("PATH", directory / "bin");
  expect_refusal({"fit", "fresnel-one-term", "--plot", "a.pdf"}, "--plot 'a.pdf' must end with .svg");
  expect_refusal({"fit", "fresnel-one-term", "--plot", "a.svg"},
                 "--plot 'a.svg' needs gnuplot: install the package gnuplot-nox");
  const std::string nowhere = directory / "no/folder";
  expect_refusal(
      {"fit", "acos-linear", "--plot", nowhere + "/a.svg"},
      "--plot '" + nowhere + "/a.svg' names no folder that is there: make '" + nowhere + "' first");
  EXPECT_FALSE(std::filesystem::exists(directory / "no"));
  fake_gnuplot(directory, "echo 'bad luck' >&2; exit 1");
  expect_refusal({"better", "sg-offset", "--plot", "a.svg"},
                 "--plot 'a.svg' draws one target, and these are 2: give one value by --given");
  const std::string file = directory / "a.svg";
  expect_refusal({"fit", "fresnel-one-term", "--plot", file},
                 "--plot '" + file + "' was not drawn: bad luck");
}

TEST(PlotOption, AForeignPictureStays) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin");
  directory.file("a.svg", "mine");
  const std::vector<std::string> call{"fit", "fresnel-one-term", "--plot", directory / "a.svg"};
  const Outcome outcome = run_command_line(call);
  EXPECT_EQ(outcome.exit_code, 2);
  expect_has(outcome.err, "was not written by shadefit");
  EXPECT_EQ(read_file(directory / "a.svg"), "mine");
  EXPECT_EQ(run_command_line(with(call, {"--force"})).exit_code, 0);
  EXPECT_NE(read_file(directory / "a.svg"), "mine");
}

/// The script that gnuplot gets for a picture.
std::string script_of(const std::vector<std::string>& call) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "cp \"$script\" '" + directory / "seen" + "'; echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin" + ":/usr/bin:/bin");
  const Outcome outcome = run_command_line(with(call, {"--plot", directory / "a.svg"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return read_file(directory / "seen");
}

TEST(PlotOption, AMinimaxFitOfAStudyHasItsLevelAndContacts) {
  const std::string script = script_of({"fit", "acos-linear"});
  expect_has(script, "'level 0.003207'");
  expect_has(script, "column('contact')");
  expect_lacks(script_of({"fit", "acos-linear", "--norm", "least-squares"}), "level");
  // A relative error is drawn as it is minimised, so the level belongs to it too.
  const std::string relative = script_of({"fit", "exp2-cubic", "--norm", "minimax"});
  expect_has(relative, "relative error");
}

TEST(PlotOption, TargetsOfTwoVariablesAreToldApart) {
  const std::string script =
      script_of({"fit", "--target", "x y", "--form", "a x + b y", "--over", "x=0:1", "--over", "y=0:1"});
  for (const char* entry : {"ls 10 title 'target, y = 0'", "ls 13 title 'target, y = 1'"})
    expect_has(script, entry);
  expect_has(script, "size 900,746");  // gnuplot draws three rows: under 44 pixels the last would be cut
}

TEST(PlotOption, LongTitlesAndLabelsHaveSeveralLines) {
  std::string form = "a";
  for (int i = 1; i < 40; ++i) form += " + x^" + std::to_string(i) + "/" + std::to_string(100 + i);
  const std::string script = script_of({"fit", "--target", "exp(x)", "--form", form, "--over", "x=0:1"});
  const std::size_t begin = script.find("set title ");
  const std::string title = script.substr(begin, script.find('\n', begin) - begin);
  expect_has(title, ".\"\\n\".");
  for (std::size_t at = 0; at < title.size(); at += 120)
    EXPECT_NE(title.substr(at, 120).find('\''), std::string::npos) << "a line is too long: " << title;
  std::string linear = "a0";
  for (int i = 1; i < 9; ++i) linear += " + a" + std::to_string(i) + "*x^" + std::to_string(i);
  const std::string many = script_of({"fit", "--target", "exp(x)", "--form", linear, "--over", "x=0:1"});
  expect_has(many, "vertical maxcols 1");
  expect_has(many, "keyentry with lines lc rgb '#FFFFFF' title 'a");
}

}  // namespace
}  // namespace shadefit
