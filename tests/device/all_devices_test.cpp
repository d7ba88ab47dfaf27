#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/commands/command_line.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/device/drivers.hpp"
#include "tests/temporary_directory.hpp"

/// `bench --exhaustive all` on several devices at once.
namespace shadefit::testing {
namespace {

/// Some floats of a form, and the number of floats.
constexpr const char* few = "0x3f000000:0x3f000400";
constexpr std::uint64_t count = 0x400;

bench::FloatErrors found_in(const std::filesystem::path& directory) {
  return bench::read_state(directory / "exhaustive-schlick-vulkan.json").sweep.found;
}

// A form without a function of the device needs no measurement of it, so that alone it takes no time.
TEST(AllDevices, HaveTheErrorsOfEachAlone) {
  for (const Driver& driver : drivers)
    if (!std::filesystem::exists(driver.file)) GTEST_SKIP() << "without " << driver.file << ": package " << driver.package;
  const EnvironmentVariable both{"VK_ICD_FILENAMES", std::string(drivers[0].file) + ":" + drivers[1].file};
  const TemporaryDirectory directory;
  const Outcome all = run_command_line(
      {"bench", "--exhaustive", "all", "--range", few, "--all-devices", "--out", directory / "all"},
      keep_going);
  ASSERT_EQ(all.exit_code, 0) << all.err;
  const auto devices = device::vulkan_devices();
  ASSERT_EQ(devices.size(), drivers.size());
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const std::string place = "vulkan-" + std::to_string(i);
    const auto of_all = directory.path() / "all" / place, alone = directory.path() / place;
    const Outcome one = run_command_line({"bench", "--exhaustive", "schlick", "--range", few, "--device",
                                          "vulkan:" + std::to_string(i), "--out", alone.string()},
                                         keep_going);
    ASSERT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(found_in(of_all).count(), count);
    EXPECT_EQ(found_in(of_all), found_in(alone)) << devices[i].name;
    const CsvTable rows = parse_csv(read_file(of_all / "errors.csv"), "errors.csv");
    EXPECT_GT(rows.rows.size(), 60U);
    for (const auto& row : rows.rows) EXPECT_EQ(row.back(), name_with_driver(devices[i]));
    EXPECT_NE(all.out.find("on " + name_with_driver(devices[i])), std::string::npos) << all.out;
  }
}

}  // namespace
}  // namespace shadefit::testing
