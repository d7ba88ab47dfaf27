#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/device/form_functions.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/exhaustive/float_errors.hpp"
#include "fit/scalars/gpu_model.hpp"

/// Evaluates a form at every float on a device.
namespace shadefit::device {

/// A device, and the results of the form that ran last on it.
struct SweptDevice {
  explicit SweptDevice(VulkanDevice made) : vulkan(std::move(made)) {}

  VulkanDevice vulkan;
  std::uint32_t first = 0;  ///< the bit pattern that the first result belongs to
  std::vector<std::uint32_t> results = {};
};

/// A form on a device, with the error bound that follows from the errors of the device's functions.
class FormSweep {
 public:
  /// Several forms may share a device, if each is prepared and looked at before the next.
  FormSweep(std::shared_ptr<SweptDevice> device, const FormFunction& form, const GpuModel& model);

  /// Replaces the form of a subject, and adds the bound. The subject's floats lie in [0, 1].
  void take_over(bench::FloatSubject& subject) const;

  /// The name of the device and of its driver.
  std::string device() const;

 private:
  struct Parts;
  std::shared_ptr<Parts> parts_;
};

/// The numbers of a model; they are part of a sweep's identity.
std::vector<double> numbers_of(const GpuModel& model);

}  // namespace shadefit::device
