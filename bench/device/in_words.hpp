#pragma once

#include <fmt/format.h>

#include <vulkan/vulkan.hpp>

#include "fit/support/user_error.hpp"

/// The errors of Vulkan as messages of one line.
namespace shadefit::device {

/// Calls a function. An error of Vulkan becomes a CheckFailed with one line.
template <class F>
auto in_words(const F& function) -> decltype(function()) {
  try {
    return function();
  } catch (const vk::DeviceLostError&) {
    throw CheckFailed("the Vulkan device was lost");
  } catch (const vk::OutOfDeviceMemoryError&) {
    throw CheckFailed("the Vulkan device is out of memory");
  } catch (const vk::OutOfHostMemoryError&) {
    throw CheckFailed("the Vulkan driver is out of memory");
  } catch (const vk::SystemError& error) {
    throw CheckFailed(fmt::format("the Vulkan driver fails: {}", error.what()));
  }
}

}  // namespace shadefit::device
