#include "bench/device/form_sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "bench/device/evaluator.hpp"
#include "bench/device/form_bound.hpp"

namespace shadefit::device {
namespace {

/// A form on a device, with its bound.
struct SweptForm {
  SweptForm(std::shared_ptr<SweptDevice> shared, const ShaderFunction& form, const GpuModel& model)
      : device(std::move(shared)),
        evaluator(device->vulkan, compiler, form, ShaderLanguage::glsl, Arguments::patterns),
        in_double(form),
        panels(unit_panels()),
        bounds(bounds_on(panels, form, model)) {}

  std::shared_ptr<SweptDevice> device;
  ShaderCompiler compiler;
  Evaluator evaluator;
  FormInDouble in_double;
  std::vector<std::uint32_t> panels;
  std::vector<double> bounds;
};

}  // namespace

void sweep_on_device(bench::FloatSubject& subject, std::shared_ptr<SweptDevice> shared,
                     const ShaderFunction& form, const GpuModel& model) {
  const auto swept = std::make_shared<SweptForm>(std::move(shared), form, model);
  subject.prepare = [swept](const bench::Stretch& stretch) {
    SweptDevice& device = *swept->device;
    device.first = stretch.from;
    device.results.resize(stretch.size());
    swept->evaluator.over_patterns(
        stretch.from, stretch.to, [&](std::uint32_t from, std::span<const std::uint32_t> some) {
          std::copy(some.begin(), some.end(), device.results.begin() + (from - stretch.from));
        });
  };
  subject.form = [swept](const float* in, float* out, std::size_t count) {
    const SweptDevice& device = *swept->device;
    for (std::size_t i = 0; i < count; ++i)
      out[i] = std::bit_cast<float>(device.results[std::bit_cast<std::uint32_t>(in[i]) - device.first]);
  };
  subject.bound = [swept](const float* in, double* middle, double* radius, std::size_t count) {
    const std::vector<double> cosines(in, in + count);
    const std::array arguments{cosines.data()};
    swept->in_double(arguments, middle, count);
    const std::vector<std::uint32_t>& panels = swept->panels;
    auto next = std::upper_bound(panels.begin(), panels.end(), std::bit_cast<std::uint32_t>(in[0]));
    for (std::size_t i = 0; i < count; ++i) {  // the floats rise
      while (next != panels.end() && *next <= std::bit_cast<std::uint32_t>(in[i])) ++next;
      radius[i] = swept->bounds[static_cast<std::size_t>(next - panels.begin()) - 1];
    }
  };
}

}  // namespace shadefit::device
