#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/commands/command_line.hpp"
#include "app/output/interrupt.hpp"
#include "app/output/progress.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::run_process;
using testing::snapshot;
using testing::TemporaryDirectory;

/// A sweep of few floats: 3000 around 1/2.
constexpr const char* few = "0x3efff000:0x3f000000";

Outcome bench(std::vector<std::string> arguments, const Checkpoint& checkpoint = keep_going) {
  arguments.insert(arguments.begin(), "bench");
  return run_command_line(arguments, checkpoint);
}

std::string refusal(const std::vector<std::string>& arguments) {
  const Outcome outcome = bench(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out.substr(0, 200);
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

// One target takes a second.
TEST(BenchCommand, WritesTimesReportAndPictureData) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  const Outcome outcome = bench({"--quick", "--no-plots", "--only", "schlick", "--out", out});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto files = snapshot(out);
  EXPECT_TRUE(files.contains("bench.md"));
  ASSERT_TRUE(files.contains("bench.csv"));
  EXPECT_FALSE(files.contains("plots"));
  const CsvTable csv = parse_csv(files.at("bench.csv"), "bench.csv");
  EXPECT_GT(csv.rows.size(), 100U);
  std::set<std::string> targets, degrees;
  for (const auto& row : csv.rows) {
    targets.insert(row[0]);
    degrees.insert(row[3]);
    EXPECT_GT(std::stod(row[5]), 0) << "a time of " << row[1];
    if (!row[0].empty()) {  // not a floor
      EXPECT_NE(row[7], "") << "error of " << row[1];
      EXPECT_NE(row[8], "") << "multiply-adds of " << row[1];
    }
  }
  EXPECT_EQ(targets, (std::set<std::string>{"", "schlick"}));
  EXPECT_EQ(degrees, (std::set<std::string>{"0", "2", "3", "4", "5", "6"}));
}

// The C compiler of this machine compiles the code that `emit` writes.
TEST(BenchCommand, TimesTheFormsOfAStudy) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  const Outcome outcome = bench({"hg-schlick", "--quick", "--out", out});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("hg(c, g), c in -1:1, g = 0.6"), std::string::npos) << outcome.out;
  const auto files = snapshot(out);
  ASSERT_TRUE(files.contains("bench.md"));
  ASSERT_TRUE(files.contains("bench.csv"));
  const CsvTable csv = parse_csv(files.at("bench.csv"), "bench.csv");
  std::set<std::string> targets, constants;
  for (const auto& row : csv.rows) {
    targets.insert(row[0]);
    constants.insert(row[2]);
    EXPECT_GT(std::stod(row[5]), 0) << "a time of " << row[1];
  }
  EXPECT_EQ(targets, (std::set<std::string>{"", "hg-schlick-1", "hg-schlick-2", "hg-schlick-3"}));
  EXPECT_TRUE(constants.contains("minimax"));
}

TEST(BenchCommand, RefusesStudiesWithoutCode) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out", file = directory / "own.toml";
  EXPECT_NE(refusal({"acos-linear", "--only", "schlick", "--out", out}).find("--only"), std::string::npos);
  EXPECT_NE(refusal({"acos-linar", "--out", out}).find("did you mean 'acos-linear'"), std::string::npos);
  std::ofstream(file) << "schema = 1\nid = \"own\"\n[over]\nx = \"0:1\"\n[target]\nformula = \"exp(x)\"\n"
                         "[[form]]\nid = \"sum\"\nformula = \"a + integral(exp(t), t, 0, x)\"\n";
  EXPECT_EQ(refusal({file, "--out", out}),
            "shadefit: bench has no code in c for the form 'a + integral(exp(t), t, 0, x)'\n");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(BenchCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(refusal({"--only", "schlik"}), "shadefit: unknown target 'schlik': did you mean 'schlick'?\n");
  EXPECT_EQ(
      refusal({"--device", "cuda"}),
      "shadefit: --device 'cuda' is not a device: it must be vulkan or vulkan:N, see 'shadefit bench --list-devices'\n");
  EXPECT_TRUE(refusal({"--only", "phong-64"}).starts_with("shadefit: unknown target 'phong-64'"))
      << "sums of several lights are not timed, phong-1 is one light";
}

