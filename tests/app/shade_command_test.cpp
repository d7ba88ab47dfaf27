#include <gtest/gtest.h>

#include <string>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/own_file.hpp"
#include "tests/app/refusal.hpp"
#include "tests/fake_gnuplot.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::expect_refusal;
using testing::fake_gnuplot;
using testing::snapshot;
using testing::TemporaryDirectory;

constexpr const char* black_and_shiny =
    "newmtl black\nNs 50\nKs 0 0 0\nillum 2\n"
    "newmtl shiny\nNs 20\nKs 0.5 0.4 0.3\nillum 2\n";

/// A picture of either kind: the tested part.
constexpr const char* drawing = "echo '</svg> IEND' > \"$picture\"";

TEST(ShadeCommand, ComparesFourWays) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", black_and_shiny);
  const Outcome outcome = run_command_line({"scene", file, "--shade"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part :
       {"\nway  ", "\nreference  ", "\npublished  ", "\npublished, culled  ", "\nplanned  ", "\nPlanned: ",
        " ns a shaded sample. The reference in float takes ", " x in the plan's kernel. Their error is ",
        "\nThe plan skips 0 % of the shaded samples by their materials, and culls ", "\nTimed: "})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << outcome.out;
  EXPECT_EQ(snapshot(directory.path()).size(), 1U) << "nothing is written unless it is asked for";
}

TEST(ShadeCommand, WritesTableFigureAndPicture) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory, drawing);
  const EnvironmentVariable path("PATH", directory / "bin");
  const std::string file = directory.file("a.mtl", black_and_shiny);
  const Outcome outcome = run_command_line({"scene", file, "--shade", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto written = snapshot(directory.path() / "out");
  for (const char* name : {"scene.md", "scene.csv", "scene.json", "shade.csv", "scene.png", "plots/shade.csv",
                           "plots/shade.gnuplot", "plots/shade.svg"})
    EXPECT_EQ(written.count(name), 1U) << name;
  EXPECT_EQ(written.size(), 12U) << "these and the directory plots";
  EXPECT_TRUE(
      written.at("shade.csv")
          .starts_with("way,tolerance,form,ns_per_sample,max_error,mean_error,max_codes,mean_codes,device\n"
                       "reference,,pow,"));
  EXPECT_NE(outcome.out.find("\nPicture: " + (directory / "out/scene.png") + "\n"), std::string::npos);
}

TEST(ShadeCommand, WithoutGnuplotPicturesAreSkippedAndSaidSo) {
  const TemporaryDirectory directory;
  const EnvironmentVariable path("PATH", directory / "bin");
  const std::string file = directory.file("a.mtl", black_and_shiny);
  directory.file("out/scene.png", marked_picture("scene.png", "an older one"));
  const Outcome outcome = run_command_line({"scene", file, "--shade", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nPicture skipped: gnuplot was not found\n"), std::string::npos) << outcome.out;
  const auto written = snapshot(directory.path() / "out");
  EXPECT_EQ(written.count("scene.png"), 0U) << "no older one stands beside a new plan";
  EXPECT_EQ(written.count("shade.csv"), 1U);
}

TEST(ShadeCommand, APictureThatFailsIsTold) {
  const TemporaryDirectory directory;
  fake_gnuplot(directory,
               std::string("[ $script = shade.gnuplot ] || { echo 'line 3: no' >&2; exit 1; }\n") + drawing);
  const EnvironmentVariable path("PATH", directory / "bin");
  const std::string file = directory.file("a.mtl", black_and_shiny);
  const Outcome outcome = run_command_line({"scene", file, "--shade", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "shadefit: scene.png was not drawn: line 3: no\n");
}

// By the gnuplot of this machine, if there is one.
TEST(ShadeCommand, NamesAreNoCommandsOfGnuplot) {
  const TemporaryDirectory directory;
  std::string materials;
  for (const char* name : {"'a", "b''c", "''", "`touch x`", "@m", "a\"b", "\\n", "$x", "a{b}^c"})
    materials += std::string("newmtl ") + name + "\nNs 20\nKs 0.5 0.4 0.3\nillum 2\n";
  const std::string file = directory.file("a.mtl", materials);
  const Outcome outcome = run_command_line({"scene", file, "--shade", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(ShadeCommand, OfNothingToSee) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", "newmtl black\nNs 50\nKs 0 0 0\nillum 2\n");
  const Outcome outcome = run_command_line({"scene", file, "--shade"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nPlanned: no material has a lobe, and nothing is computed. "),
            std::string::npos)
      << outcome.out;
}

TEST(ShadeCommand, RefusesJson) {
  expect_refusal({"scene", "a.mtl", "--shade", "--json"},
                 "--json excludes --shade (see 'shadefit help scene')");
}

}  // namespace
}  // namespace shadefit
