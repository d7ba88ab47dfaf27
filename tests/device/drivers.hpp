#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <ostream>
#include <utility>

#include "tests/fake_gnuplot.hpp"

/// The drivers that need no GPU, for tests.
namespace shadefit::testing {

struct Driver {
  const char* name;
  const char* file;  ///< by which the Vulkan loader finds it
  const char* package;
};

inline std::ostream& operator<<(std::ostream& out, const Driver& driver) {
  return out << driver.name;
}

inline constexpr std::array drivers{
    Driver{"lavapipe", "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json", "mesa-vulkan-drivers"},
    Driver{"SwiftShader", "/usr/lib/chromium/vk_swiftshader_icd.json", "chromium"},
};

/// A test on one of them, with the validation layer; skipped where one of both is missing.
class OnDriver : public ::testing::TestWithParam<Driver> {
 protected:
  void SetUp() override {
    constexpr const char* layer = "/usr/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json";
    for (const auto& [file, package] :
         {std::pair{GetParam().file, GetParam().package}, {layer, "vulkan-validationlayers"}})
      if (!std::filesystem::exists(file)) GTEST_SKIP() << "without " << file << ": package " << package;
  }

 private:
  EnvironmentVariable driver_{"VK_ICD_FILENAMES", GetParam().file};
  EnvironmentVariable layer_{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"};
};

}  // namespace shadefit::testing