TEST(ExhaustiveCommand, RefusesWhatItDoesNotKnow) {
  const TemporaryDirectory directory;
  const auto refused = [&](std::vector<std::string> arguments) {
    for (const char* more : {"--out", ""}) arguments.push_back(*more != '\0' ? more : directory / "out");
    return refusal(arguments);
  };
  EXPECT_EQ(refused({"--exhaustive", "schlik"}),
            "shadefit: unknown form of one cosine 'schlik': did you mean 'schlick'?\n");
  EXPECT_EQ(refused({"--exhaustive", "phong-sg"}),
            "shadefit: --exhaustive 'phong-sg' is not a form of one cosine: it reads a normal of each element"
            " (see 'shadefit help bench')\n");
  EXPECT_EQ(
      refused({"--exhaustive", "gloss-sg"}),
      "shadefit: --exhaustive 'gloss-sg' is not a form of one cosine: it reads a gloss too of each element"
      " (see 'shadefit help bench')\n");
  EXPECT_EQ(refused({"--exhaustive", "fresnel-fourth", "--constants", "mine"}).substr(0, 63),
            "shadefit: --constants 'mine' is not a set of fresnel-fourth: it");
  EXPECT_EQ(refused({"--exhaustive", "schlick", "--quick"}),
            "shadefit: --exhaustive excludes --quick (see 'shadefit help bench')\n");
  for (const char* range : {"1:1", "0:0x3f800002", "a:b", "5", "2:1"}) {
    EXPECT_EQ(
        refused({"--exhaustive", "schlick", "--range", range}),
        "shadefit: --range '" + std::string(range) +
            "' is not a range of bit patterns: it must be A:B with 0 <= A < B <= 0x3f800001 (see 'shadefit help bench')\n");
  }
  EXPECT_TRUE(snapshot(directory.path()).empty()) << "nothing was written";
}

TEST(ExhaustiveCommand, AllIsEachFormWithEachSet) {
  const TemporaryDirectory directory;
  ASSERT_EQ(bench({"--exhaustive", "all", "--range", few, "--out", directory / "all"}).exit_code, 0);
  const CsvTable rows = parse_csv(read_file(directory / "all/errors.csv"), "errors.csv");
  EXPECT_GT(rows.rows.size(), 60U);
  const std::vector<std::vector<std::string>> each{
      {"schlick"}, {"fresnel-quadratic", "--constants", "minimax-absolute"}, {"hg-pow"}};
  for (std::vector<std::string> form : each) {
    form.insert(form.begin(), {"--range", few, "--exhaustive"});
    const Outcome alone = bench(form);
    EXPECT_EQ(alone.exit_code, 0) << alone.err;
    const auto row = std::ranges::find_if(rows.rows, [&](const auto& of_all) {
      return of_all[0] == form[3] && (form.size() < 6 || of_all[1] == form[5]);
    });
    ASSERT_NE(row, rows.rows.end());
    EXPECT_NE(alone.out.find("  " + (*row)[3] + "  " + (*row)[4] + "  "), std::string::npos) << alone.out;
    EXPECT_NE(alone.out.find("\nulps "), std::string::npos) << alone.out;
  }
  EXPECT_EQ(bench({"--exhaustive", "all", "--constants", "mine", "--out", directory / "all"}).err,
            "shadefit: --exhaustive 'all' does not apply with --constants: it takes every set of every form"
            " (see 'shadefit help bench')\n");
}

TEST(ExhaustiveCommand, ASignalEndsTheProcessAndNothingIsWritten) {
  const TemporaryDirectory directory;
  const std::vector<std::vector<std::string>> commands{
      {"bench", "--exhaustive", "all", "--out", directory / "out"},
      {"bench", "--quick", "--out", directory / "out"},
      {"stress", "--out", directory / "out"}};
  for (const auto& command : commands) {
    const auto finished = run_process(command, [] { testing::leave_pending(SIGINT, SIG_DFL); });
    EXPECT_EQ(finished.exit_code, 130);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err, "shadefit: interrupted, nothing was written\n");
    EXPECT_FALSE(std::filesystem::exists(directory / "out"));
  }
}

TEST(Progress, ALineHasAPercentageAndWhatIsLeft) {
  EXPECT_EQ(progress_line("bench", 0, 0), "bench 0 %");
  EXPECT_EQ(progress_line("bench", 0.5, 7), "bench 50 %, 7 s left");
  EXPECT_EQ(progress_line("bench", 1, 7), "bench 100 %, 0 s left");
  EXPECT_EQ(progress_line("bench", 0.999, 1), "bench 99 %, 1 s left") << "100 % is the whole";
}

TEST(Progress, IsSilentWhereThereIsNoTerminal) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const Progress progress = terminal_progress(pipe[1]);
  progress("something");
  progress("");
  ::close(pipe[1]);
  EXPECT_EQ(testing::read_all(pipe[0]), "");
}

}  // namespace
}  // namespace shadefit
