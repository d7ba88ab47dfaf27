#include "reports/gnuplot.hpp"

#include <gtest/gtest.h>

#include "reports/files.hpp"
#include "tests/fake_gnuplot.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::fake_gnuplot;
using testing::TemporaryDirectory;
namespace fs = std::filesystem;

std::size_t count_entries(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

TEST(Gnuplot, IsTheFirstProgramOfThatNameInThePath) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "a/gnuplot");
  directory.file("b/gnuplot", "not to be run");
  const std::string program = fake_gnuplot(directory, "");
  const EnvironmentVariable path("PATH", ":" + (directory / "none") + ":" + (directory / "a") + ":" +
                                             (directory / "b") + ":" + (directory / "bin"));
  EXPECT_EQ(find_gnuplot(), program) << "a directory and a file that is not executable are passed over";
  fs::remove(program);
  EXPECT_EQ(find_gnuplot(), std::nullopt);
}

TEST(Gnuplot, DrawsEachPlotInItsDirectoryAndLeavesNothingBeside) {
  const TemporaryDirectory directory;
  const std::string program = fake_gnuplot(
      directory, "read line && exit 1; { echo \"$1 $2 $script$GNUTERM\"; echo '</svg>'; } > \"$picture\"");
  directory.file("plots/a.svg", "old");
  const EnvironmentVariable terminal("GNUTERM", "png");
  const auto failed = draw_plots(program, directory / "plots", {"a", "b", "c"});
  EXPECT_TRUE(failed.empty()) << failed.front().complaint;
  for (const std::string name : {"a", "b", "c"}) {
    EXPECT_EQ(read_file(directory / ("plots/" + name + ".svg")), "-d -e " + name + ".gnuplot\n</svg>\n")
        << "no startup file, no inherited terminal, nothing on standard input";
  }
  EXPECT_EQ(count_entries(directory / "plots"), 3U);
}

TEST(Gnuplot, AFailureIsToldAndLeavesNoPicture) {
  const TemporaryDirectory directory;
  const std::string program = fake_gnuplot(
      directory,
      "echo '</svg>' > \"$picture\"\n"
      "[ $script != b.gnuplot ] || { echo 'b.gnuplot line 2: warning: odd'; echo 'plt x'; echo '^' >&2; echo \"$script line 7: no such command\" >&2; exit 3; }");
  directory.file("plots/b.svg", "old");
  const auto failed = draw_plots(program, directory / "plots", {"a", "b", "c"});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].name, "b");
  EXPECT_EQ(failed[0].complaint, "b.gnuplot line 7: no such command");
  EXPECT_TRUE(fs::exists(directory / "plots/a.svg"));
  EXPECT_TRUE(fs::exists(directory / "plots/c.svg"));
  EXPECT_EQ(count_entries(directory / "plots"), 2U) << "neither a part of b.svg nor the old one";
}

TEST(Gnuplot, EveryKindOfFailureHasWords) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "plots");
  const auto complaint = [&](const std::string& body) {
    const auto failed = draw_plots(fake_gnuplot(directory, body), directory / "plots", {"a"});
    EXPECT_EQ(failed.size(), 1U) << body;
    EXPECT_EQ(count_entries(directory / "plots"), 0U) << body;
    return failed.empty() ? "" : failed.front().complaint;
  };
  EXPECT_EQ(complaint("echo; echo '  cannot start'; exit 1"), "cannot start");
  EXPECT_EQ(complaint("exit 1"), "gnuplot failed and said nothing");
  EXPECT_EQ(complaint("kill -9 $$"), "gnuplot was ended: Killed");
  EXPECT_EQ(complaint("echo '<svg>' > \"$picture\""), "gnuplot left no whole picture") << "a full disk";
  EXPECT_EQ(complaint("exit 0"), "gnuplot left no whole picture");
  const auto failed = draw_plots(directory / "none", directory / "plots", {"a"});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].complaint, "No such file or directory");
}

TEST(Gnuplot, APlaceThatIsTakenIsAFailure) {
  const TemporaryDirectory directory;
  directory.file("plots/a.svg/precious", "kept");
  const auto program = fake_gnuplot(directory, "echo '</svg>' > \"$picture\"");
  const auto failed = draw_plots(program, directory / "plots", {"a"});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].complaint, "Is a directory");
  EXPECT_EQ(read_file(directory / "plots/a.svg/precious"), "kept");
  EXPECT_EQ(count_entries(directory / "plots"), 1U);
}

}  // namespace
}  // namespace shadefit
