#include <gtest/gtest.h>

#include <stdio.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/output/interrupt.hpp"
#include "app/output/progress.hpp"
#include "app/output/slow_tables.hpp"
#include "fit/support/user_error.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/rows/stress_tables.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::TemporaryDirectory;

void expect_refusal(const std::vector<std::string>& arguments, const std::string& part) {
  const Outcome outcome = run_command_line(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << part;
  EXPECT_EQ(outcome.out, "") << part;
  EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

TEST(StressCommand, RefusesBadUsage) {
  expect_refusal({"stress", "--out"}, "--out");
  expect_refusal({"stress", "lobe"}, "unexpected argument 'lobe'");
  expect_refusal({"stress", "--out", "--quick"}, "--out '--quick' looks like an option");
  const TemporaryDirectory directory;
  directory.file("taken", "");
  expect_refusal({"stress", "--out", (directory.path() / "taken").string()}, "taken");
}

// If it is interrupted, it writes nothing.
TEST(StressCommand, StopsAtACheckpointAndWritesNothing) {
  const TemporaryDirectory directory;
  int calls = 0;
  const Checkpoint stop = [&] {
    if (++calls == 3) throw Interrupted{SIGINT};
  };
  const std::string out = (directory.path() / "out").string();
  EXPECT_EQ(run_command_line({"stress", "--out", out}, stop).exit_code, 128 + SIGINT);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(StressCommand, IsSilentWhereStandardErrorIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  terminal_progress(fileno(file))("stress: lobe");
  EXPECT_EQ(std::fseek(file, 0, SEEK_END), 0);
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

// The committed tables are compared as any other: `check --all` lists what differs.
TEST(SlowTables, AreComparedCellByCell) {
  const TemporaryDirectory directory;
  const std::string header = "topic,name,format,worst_ulps\n";
  directory.file("stress.csv", header + "lobe,power_lobe,half,2^24\n");
  const auto compare_with = [&](const std::string& rows) {
    return compare_files(read_tables(directory.path(), {"stress.csv"}), {{"stress.csv", header + rows}})
        .drifts;
  };
  EXPECT_TRUE(compare_with("lobe,power_lobe,half,2^24\n").empty());
  const auto drifts = compare_with("lobe,power_lobe,half,2^25\n");
  ASSERT_EQ(drifts.size(), 1U);
  EXPECT_EQ(drifts[0].row, "lobe power_lobe half");
  EXPECT_EQ(drifts[0].column, "worst_ulps");
  EXPECT_EQ(compare_with("").size(), 1U) << "a row that is gone";
  EXPECT_EQ(compare_with("lobe,power_lobe,half,2^24\nlobe,power_lobe,float,2^3\n").size(), 1U) << "a new row";
  EXPECT_THROW(read_tables(directory.path(), {"other.csv"}), UserError) << "a file that is missing";
  EXPECT_THROW(compare_files(read_tables(directory.path(), {"stress.csv"}), {{"stress.csv", "topic,name\n"}}),
               UserError)
      << "other columns";
}

TEST(SlowTables, StandInTheirFolderOfTheBaseline) {
  const std::filesystem::path folder =
      std::filesystem::path(SHADEFIT_SOURCE_DIR "/reports/baseline") / slow_tables_folder;
  EXPECT_NE(read_file(folder / forms_stress_file), "");
  EXPECT_NE(read_file(folder / fits_stress_file), "");
}

}  // namespace
}  // namespace shadefit
