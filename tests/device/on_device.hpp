#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/device/evaluator.hpp"
#include "bench/device/spirv.hpp"
#include "bench/device/vulkan_device.hpp"
#include "fit/support/user_error.hpp"
#include "tests/device/drawn_inputs.hpp"
#include "tests/fake_gnuplot.hpp"

/// What needs a driver: run once for each (tests/CMakeLists.txt), with the validation layer.
namespace shadefit::device {

inline constexpr std::array languages{Language::glsl, Language::hlsl};

class Device : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      if (vulkan_devices().empty())
        GTEST_SKIP() << "no device can compute: packages mesa-vulkan-drivers, chromium";
      vulkan_.emplace(DeviceChoice{.words = 3 * drawn_count});
    } catch (const UserError& error) {
      GTEST_SKIP() << error.what() << ": packages mesa-vulkan-drivers, chromium";
    }
  }
  VulkanDevice& vulkan() { return *vulkan_; }

  /// The results of a function, in a language, that leave the bounds of another: how many, and the first of
  /// them; empty if there is none.
  std::string beyond(const ShaderFunction& run, Language language, const DrawnInputs& drawn,
                     std::span<const double> values, std::span<const double> bounds) {
    Evaluator evaluator(vulkan(), compiler_, run, ShaderPrecision::float32, language);
    const auto results = evaluator.of(drawn.arguments);
    std::size_t count = 0;
    std::string first;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const double bound = bounds[drawn.box_of[i]];
      if (std::abs(static_cast<double>(results[i]) - values[i]) <= bound || count++ > 0) continue;
      first =
          fmt::format(" of {}: {} instead of {}, bound {}, at", results.size(), results[i], values[i], bound);
      for (std::size_t k = 0; k < run.arguments.size(); ++k)
        first += fmt::format(" {}", drawn.arguments[i * run.arguments.size() + k]);
    }
    return count == 0 ? "" : fmt::format("{}{}", count, first);
  }

 protected:
  ShaderCompiler compiler_;

 private:
  testing::EnvironmentVariable layer_{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"};
  std::optional<VulkanDevice> vulkan_;
};

}  // namespace shadefit::device
