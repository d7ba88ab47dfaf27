#include "bench/device/form_sweep.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <vector>

#include "bench/device/evaluator.hpp"
#include "bench/device/form_bound.hpp"
#include "fit/formula/batch.hpp"

namespace shadefit::device {
namespace {

/// A form on a device with its bound, and its results on the last stretch.
struct Swept {
  Swept(VulkanDevice& device, const ShaderFunction& form, const GpuModel& model)
      : evaluator(device, compiler, form),
        code(tape_of_code(form)),
        panels(unit_panels()),
        bounds(bounds_on(panels, form, model)) {}

  ShaderCompiler compiler;
  Evaluator evaluator;
  Tape code;
  std::vector<std::uint32_t> panels;
  std::vector<double> bounds;
  std::uint32_t first = 0;  ///< the bit pattern that the first result belongs to
  std::vector<float> results;
};

}  // namespace

void sweep_on_device(bench::FloatSubject& subject, VulkanDevice& device, const ShaderFunction& form,
                     const GpuModel& model) {
  const auto swept = std::make_shared<Swept>(device, form, model);
  subject.prepare = [swept](const bench::Stretch& stretch) {
    std::vector<float> cosines;
    for (std::uint32_t bits = stretch.from; bits < stretch.to; ++bits)
      cosines.push_back(std::bit_cast<float>(bits));
    const std::span<const float> results = swept->evaluator.of(cosines);
    swept->first = stretch.from;
    swept->results.assign(results.begin(), results.end());
  };
  subject.form = [swept](const float* in, float* out, std::size_t count) {
    std::copy_n(&swept->results[std::bit_cast<std::uint32_t>(in[0]) - swept->first], count, out);
  };
  subject.bound = [swept](const float* in, double* middle, double* radius, std::size_t count) {
    const std::vector<double> cosines(in, in + count);
    std::ranges::copy(values_at(swept->code, std::span(&cosines, 1), {}), middle);
    const std::vector<std::uint32_t>& panels = swept->panels;
    auto next = std::upper_bound(panels.begin(), panels.end(), std::bit_cast<std::uint32_t>(in[0]));
    for (std::size_t i = 0; i < count; ++i) {  // the floats rise
      while (next != panels.end() && *next <= std::bit_cast<std::uint32_t>(in[i])) ++next;
      radius[i] = swept->bounds[static_cast<std::size_t>(next - panels.begin()) - 1];
    }
  };
}

}  // namespace shadefit::device
