#include "tests/process.hpp"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "reports/io/files.hpp"
#include "tests/fake_gnuplot.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::run_process;
using testing::snapshot;
using testing::TemporaryDirectory;

/// The snapshot without directories.
std::map<std::string, std::string> files_in(const std::filesystem::path& directory) {
  auto files = snapshot(directory);
  std::erase_if(files, [](const auto& entry) { return entry.second == "/"; });
  return files;
}

TEST(Process, AFullDiskLeavesOldFilesAndNothingHalfWritten) {
  const TemporaryDirectory directory;
  directory.file("out/report.md", "# shadefit report\n\nold\n");
  directory.file("out/mine", "of the user\n");
  const auto before = files_in(directory.path());
  // Both kinds of directories: an existing and a new one.
  for (const std::string out : {"out", "new/er"}) {
    const auto finished =
        run_process({"run", "--only", "fresnel-one-term", "--no-plots", "--out", directory / out},
                    [] { testing::limit_file_size(1024); });
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_EQ(finished.err, "shadefit: cannot write '" + (directory / out) + "/report.md': File too large\n");
    EXPECT_EQ(files_in(directory.path()), before);

    // Plots are drawn in another place first, which is full too.
    const auto with_plots = run_process({"run", "--only", "fresnel-one-term", "--out", directory / out},
                                        [] { testing::limit_file_size(1024); });
    EXPECT_EQ(with_plots.exit_code, 2);
    EXPECT_EQ(with_plots.out, "");
    EXPECT_TRUE(with_plots.err.starts_with("shadefit: cannot write '")) << with_plots.err;
    EXPECT_TRUE(with_plots.err.ends_with("': File too large\n")) << with_plots.err;
    EXPECT_EQ(files_in(directory.path()), before);
  }
}

TEST(Process, StandardOutputThatCannotBeWritten) {
  const TemporaryDirectory directory;
  const auto to_a_full_disk = run_process({"list"}, [&] {
    testing::limit_file_size(1024);
    testing::send_output_to(directory / "list");
  });
  EXPECT_EQ(to_a_full_disk.exit_code, 2);
  EXPECT_EQ(to_a_full_disk.err, "shadefit: cannot write standard output: File too large\n");
}

TEST(Process, AnInterruptionEndsARunWithNothingWritten) {
  const TemporaryDirectory directory;
  directory.file("out/report.md", "# shadefit report\n\nold\n");
  const auto before = snapshot(directory.path());
  for (const auto& [signal, exit_code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    const auto finished = run_process({"run", "--out", directory / "out"},
                                      [number = signal] { testing::leave_pending(number, SIG_DFL); });
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err, "shadefit: interrupted, nothing was written\n");
    EXPECT_EQ(snapshot(directory.path()), before);
  }
}

// A signal after the last checkpoint, or in a command without one: only the output is left.
TEST(Process, AnInterruptionOfThePrintingIsTold) {
  for (const auto& [signal, exit_code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    const auto finished =
        run_process({"list"}, [number = signal] { testing::leave_pending(number, SIG_DFL); });
    EXPECT_EQ(finished.exit_code, exit_code) << "-1 is a death by the signal";
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err, "shadefit: interrupted while printing, no file was written\n");
  }
}

#ifndef SHADEFIT_SANITIZE  // which takes address space of its own
TEST(Process, LintNeedsASmallStack) {
  const TemporaryDirectory directory;
  std::string deep;
  for (int i = 0; i < 90; ++i) deep += " - sqrt(1.0";
  for (int i = 0; i < 100; ++i)
    directory.file(std::to_string(i) + ".glsl",
                   "float f(float c) { return exp2((-5.55473*c + 6.98316)*c); }\n"
                   "float g(float c) { return -5.55473*c - 6.98316" +
                       deep + std::string(90, ')') + "; }\n");
  const auto finished = run_process({"lint", directory.path().string()}, [] {
    const rlimit limit{256U << 10, 256U << 10};
    ::setrlimit(RLIMIT_STACK, &limit);
  });
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_NE(finished.out.find("lint failed: 100 errors"), std::string::npos) << finished.out;
}

