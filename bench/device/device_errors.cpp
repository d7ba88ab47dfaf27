#include <vector>

#include "bench/device/evaluator.hpp"
#include "bench/device/measure_device.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit::device {
namespace {

/// The places, rounded to the precision: so the error is that of the form, not of its argument.
bench::Places held(bench::Places places, ShaderPrecision precision) {
  if (precision == ShaderPrecision::float16) {
    for (std::vector<float>& axis : places) {
      for (float& x : axis) x = static_cast<float>(round_to_half(x));
    }
  }
  return places;
}

/// All arguments of the first place, then those of the second, and so on.
std::vector<float> arguments_of(const bench::Places& places) {
  std::vector<float> arguments;
  for (std::size_t i = 0; i < places.front().size(); ++i) {
    for (const std::vector<float>& axis : places) arguments.push_back(axis[i]);
  }
  return arguments;
}

}  // namespace

std::vector<std::optional<double>> errors_on_device(VulkanDevice& device, const bench::FormsToTime& forms,
                                                    ShaderPrecision precision,
                                                    const std::function<void()>& between) {
  const ShaderCompiler compiler;
  std::vector<std::optional<double>> errors;
  const bench::FormTarget* target = nullptr;
  std::vector<double> truth;
  std::vector<float> arguments;
  for (const bench::FormToTime& form : forms.forms) {
    between();
    if (target != &forms.targets.at(form.target)) {
      target = &forms.targets.at(form.target);
      truth.clear();
      if (target->truth) {
        const bench::Places places = held(target->places, precision);
        truth = target->truth(places);
        arguments = arguments_of(places);
      }
    }
    if (truth.empty()) {
      errors.emplace_back();
      continue;
    }
    Evaluator evaluator(device, compiler, form.function, precision);
    errors.emplace_back(bench::largest_error(evaluator.of(arguments), truth));
  }
  return errors;
}

}  // namespace shadefit::device
