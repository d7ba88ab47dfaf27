#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/output/progress.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/files.hpp"
#include "tests/temporary_directory.hpp"

/// Messages on faults of the machine, the disk or a file, and that they come early.
namespace shadefit {
namespace {

using testing::TemporaryDirectory;

/// A command that does not get beyond its first checkpoint.
template <class Error>
Outcome ended_by(const Error& error) {
  return run_command_line({"fit", "sg-offset", "--exponent", "5"}, [&] { throw error; });
}

TEST(Unforeseen, SaysWhoseErrorItIs) {
  const std::error_code refused = std::make_error_code(std::errc::permission_denied);
  const Outcome of_files = ended_by(std::filesystem::filesystem_error("status", "a\nb", refused));
  EXPECT_EQ(of_files.exit_code, 2);
  EXPECT_EQ(of_files.err, "shadefit: cannot use 'a\\x0ab': Permission denied\n");
  const Outcome of_memory = ended_by(std::bad_alloc());
  EXPECT_EQ(of_memory.exit_code, 1);
  EXPECT_EQ(of_memory.err, "shadefit: out of memory\n");
  const Outcome of_threads =
      ended_by(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)));
  EXPECT_EQ(of_threads.exit_code, 1);
  EXPECT_EQ(of_threads.err, "shadefit: cannot start a thread: Resource temporarily unavailable\n");
  const Outcome of_ours = ended_by(std::logic_error("a == b"));
  EXPECT_EQ(of_ours.exit_code, 1);
  EXPECT_EQ(
      of_ours.err,
      "shadefit: internal error: a == b; please report it with the call: shadefit fit sg-offset --exponent "
      "5\n");
}

// Missing or unreadable files are reported before anything is computed.
TEST(CheckCommand, LooksAtAllOfTheBaselineFirst) {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::string& line) {
    int calls = 0;
    const Outcome outcome =
        run_command_line({"check", "--all", "--baseline", directory.path().string()}, [&] { ++calls; });
    EXPECT_EQ(calls, 0) << line;
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "shadefit: " + line + "\n");
  };
  const std::string committed = SHADEFIT_SOURCE_DIR "/reports/baseline";
  for (const File& table : read_baseline(committed).files) directory.file(table.name, table.content);
  refused("cannot read '" + (directory / "slow/stress.csv") + "': there is no such file");
  for (const char* slow : {"slow/stress.csv", "slow/stress-fits.csv", "slow/accuracy.csv"})
    directory.file(slow, read_file(committed + "/" + slow));
  directory.file("slow/accuracy.csv", "target\n\"schlick\n");
  refused("'" + (directory / "slow/accuracy.csv") + "' line 2 opens a quote and never closes it");
}

// Each command that writes at its end tests first whether it can write.
TEST(Outputs, AreTriedBeforeTheWork) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"stress", "--out", "/proc/x"},
        {"run", "--out", "/proc/x"},
        {"bench", "--out", "/proc/x"},
        {"bench", "--exhaustive", "all", "--out", "/proc/x"},
        {"certify", "fresnel-quadratic", "--out", "/proc/x/certificate"},
        {"emit", "fresnel-quadratic", "--lang", "c", "--out", "/proc/x/code"}}) {
    int calls = 0;
    const Outcome outcome = run_command_line(arguments, [&] { ++calls; });
    EXPECT_EQ(calls, 0) << arguments.front();
    EXPECT_EQ(outcome.exit_code, 2) << arguments.front();
    EXPECT_EQ(outcome.err, "shadefit: cannot create directory '/proc/x': No such file or directory\n");
  }
}

TEST(Outputs, BadPathsAreTheUsers) {
  const TemporaryDirectory directory;
  std::filesystem::create_symlink("loop", directory.path() / "loop");
  const std::string too_long(256, 'x');
  for (const std::string& path :
       {directory / too_long, directory / "loop", directory / (too_long + "/x"), directory / "loop/x"}) {
    for (std::vector<std::string> arguments :
         {std::vector<std::string>{"emit", "fresnel-quadratic", "--lang", "c", "--out"},
          {"certify", "fresnel-quadratic", "--out"},
          {"run", "--only", "norm-lambert", "--no-plots", "--out"},
          {"stress", "--out"},
          {"emit", "--check"},
          {"verify"},
          {"scene"},
          {"check", "--baseline"}}) {
      arguments.push_back(path);
      const Outcome outcome = run_command_line(arguments);
      EXPECT_EQ(outcome.exit_code, 2) << arguments.front() << ": " << outcome.err;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
  }
}

TEST(Progress, IsShownOfWorkThatTakesLongAndToATerminal) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(::grantpt(terminal), 0);
  ASSERT_EQ(::unlockpt(terminal), 0);
  const int shown = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
  ASSERT_GE(shown, 0);
  // The kernel hands on what was written a little later.
  const auto said = [&](std::size_t expected) {
    std::string text;
    pollfd readable{terminal, POLLIN, 0};
    do {
      std::array<char, 256> buffer{};
      const auto length = ::read(terminal, buffer.data(), buffer.size());
      if (length > 0) text.append(buffer.data(), static_cast<std::size_t>(length));
    } while (text.size() < expected && ::poll(&readable, 1, 10'000) > 0);
    return text;
  };
  const Progress patient = terminal_progress(shown, std::chrono::hours(1));
  patient("fit .. 0 s");
  patient("");
  EXPECT_EQ(said(0), "") << "work that ends soon shows nothing";
  const Progress at_once = terminal_progress(shown, std::chrono::milliseconds(0));
  at_once("fit .. 2 s");
  at_once("");
  const std::string expected = "\r\x1b[Kfit .. 2 s\r\x1b[K";
  EXPECT_EQ(said(expected.size()), expected);
  ::close(shown);
  ::close(terminal);
}

TEST(Progress, OfWorkThatSaysNothingIsItsTime) {
  std::vector<std::string> lines;
  const Progress progress = [&](const std::string& line) { lines.push_back(line); };
  int calls = 0;
  const Checkpoint checkpoint = [&] { ++calls; };
  const Watched work = watch(checkpoint, progress, "certify");
  work.checkpoint();
  EXPECT_EQ(calls, 1);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines.front().starts_with("certify .. ")) << lines.front();
  work.progress("its own");
  work.checkpoint();
  EXPECT_EQ(lines.size(), 2U) << "its own line stays";
  work.progress("");
  work.checkpoint();
  EXPECT_EQ(lines.size(), 4U);
  EXPECT_EQ(calls, 3);
}

TEST(Progress, OfASweepIsTheShareThatIsDone) {
  std::vector<std::string> lines;
  EXPECT_EQ(run_command_line({"fit", "sg-offset", "--exponent", "1:4:1"}, keep_going,
                             [&](const std::string& line) { lines.push_back(line); })
                .exit_code,
            0);
  const auto shows = [&](const std::string& share) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with("fit ") && line.find(share) != std::string::npos;
    });
  };
  EXPECT_TRUE(shows(" 0 %") && shows(" 25 %") && shows(" 75 %"));
}

}  // namespace
}  // namespace shadefit
