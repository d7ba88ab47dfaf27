#include "bench/device/measure_device.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "bench/device/evaluator.hpp"
#include "bench/device/spirv.hpp"
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

std::vector<float> read_values(std::span<const std::uint32_t> words) {
  std::vector<float> values;
  for (const std::uint32_t word : words) values.push_back(std::bit_cast<float>(word));
  return values;
}

}  // namespace

DeviceChoice choice_for_values(std::size_t place, const bench::FormsToTime& forms) {
  DeviceChoice choice{.place = place, .words = threads_per_group};
  for (const bench::FormTarget& target : forms.targets) {
    if (!target.places.empty())
      choice.words = std::max(choice.words, target.places.size() * target.places.front().size());
  }
  return choice;
}

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
    Evaluator evaluator(device, compiler, form.function, ShaderLanguage::glsl, Arguments::input, precision);
    errors.emplace_back(bench::largest_error(read_values(evaluator.of_input(arguments)), truth));
  }
  return errors;
}

}  // namespace shadefit::device
