#include "app/interrupt.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "app/command_line.hpp"
#include "reports/files.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::snapshot;
using testing::TemporaryDirectory;

/// Holds the signals back while a test runs, with the dispositions that a terminal gives a program.
class Interrupt : public ::testing::Test {
 protected:
  Interrupt() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    signals_ = hold_interrupts();
  }
  ~Interrupt() override { release(signals_); }

  /// Raises `signal` at the n-th call, counted from 1, and then looks as the command's own checkpoint does.
  Checkpoint raising(int signal, int n) const {
    return [look = interruptible(signals_), signal, n, calls = 0]() mutable {
      if (++calls == n) std::raise(signal);
      look();
    };
  }

  HeldSignals signals_{};
};

TEST_F(Interrupt, ACheckpointThrowsTheSignalThatWaitsAndTakesIt) {
  const Checkpoint look = interruptible(signals_);
  EXPECT_NO_THROW(look());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::raise(signal);
    try {
      look();
      ADD_FAILURE() << "signal " << signal << " was not seen";
    } catch (const Interrupted& interrupted) {
      EXPECT_EQ(interrupted.signal, signal);
    }
    EXPECT_NO_THROW(look()) << "it is gone: releasing the signals does not end the process";
  }
}

TEST_F(Interrupt, ThoseThatWaitCanBeTakenAtOnce) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::raise(signal);
  take_waiting(signals_);
  EXPECT_NO_THROW(interruptible(signals_)());
}

TEST_F(Interrupt, AnIgnoredSignalStaysIgnored) {
  release(signals_);
  std::signal(SIGINT, SIG_IGN);
  signals_ = hold_interrupts();
  std::raise(SIGINT);
  EXPECT_NO_THROW(interruptible(signals_)());
  std::signal(SIGINT, SIG_DFL);
}

TEST_F(Interrupt, FromAWriteHookLeavesOldFilesAndNothingElse) {
  const TemporaryDirectory directory;
  directory.file("one", "old\n");
  const auto before = snapshot(directory.path());
  const std::vector<File> files{{"one", "new\n"}, {"two", "new\n"}};
  for (int n = 1; n <= 3; ++n) {
    EXPECT_THROW(write_files(directory.path(), files, raising(SIGINT, n)), Interrupted) << n;
    EXPECT_EQ(snapshot(directory.path()), before) << n;
  }
}

// At each checkpoint of a run: those of the fits, the normalisations, the plots and the files.
TEST_F(Interrupt, ARunEndsAtAnyCheckpointWithNothingWritten) {
  const TemporaryDirectory directory;
  const std::vector<std::string> plain{
      "run", "--out", directory / "out", "--only", "fresnel-one-term", "norm-lambert", "--no-plots"};
  const std::vector<std::string> with_plots(plain.begin(), plain.end() - 1);
  const auto count = [](const std::vector<std::string>& run) {
    int calls = 0;
    EXPECT_EQ(run_command_line(run, [&] { ++calls; }).exit_code, 0);
    return calls;
  };
  // Three measures of one family, the chain to exact Fresnel, one normalisation, three claims, two targets
  // that seven forms meet, each file and the renaming.
  const int plain_calls = count(plain);
  EXPECT_EQ(plain_calls, 3 + 1 + 1 + 3 + 2 * 7 + std::ssize(snapshot(directory / "out")) + 1);
  std::filesystem::remove_all(directory / "out");
  directory.file("out/report.md", "an older report\n");
  const auto before = snapshot(directory.path());
  for (const auto& run : {plain, with_plots}) {
    // How often a run looks while gnuplot works is not known: it goes on until one comes to its end. Under
    // the sanitizers a run takes seconds, and every third place has to do.
#ifdef SHADEFIT_SANITIZE
    constexpr int step = 3;
#else
    constexpr int step = 1;
#endif
    for (int n = 1;; n += step) {
      const int signal = n % 2 == 0 ? SIGINT : SIGTERM;
      const Outcome outcome = run_command_line(run, raising(signal, n));
      if (outcome.exit_code == 0) {
        EXPECT_GT(n, plain_calls);
        std::filesystem::remove_all(directory / "out");
        directory.file("out/report.md", "an older report\n");
        break;
      }
      EXPECT_EQ(outcome.exit_code, 128 + signal) << n;
      EXPECT_EQ(outcome.out, "");
      EXPECT_EQ(outcome.err, "shadefit: interrupted, nothing was written\n");
      EXPECT_EQ(snapshot(directory.path()), before) << n;
    }
  }
}

TEST_F(Interrupt, ALongFitAndACheckEndToo) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"fit", "sg-offset", "--exponent", "1:100000:1"},
        {"check", "--baseline", SHADEFIT_SOURCE_DIR "/reports/baseline"}}) {
    const Outcome outcome = run_command_line(arguments, raising(SIGINT, 5));
    EXPECT_EQ(outcome.exit_code, 130) << arguments.front();
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
}  // namespace shadefit
