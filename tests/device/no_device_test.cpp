#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

/// The command where there is no graphics device, or no Vulkan at all.
namespace shadefit::testing {
namespace {

// With a driver that does not exist, with no Vulkan loader, and in a build without Vulkan alike.
TEST(NoDevice, IsOneLineAndNothingIsWritten) {
  const TemporaryDirectory directory;
  const std::vector<std::vector<std::string>> commands{
      {"bench", "--list-devices"},
      {"bench", "--device", "vulkan", "--quick", "--out", directory.path().string()},
      {"bench", "--exhaustive", "schlick", "--device", "vulkan", "--out", directory.path().string()}};
  for (const auto& command : commands) {
    const Finished finished =
        run_process(command, [] { ::setenv("VK_ICD_FILENAMES", "/there/is/no/driver.json", 1); });
    EXPECT_EQ(finished.exit_code, 2) << command[1];
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    EXPECT_TRUE(finished.err.starts_with("shadefit: ")) << finished.err;
#ifndef SHADEFIT_DEVICE
    EXPECT_NE(finished.err.find("is not in this build: install libvulkan-dev"), std::string::npos)
        << finished.err;
#endif
  }
  EXPECT_TRUE(snapshot(directory.path()).empty());
}

}  // namespace
}  // namespace shadefit::testing
