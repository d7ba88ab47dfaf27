#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bench/device/times/device_forms.hpp"

namespace shadefit::device {

/// The largest absolute error of each form on the device at that place, in one precision. None of a form
/// whose target has no truth.
std::vector<std::optional<double>> errors_on_device(std::size_t place, const DeviceForms& forms,
                                                    ShaderPrecision precision,
                                                    const std::function<void()>& between);

}  // namespace shadefit::device
