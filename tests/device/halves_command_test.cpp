#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "app/commands/command_line.hpp"
#include "bench/device/vulkan_device.hpp"
#include "reports/io/csv.hpp"
#include "tests/device/drivers.hpp"
#include "tests/temporary_directory.hpp"

/// `bench --exhaustive FORM --half`.
namespace shadefit::testing {
namespace {

class HalvesOnDriver : public OnDriver {};

INSTANTIATE_TEST_SUITE_P(Drivers, HalvesOnDriver, ::testing::ValuesIn(drivers),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(HalvesOnDriver, OneFormHasARowAndAHistogram) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  const Outcome outcome = run_command_line(
      {"bench", "--exhaustive", "schlick", "--half", "--device", "vulkan", "--out", out}, keep_going);
  const device::DeviceInfo device = device::vulkan_devices().front();
  if (!device.has_half) {
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "shadefit: device '" + device.name + "' has no arithmetic in half\n");
    EXPECT_TRUE(snapshot(directory.path()).empty());
    return;
  }
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const CsvTable csv = parse_csv(snapshot(out).at("errors-half.csv"), "errors-half.csv");
  EXPECT_EQ(csv.columns,
            (std::vector<std::string>{"form", "constants", "halves", "max abs error", "at c", "max ulps",
                                      "at c ", "NaN", "beyond", "without bound", "device"}));
  ASSERT_EQ(csv.rows.size(), 1U);
  EXPECT_EQ(csv.rows.front().front(), "schlick");
  EXPECT_EQ(csv.rows.front().at(2), "15361");
  EXPECT_EQ(csv.rows.front().back(), name_with_driver(device));
  EXPECT_NE(outcome.out.find("\nulps    halves    share\n0 "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Result: " + out + "/errors-half.csv"), std::string::npos) << outcome.out;
}

TEST_P(HalvesOnDriver, ADeviceWithoutHalfIsRefused) {
  const device::DeviceInfo device = device::vulkan_devices().front();
  if (device.has_half) {
    EXPECT_EQ(std::string(GetParam().name), "lavapipe") << "no other driver here has half";
    return;
  }
  const TemporaryDirectory directory;
  const Outcome outcome = run_command_line(
      {"bench", "--exhaustive", "all", "--half", "--device", "vulkan", "--out", directory / "out"},
      keep_going);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "shadefit: device '" + device.name + "' has no arithmetic in half\n");
  EXPECT_TRUE(snapshot(directory.path()).empty());
}

}  // namespace
}  // namespace shadefit::testing