// A text is shortened before it is escaped, because escaping takes at least 32 bytes per byte.
TEST(Process, ALongCellOfABaselineTakesLittleMemory) {
  const TemporaryDirectory directory;
  std::filesystem::copy(SHADEFIT_SOURCE_DIR "/reports/baseline", directory / "baseline");
  // A file that is too large for a table is refused by its size.
  constexpr std::size_t size = 3U << 20;
  const std::string claims = directory.file("baseline/claims.csv", std::string(size, 'a') + "\n");
  const auto finished = run_process({"check", "--baseline", directory / "baseline"}, [] {
    const rlimit limit{160U << 20, 160U << 20};
    ::setrlimit(RLIMIT_AS, &limit);
  });
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_TRUE(finished.err.starts_with("shadefit: '" + claims + "' ")) << finished.err;
  EXPECT_LT(finished.err.size(), 2000U);
}
#endif

// The signal comes while gnuplot hangs, and to the command alone; once or, as two plots are drawn at a time,
// again while the command is ending.
TEST(Process, AnInterruptionEndsARunWhoseGnuplotHangs) {
  const TemporaryDirectory directory;
  directory.file("out/report.md", "# shadefit report\n\nold\n");
  std::filesystem::create_directories(directory / "temporary");
  const testing::EnvironmentVariable temporary("TMPDIR", directory / "temporary");
  const testing::EnvironmentVariable path("PATH", (directory / "bin") + ":" + std::getenv("PATH"));
  for (const auto& [signal, exit_code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    testing::fake_gnuplot(directory, "kill -" + std::to_string(signal) + " $PPID; exec sleep 1000");
    const auto before = snapshot(directory.path());
    const auto finished = run_process({"run", "--out", directory / "out", "--only", "fresnel-quadratic"},
                                      [number = signal] { std::signal(number, SIG_DFL); });
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err, "shadefit: interrupted, nothing was written\n");
    EXPECT_EQ(snapshot(directory.path()), before) << "nothing among the temporary files either";
  }
}

TEST(Process, TemporaryFilesThatHaveNoDirectory) {
  const TemporaryDirectory directory;
  testing::fake_gnuplot(directory, "exit 1");
  const testing::EnvironmentVariable path("PATH", directory / "bin");
  const auto before = snapshot(directory.path());
  const std::string none = directory / "none";
  const auto finished = run_process({"run", "--out", directory / "out", "--only", "fresnel-quadratic"},
                                    [&] { ::setenv("TMPDIR", none.c_str(), 1); });
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err,
            "shadefit: TMPDIR names no directory for temporary files: No such file or directory\n");
  EXPECT_EQ(snapshot(directory.path()), before);
}

TEST(Process, AWorkingDirectoryThatIsGone) {
  const TemporaryDirectory directory;
  const std::string gone = directory / "gone";
  const auto leave = [&] {
    std::filesystem::create_directories(gone);
    std::filesystem::current_path(gone);
    std::filesystem::remove(gone);
  };
  const std::vector<std::string> run{"run", "--only", "norm-lambert", "--no-plots", "--out"};
  auto relative = run, absolute = run;
  relative.emplace_back("y");
  absolute.push_back(directory / "y");
  const auto refused = run_process(relative, leave);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err, "shadefit: cannot create directory 'y': No such file or directory\n");
  EXPECT_EQ(run_process(absolute, leave).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(directory / "y/report.md"));
}

// As a script starts a background process: Ctrl-C does not concern it.
TEST(Process, AnIgnoredInterruptionDoesNot) {
  const TemporaryDirectory directory;
  const auto finished = run_process({"run", "--out", directory / "out", "--only", "norm-lambert"},
                                    [] { testing::leave_pending(SIGINT, SIG_IGN); });
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(std::filesystem::exists(directory / "out/report.md"));
}

}  // namespace
}  // namespace shadefit
