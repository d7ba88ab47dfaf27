#include "bench/device/form_sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "bench/device/evaluator.hpp"
#include "bench/device/form_bound.hpp"

namespace shadefit::device {

struct FormSweep::Parts {
  Parts(std::shared_ptr<SweptDevice> shared, const FormFunction& form, const GpuModel& model)
      : device(std::move(shared)),
        evaluator(device->vulkan, compiler, form.function, ShaderLanguage::glsl, Arguments::patterns),
        in_double(form.function),
        panels(unit_panels()),
        bounds(bounds_on(panels, form.function, model)) {}

  /// Computes the results for a stretch.
  void prepare(const bench::Stretch& stretch) {
    device->first = stretch.from;
    device->results.resize(stretch.size());
    evaluator.over_patterns(
        stretch.from, stretch.to, [&](std::uint32_t from, std::span<const std::uint32_t> some) {
          std::copy(some.begin(), some.end(), device->results.begin() + (from - stretch.from));
        });
  }

  void form(const float* in, float* out, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      out[i] = std::bit_cast<float>(device->results[std::bit_cast<std::uint32_t>(in[i]) - device->first]);
  }

  void bound(const float* in, double* middle, double* radius, std::size_t count) const {
    const std::vector<double> cosines(in, in + count);
    const std::array arguments{cosines.data()};
    in_double(arguments, middle, count);
    auto next = std::upper_bound(panels.begin(), panels.end(), std::bit_cast<std::uint32_t>(in[0]));
    for (std::size_t i = 0; i < count; ++i) {  // the floats rise
      while (next != panels.end() && *next <= std::bit_cast<std::uint32_t>(in[i])) ++next;
      radius[i] = bounds[static_cast<std::size_t>(next - panels.begin()) - 1];
    }
  }

  std::shared_ptr<SweptDevice> device;
  ShaderCompiler compiler;
  Evaluator evaluator;
  FormInDouble in_double;
  std::vector<std::uint32_t> panels;
  std::vector<double> bounds;
};

FormSweep::FormSweep(std::shared_ptr<SweptDevice> device, const FormFunction& form, const GpuModel& model)
    : parts_(std::make_shared<Parts>(std::move(device), form, model)) {}

void FormSweep::take_over(bench::FloatSubject& subject) const {
  subject.prepare = [parts = parts_](const bench::Stretch& stretch) { parts->prepare(stretch); };
  subject.form = [parts = parts_](const float* in, float* out, std::size_t count) {
    parts->form(in, out, count);
  };
  subject.bound = [parts = parts_](const float* in, double* middle, double* radius, std::size_t count) {
    parts->bound(in, middle, radius, count);
  };
}

std::string FormSweep::device() const {
  return name_with_driver(parts_->device->vulkan.info());
}

std::vector<double> numbers_of(const GpuModel& model) {
  return {model.exp2_ulps, model.log2_ulps, model.log2_near_one, model.quotient_ulps, model.root_ulps};
}

}  // namespace shadefit::device
