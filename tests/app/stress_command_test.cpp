#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "fit/support/user_error.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/files.hpp"
#include "reports/rows/stress_tables.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::TemporaryDirectory;

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
  const std::filesystem::path folder = SHADEFIT_SOURCE_DIR "/reports/baseline/slow";
  EXPECT_NE(read_file(folder / forms_stress_file), "");
  EXPECT_NE(read_file(folder / fits_stress_file), "");
}

}  // namespace
}  // namespace shadefit
