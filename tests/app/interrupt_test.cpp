#include "app/output/interrupt.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <thread>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/output/print.hpp"
#include "reports/io/files.hpp"
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
  ~Interrupt() override { release(); }

  void release() const { pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr); }

  /// Raises `signal` at the n-th call, counted from 1, and then tests for it like the command's own
  /// checkpoint.
  Checkpoint raising(int signal, int n) const {
    return [look = interruptible(signals_), signal, n, calls = 0]() mutable {
      if (++calls == n) std::raise(signal);
      look();
    };
  }

  sigset_t signals_{};
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
  while (take_signal(signals_) > 0) {
  }
  EXPECT_NO_THROW(interruptible(signals_)());
}

TEST_F(Interrupt, AnIgnoredSignalStaysIgnored) {
  release();
  std::signal(SIGINT, SIG_IGN);
  signals_ = hold_interrupts();
  std::raise(SIGINT);
  EXPECT_NO_THROW(interruptible(signals_)());
  std::signal(SIGINT, SIG_DFL);
}

TEST_F(Interrupt, AProofAndItsCheckEndBetweenBoxes) {
  const TemporaryDirectory directory;
  const std::string file = directory / "pair.json";
  ASSERT_EQ(run_command_line({"certify", "fresnel-quadratic", "--out", file}).exit_code, 0);
  for (const int n : {1, 20}) {
    EXPECT_EQ(run_command_line({"verify", file}, raising(SIGTERM, n)).exit_code, 128 + SIGTERM) << n;
    EXPECT_EQ(run_command_line({"certify", "fresnel-quadratic"}, raising(SIGINT, n)).exit_code, 128 + SIGINT)
        << n;
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
  // that seven forms meet, each with more than one box of its proofs, and the writing.
  const int plain_calls = count(plain);
  EXPECT_GT(plain_calls, 3 + 1 + 1 + 3 + 2 * 7 * 2 + 1);
  std::filesystem::remove_all(directory / "out");
  directory.file("out/report.md", "# shadefit report\n\nan older one\n");
  const auto before = snapshot(directory.path());
  for (const auto& run : {plain, with_plots}) {
    // The number of checkpoints while gnuplot works is not known, so the test goes on until a run ends. Some
    // boxes of the proofs are enough, because all are similar. The last checkpoints, where files are written,
    // are all tried, except under the sanitizers, where a run takes seconds.
#ifdef SHADEFIT_SANITIZE
    constexpr int last_step = 3;
#else
    constexpr int last_step = 1;
#endif
    constexpr int tried = 30, last = 20;
    for (int n = 1;; n += n < plain_calls - last ? plain_calls / tried : last_step) {
      const int signal = n % 2 == 0 ? SIGINT : SIGTERM;
      const Outcome outcome = run_command_line(run, raising(signal, n));
      if (outcome.exit_code == 0) {
        EXPECT_GT(n, plain_calls);
        std::filesystem::remove_all(directory / "out");
        directory.file("out/report.md", "# shadefit report\n\nan older one\n");
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
       {std::vector<std::string>{"fit", "sg-offset", "--exponent", "1:5000:1"},
        {"check", "--baseline", SHADEFIT_SOURCE_DIR "/reports/baseline"}}) {
    const Outcome outcome = run_command_line(arguments, raising(SIGINT, 5));
    EXPECT_EQ(outcome.exit_code, 130) << arguments.front();
    EXPECT_EQ(outcome.out, "");
  }
}

// A proof may take seconds: it has a checkpoint at each of its boxes.
TEST_F(Interrupt, AProofEndsAtItsBoxes) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"certify", "fresnel-quadratic"},
                                                    {"emit", "fresnel-quadratic", "--lang", "c"},
                                                    {"better", "sg-offset", "--exponent", "5"},
                                                    {"fit", "acos-linear", "--certify"},
                                                    {"fit", "fresnel-quadratic", "--round", "float"}}) {
    // Only boxes can give this many checkpoints: families, fits and settings are fewer.
    const Outcome outcome = run_command_line(arguments, raising(SIGTERM, 20));
    EXPECT_EQ(outcome.exit_code, 143) << arguments.front();
    EXPECT_EQ(outcome.out, "") << arguments.front();
  }
}

/// A pipe without a reader.
struct UnreadPipe {
  std::array<int, 2> ends{};
  UnreadPipe() { EXPECT_EQ(::pipe(ends.data()), 0); }
  ~UnreadPipe() {
    for (const int end : ends) ::close(end);
  }
};

TEST_F(Interrupt, PrintingEndsHoweverLongTheReaderWaits) {
  const UnreadPipe pipe;
  const auto whole = print(pipe.ends[1], "a line\n", signals_);
  EXPECT_EQ(whole.signal, 0);
  EXPECT_EQ(whole.error, 0);
  std::raise(SIGTERM);
  EXPECT_EQ(print(pipe.ends[1], "another\n", signals_).signal, SIGTERM) << "one that waits";
  EXPECT_NO_THROW(interruptible(signals_)()) << "it is taken";
  // More than any pipe holds; the signal comes from another thread, once or never, while nobody reads.
  const std::string long_text(std::size_t{1} << 22, 'x');
  std::thread other([thread = ::pthread_self(), &pipe] {
    pollfd full{pipe.ends[1], POLLOUT, 0};
    while (::poll(&full, 1, 0) > 0) std::this_thread::yield();
    ::pthread_kill(thread, SIGINT);
  });
  EXPECT_EQ(print(pipe.ends[1], long_text, signals_).signal, SIGINT);
  other.join();
}

TEST_F(Interrupt, PrintingTellsWhatTheSystemSays) {
  const int full = ::open("/dev/full", O_WRONLY);
  EXPECT_EQ(print(full, "a line\n", signals_).error, ENOSPC);
  ::close(full);
  // The number of a closed stream would go to the next descriptor that is opened: this one never is.
  constexpr int never_opened = 1 << 20;
  EXPECT_EQ(print(never_opened, "a line\n", signals_).error, EBADF);
}

}  // namespace
}  // namespace shadefit
