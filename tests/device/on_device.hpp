#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
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

/// What needs a driver: run once for each (tests/CMakeLists.txt), with the validation layer.
namespace shadefit::device {

inline constexpr std::array languages{ShaderLanguage::glsl, ShaderLanguage::hlsl};

inline const char* name_of(ShaderLanguage language) {
  return language == ShaderLanguage::glsl ? "GLSL" : "HLSL";
}

inline constexpr DeviceChoice watched{.words = 3 * drawn_count, .is_watched = true};

/// The places of the digits of a number, from its first digit that is not 0. Of a zero: the last digit.
inline std::vector<std::size_t> digits_of(const std::string& printed) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const bool is_digit = printed[i] >= '0' && printed[i] <= '9';
    if (is_digit && !(places.empty() && printed[i] == '0')) places.push_back(i);
  }
  if (places.empty()) places.push_back(printed.find_last_of('0'));
  return places;
}

class Device : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      if (vulkan_devices().empty())
        GTEST_SKIP() << "no device can compute: packages mesa-vulkan-drivers, chromium";
      vulkan_.emplace(watched);
    } catch (const UserError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  void TearDown() override {
    if (!vulkan_) return;
    for (const std::string& message : vulkan_->messages()) ADD_FAILURE() << "validation layer: " << message;
  }
  VulkanDevice& vulkan() { return *vulkan_; }

  /// The results of a function, in a language, that leave the bounds of another: how many, and the first of
  /// them; empty if there is none.
  std::string beyond(const ShaderFunction& run, ShaderLanguage language, const DrawnInputs& drawn,
                     std::span<const double> values, std::span<const double> bounds) {
    Evaluator evaluator(vulkan(), compiler_, run, language, Arguments::input);
    const auto results = evaluator.of_input(drawn.arguments);
    std::size_t count = 0;
    std::string first;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const auto result = std::bit_cast<float>(results[i]);
      const double bound = bounds[drawn.box_of[i]];
      if (is_within(result, values[i], bound) || count++ > 0) continue;
      first = fmt::format(" of {}: {} instead of {}, bound {}, at", results.size(), result, values[i], bound);
      for (std::size_t k = 0; k < run.arguments.size(); ++k)
        first += fmt::format(" {}", drawn.arguments[i * run.arguments.size() + k]);
    }
    return count == 0 ? "" : fmt::format("{}{}", count, first);
  }

 private:
  std::optional<VulkanDevice> vulkan_;
  ShaderCompiler compiler_;
};

}  // namespace shadefit::device
