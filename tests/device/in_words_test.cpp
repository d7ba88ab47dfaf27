#include "bench/device/in_words.hpp"

#include <gtest/gtest.h>

#include <string>

namespace shadefit::device {
namespace {

/// What a command says when Vulkan throws this. It ends with exit code 1, as for every CheckFailed.
template <class Error>
std::string said_of(const Error& error) {
  try {
    in_words([&]() -> int { throw error; });
  } catch (const CheckFailed& failed) {
    return failed.what();
  }
  return "";
}

TEST(InWords, SaysInOneLineWhatADriverThrows) {
  EXPECT_EQ(said_of(vk::DeviceLostError("vkQueueSubmit")), "the Vulkan device was lost");
  EXPECT_EQ(said_of(vk::OutOfDeviceMemoryError("vkAllocateMemory")), "the Vulkan device is out of memory");
  EXPECT_EQ(said_of(vk::OutOfHostMemoryError("vkCreateDevice")), "the Vulkan driver is out of memory");
  const std::string other = said_of(vk::FeatureNotPresentError("vkCreateDevice"));
  EXPECT_NE(other.find("the Vulkan driver fails: vkCreateDevice"), std::string::npos) << other;
  EXPECT_EQ(other.find('\n'), std::string::npos);
  EXPECT_EQ(in_words([] { return 3; }), 3);
}

}  // namespace
}  // namespace shadefit::device
