#include "reports/io/gnuplot.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>

#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "tests/fake_gnuplot.hpp"
#include "tests/refusal.hpp"
#include "tests/reports/stop.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::fake_gnuplot;
using testing::Stop;
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

TEST(Gnuplot, NamesOnesThatEndWithPngAsTheyAre) {
  const TemporaryDirectory directory;
  const std::string program = fake_gnuplot(
      directory, "[ $script = a.gnuplot ] || exit 1\necho 'IEND, and four bytes' > \"$picture\"");
  std::filesystem::create_directory(directory.path() / "plots");
  EXPECT_TRUE(draw_plots(program, directory / "plots", {"a.png"}).empty());
  EXPECT_EQ(snapshot(directory.path() / "plots").count("a.png"), 1U);
  EXPECT_EQ(
      draw_plots(fake_gnuplot(directory, "echo '</svg>' > \"$picture\""), directory / "plots", {"a.png"})
          .at(0)
          .complaint,
      "gnuplot left no whole picture");
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

bool has_children() {
  return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

TEST(Gnuplot, OneThatHangsEndsWithTheCheckpointThatThrows) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "temporary");
  const EnvironmentVariable temporary("TMPDIR", directory / "temporary");
  const std::string pid = directory / "pid";
  const auto program = fake_gnuplot(directory, "echo $$ > " + pid + "; exec sleep 1000");
  const std::vector<File> files{{"plots/a.gnuplot", ""}, {"plots/b.gnuplot", ""}, {"plots/c.gnuplot", ""}};
  // The first calls are those of the files and those before each start, all others those of waiting.
  for (int n = 1; n <= 12; ++n) {
    const auto stop = [n, calls = 0]() mutable {
      if (++calls == n) throw Stop{};
    };
    EXPECT_THROW(draw_pictures(program, files, {"a", "b", "c"}, stop), Stop) << n;
    EXPECT_FALSE(has_children()) << n;
    EXPECT_EQ(count_entries(directory / "temporary"), 0U) << n;
  }
  // And once one is known to hang, not only to have been started.
  fs::remove(pid);
  const auto stop_once_it_hangs = [&, calls = 0]() mutable {
    constexpr int too_many = 100000;
    if (++calls == too_many || (fs::exists(pid) && fs::file_size(pid) > 0)) throw Stop{};
  };
  EXPECT_THROW(draw_pictures(program, files, {"a"}, stop_once_it_hangs), Stop);
  const std::string process = read_file(pid);
  ASSERT_FALSE(process.empty());
  EXPECT_NE(::kill(std::stoi(process), 0), 0);
  EXPECT_FALSE(has_children());
  EXPECT_EQ(count_entries(directory / "temporary"), 0U);
}

TEST(Gnuplot, OneThatDoesNotHearIsKilled) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "plots");
  const std::string deaf = directory / "deaf";
  const auto program = fake_gnuplot(directory, "trap '' TERM; : > " + deaf + "; exec sleep 1000");
  const auto stop_once_it_is_deaf = [&, calls = 0]() mutable {
    constexpr int too_many = 100000;
    if (++calls == too_many || fs::exists(deaf)) throw Stop{};
  };
  EXPECT_THROW(draw_plots(program, directory / "plots", {"a"}, stop_once_it_is_deaf), Stop);
  EXPECT_TRUE(fs::exists(deaf));
  EXPECT_FALSE(has_children());
  EXPECT_EQ(count_entries(directory / "plots"), 0U);
}

TEST(Gnuplot, APictureThatTakesTooLongIsAFailure) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "plots");
  const auto program = fake_gnuplot(directory, "exec sleep 1000");
  const auto failed =
      draw_plots(program, directory / "plots", {"a", "b"}, keep_going, std::chrono::seconds(0));
  ASSERT_EQ(failed.size(), 2U);
  EXPECT_EQ(failed[0].complaint, "gnuplot took longer than 0 s");
  EXPECT_EQ(failed[1].name, "b") << "and the next is tried";
  EXPECT_FALSE(has_children());
  EXPECT_EQ(count_entries(directory / "plots"), 0U);
}

TEST(Gnuplot, WhatItSaysIsKeptWhereItWorks) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "plots");
  const auto program = fake_gnuplot(directory, "readlink /proc/$$/fd/1 /proc/$$/fd/2; exit 1");
  const auto failed = draw_plots(program, directory / "plots", {"a"});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_TRUE(failed[0].complaint.starts_with(fs::canonical(directory / "plots").string() + "/.transcript-"))
      << failed[0].complaint;
  EXPECT_EQ(count_entries(directory / "plots"), 0U);

  const auto nowhere = draw_plots(program, directory / "none", {"a"});
  ASSERT_EQ(nowhere.size(), 1U);
  EXPECT_EQ(nowhere[0].complaint,
            "cannot create a file in '" + (directory / "none") + "': No such file or directory");
}

TEST(Gnuplot, TemporaryFilesThatHaveNoDirectory) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("file", "x");
  for (const auto& [value, reason] :
       {std::pair{directory / "none", "No such file or directory"}, {file, "Not a directory"}}) {
    const EnvironmentVariable temporary("TMPDIR", value);
    EXPECT_EQ(testing::refusal([&] { draw_pictures(directory / "none", {}, {}); }),
              "TMPDIR '" + value + "' is not a directory: " + reason);
  }
  const EnvironmentVariable unset("TMPDIR", "");
  const EnvironmentVariable next("TMP", directory / "none");
  EXPECT_THROW(draw_pictures(directory / "none", {}, {}), UserError) << "one that is empty is passed over";
}

}  // namespace
}  // namespace shadefit
