#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "app/device/device_commands.hpp"
#include "bench/device/form_sweep.hpp"
#include "bench/device/half_errors.hpp"
#include "bench/device/measure_device.hpp"
#include "bench/device/probe.hpp"

/// `bench --device`: times, and every float or half.
namespace shadefit {

bench::Trade trade_on_device(const BenchOptions& options, const std::function<bench::FormsToTime()>& forms,
                             const Checkpoint& checkpoint, const Progress& progress) {
  const auto plan = options.quick ? device::quick_device_plan : device::full_device_plan;
  device::VulkanDevice for_times({.place = *options.device, .has_buffers_on_device = true});
  const bench::FormsToTime made = forms();
  device::VulkanDevice for_values(device::choice_for_values(*options.device, made));
  return device::measure_on_device(for_times, for_values, made, plan, bar(checkpoint, progress, "bench"));
}

Sweeper sweeper_on_device(const forms::Catalogue& catalogue, const BenchOptions& options,
                          const std::vector<bench::SweptForm>& swept, const Checkpoint& checkpoint) {
  const auto device = std::make_shared<device::SweptDevice>(device::VulkanDevice({.place = *options.device}));
  const std::string name = device::name_with_driver(device->vulkan.info());
  const auto function_of = [](const bench::SweptForm& form) {
    return bench::function_of(*form.target, *form.form, *form.constants);
  };
  if (options.half) {
    device::require_half(device->vulkan.info());
    return {name, "", "halves", "errors-half.csv",
            [=, &catalogue](const bench::SweptForm& form, const auto& between) {
              between(0);
              return device::errors_in_half(device->vulkan, function_of(form),
                                            bench::subject_of(catalogue, form, 0).truth, usual_gpu);
            }};
  }
  // pow is measured with all that other forms need.
  auto needed = forms::Function::none;
  for (const bench::SweptForm& form : swept) needed = std::max(needed, form.form->function);
  const GpuModel model = device::model_for(needed, device->vulkan, checkpoint);
  const std::string bound = fmt::format(
      "bound for exp2 within {:.4g} ulp, log2 within {:.4g} and within {:.4g} between 1/2 and 2\n",
      model.exp2_ulps, model.log2_ulps, model.log2_near_one);
  return {name, bound, "floats", "errors.csv",
          [=, &catalogue, range = options.range](const bench::SweptForm& form, const auto& between) {
            bench::FloatSubject subject = bench::subject_of(catalogue, form, 0);
            device::sweep_on_device(subject, device, function_of(form), model);
            return errors_on(subject, range, between);
          }};
}

}  // namespace shadefit
