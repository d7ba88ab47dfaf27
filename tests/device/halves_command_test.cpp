#include <gtest/gtest.h>

#include <string>

#include "app/commands/command_line.hpp"
#include "bench/device/vulkan_device.hpp"
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
  const device::DeviceInfo device = device::vulkan_devices().front();
  if (!device.has_half) return;
  const Outcome outcome = run_command_line(
      {"bench", "--exhaustive", "schlick", "--half", "--device", "vulkan", "--out", directory / "out"},
      keep_going);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(
      outcome.out.starts_with("on " + name_with_driver(device) + "\nform     constants  halves  max abs "))
      << outcome.out;
  EXPECT_NE(outcome.out.find("\nschlick  none        15361  "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nulps    halves    share\n0 "), std::string::npos) << outcome.out;
  EXPECT_TRUE(snapshot(directory.path()).empty());
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
