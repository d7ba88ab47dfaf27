#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "bench/device/form_functions.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/exhaustive/float_errors.hpp"
#include "fit/scalars/gpu_model.hpp"

/// Evaluates a form at every float on a device.
namespace shadefit::device {

/// A form on a device, with the error bound that follows from the errors of the device's functions.
class FormSweep {
 public:
  FormSweep(VulkanDevice device, const FormFunction& form, const GpuModel& model);

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
