#include "reports/io/gnuplot.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "tests/fake_gnuplot.hpp"

namespace shadefit {
namespace {

using testing::EnvironmentVariable;
using testing::fake_gnuplot;
using testing::TemporaryDirectory;
namespace fs = std::filesystem;

/// What a checkpoint throws: a type that is unknown to the tested code.
struct Stop {};

/// The scratch directories of one test.
struct Scratch {
  TemporaryDirectory directory;
  EnvironmentVariable variable{"TMPDIR", directory.path().string()};
  ~Scratch() { EXPECT_TRUE(fs::is_empty(directory.path())) << "nothing is left"; }
};

/// Draws the plots of these names with a fake gnuplot of that body.
Pictures draw(const std::string& body, const std::vector<std::string>& names,
              const Checkpoint& checkpoint = keep_going, std::chrono::seconds longest = longest_drawing) {
  const Scratch scratch;
  const TemporaryDirectory directory;
  std::vector<File> files;
  for (const std::string& name : names) files.push_back({"plots/" + name + ".gnuplot", ""});
  return draw_pictures(fake_gnuplot(directory, body), files, names, checkpoint, longest);
}

TEST(Gnuplot, IsTheFirstProgramOfThatNameInThePath) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "a/gnuplot");
  directory.file("b/gnuplot", "not to be run");
  const std::string program = fake_gnuplot(directory, "");
  const EnvironmentVariable path("PATH", ":bin:" + (directory / "none") + ":" + (directory / "a") + ":" +
                                             (directory / "b") + ":" + (directory / "bin"));
  EXPECT_EQ(find_gnuplot(), program)
      << "a directory, a file that is not executable and a relative name are passed over";
  fs::remove(program);
  EXPECT_EQ(find_gnuplot(), std::nullopt);
}

TEST(Gnuplot, DrawsEachPlot) {
  const EnvironmentVariable terminal("GNUTERM", "png");
  const Pictures pictures =
      draw("read line && exit 1; { echo \"$1 $script$GNUTERM\"; echo '</svg>'; } > \"$picture\"", {"a", "b"});
  EXPECT_TRUE(pictures.failed.empty());
  ASSERT_EQ(pictures.files.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string name(1, "ab"[i]);
    EXPECT_EQ(pictures.files[i].name, "plots/" + name + ".svg");
    EXPECT_TRUE(pictures.files[i].content.starts_with("-d " + name + ".gnuplot\n</svg>\n"))
        << "no startup file, no inherited terminal, nothing on standard input";
  }
}

TEST(Gnuplot, EveryKindOfFailureHasWordsAndLeavesTheOtherPictures) {
  struct Case {
    std::string body, complaint;
  };
  for (const auto& [body, complaint] :
       std::vector<Case>{{"echo 'b.gnuplot line 2: warning: odd'; echo 'plt x'; echo '^' >&2; "
                          "echo \"$script line 7: no such command\" >&2; exit 3",
                          "b.gnuplot line 7: no such command"},
                         {"echo 'cannot start'; echo; exit 1", "cannot start"},
                         {"exit 1", "gnuplot failed and said nothing"},
                         {"kill -9 $$", "gnuplot failed and said nothing"},
                         {"echo '<svg>' > \"$picture\"", "gnuplot left no whole picture"},  // a full disk
                         {"exit 0", "gnuplot left no whole picture"}}) {
    const Pictures pictures = draw(
        "[ $script = b.gnuplot ] || { echo '</svg>' > \"$picture\"; exit 0; }\n" + body, {"a", "b", "c"});
    ASSERT_EQ(pictures.failed.size(), 1U) << body;
    EXPECT_EQ(pictures.failed[0].name, "b");
    EXPECT_EQ(pictures.failed[0].complaint, complaint);
    EXPECT_EQ(pictures.files.size(), 2U);
  }
}

bool has_children() {
  return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

TEST(Gnuplot, OneThatHangsEndsWithTheCheckpointThatThrows) {
  for (int n = 1; n <= 5; ++n) {
    const auto stop = [n, calls = 0]() mutable {
      if (++calls == n) throw Stop{};
    };
    EXPECT_THROW(draw("exec sleep 1000", {"a", "b", "c"}, stop), Stop) << n;
    EXPECT_FALSE(has_children()) << n;
  }
  const std::string pid = ::testing::TempDir() + "shadefit-hangs-" + std::to_string(::getpid());
  // And once one is known to hang, not only to have been started; also one that does not hear.
  const auto stop_once_it_hangs = [&, calls = 0]() mutable {
    constexpr int too_many = 100000;
    if (++calls == too_many || (fs::exists(pid) && fs::file_size(pid) > 0)) throw Stop{};
  };
  EXPECT_THROW(draw("trap '' TERM; echo $$ > " + pid + "; exec sleep 1000", {"a"}, stop_once_it_hangs), Stop);
  const std::string process = read_file(pid);
  ASSERT_FALSE(process.empty());
  EXPECT_NE(::kill(std::stoi(process), 0), 0);
  fs::remove(pid);
  EXPECT_FALSE(has_children());
}

TEST(Gnuplot, APictureThatTakesTooLongIsAFailure) {
  const Pictures pictures = draw("exec sleep 1000", {"a", "b"}, keep_going, std::chrono::seconds(0));
  ASSERT_EQ(pictures.failed.size(), 2U);
  for (const FailedPlot& failed : pictures.failed)
    EXPECT_EQ(failed.complaint, "gnuplot took longer than 0 s");
  EXPECT_FALSE(has_children());
}

TEST(Gnuplot, TemporaryFilesThatHaveNoDirectory) {
  const TemporaryDirectory directory;
  const EnvironmentVariable temporary("TMPDIR", directory / "none");
  EXPECT_THROW(draw_pictures(directory / "none", {}, {}), UserError);
}

}  // namespace
}  // namespace shadefit
