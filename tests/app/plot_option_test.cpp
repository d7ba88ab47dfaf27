#include <gtest/gtest.h>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "reports/io/gnuplot.hpp"
#include "tests/fake_gnuplot.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::expect_refusal;
using testing::fake_gnuplot;
using testing::TemporaryDirectory;

TEST(PlotOption, DrawsEachKindOfPictureTheSameEachTime) {
  if (!find_gnuplot()) return;
  const TemporaryDirectory directory;
  for (const auto& [name, start] : {std::pair{"a.svg", "<?xml"}, {"a.pdf", "%PDF-"}, {"a.png", "\x89PNG"}}) {
    const std::vector<std::string> call{"fit",    "fresnel-quadratic", "--norm", "minimax",
                                        "--plot", directory / name};
    const Outcome first = run_command_line(call);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    const std::string picture = read_file(directory / name);
    EXPECT_TRUE(picture.starts_with(start)) << name;
    EXPECT_EQ(run_command_line(call).exit_code, 0) << "a picture of ours is replaced";
    EXPECT_TRUE(read_file(directory / name) == picture) << name;
  }
}

TEST(PlotOption, DrawsASweepAndAComparison) {
  if (!find_gnuplot()) return;
  const TemporaryDirectory directory;
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"fit", "sg-offset", "--exponent", "3:5:1"},
        {"better", "fresnel-one-term", "--target", "exact", "--ior", "1.5"}}) {
    auto arguments = call;
    arguments.insert(arguments.end(), {"--plot", directory / (call.front() + ".svg")});
    EXPECT_EQ(run_command_line(arguments).exit_code, 0);
  }
  EXPECT_NE(read_file(directory / "fit.svg").find("largest error"), std::string::npos);
  EXPECT_NE(read_file(directory / "better.svg").find("Schlick 1994"), std::string::npos);
}

TEST(PlotOption, TheWholeOutputIsTheSameWithoutIt) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, "echo '</svg>' > \"$picture\"");
  const EnvironmentVariable path("PATH", directory / "bin");
  const std::vector<std::string> call{"fit", "fresnel-one-term"};
  auto with_plot = call;
  with_plot.insert(with_plot.end(), {"--plot", directory / "a.svg"});
  EXPECT_EQ(run_command_line(with_plot).out, run_command_line(call).out);
}

TEST(PlotOption, RefusesWhatItCannotDraw) {
  const TemporaryDirectory directory;
  const EnvironmentVariable path("PATH", directory / "bin");
  expect_refusal({"fit", "fresnel-one-term", "--plot", "a.jpg"},
                 "--plot 'a.jpg' must end with .svg, .pdf or .png");
  expect_refusal({"fit", "fresnel-one-term", "--plot", "a.svg"},
                 "--plot 'a.svg' needs gnuplot: install the package gnuplot-nox");
  fake_gnuplot(directory, "echo 'bad luck' >&2; exit 1");
  expect_refusal({"fit", "sg-offset-mean", "--plot", "a.svg"},
                 "--plot 'a.svg' does not apply: sg-offset-mean is a mean or a limit of fits");
  expect_refusal({"better", "fresnel-one-term", "--plot", "a.svg"},
                 "--plot 'a.svg' draws one target, and these are 3: name one with --target");
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
  EXPECT_NE(outcome.err.find("was not written by shadefit"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_file(directory / "a.svg"), "mine");
  auto forced = call;
  forced.emplace_back("--force");
  EXPECT_EQ(run_command_line(forced).exit_code, 0);
  EXPECT_NE(read_file(directory / "a.svg"), "mine");
}

}  // namespace
}  // namespace shadefit
