#include <algorithm>

#include "bench/device/form_functions.hpp"
#include "bench/device/times/device_forms.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

DeviceTarget target_on_device(const forms::Catalogue& catalogue, const forms::Target& target) {
  DeviceTarget made{{std::string(target.id), std::string(target.id) + ": " + std::string(target.text)},
                    {},
                    bench::grid_of(target),
                    [=](const Places& places) { return bench::truth_at(places, catalogue, target); }};
  for (const std::vector<float>& axis : made.places) {
    const auto [low, high] = std::minmax_element(axis.begin(), axis.end());
    made.ranges.push_back({*low, *high});
  }
  return made;
}

bench::TimedForm row_of(const FormFunction& function, bool is_first) {
  bench::TimedForm row;
  row.target = function.target;
  row.form = function.form;
  row.constants = function.constants;
  row.label = row.constants == "none" ? row.form : row.form + ", " + row.constants;
  row.is_reference = is_first;  // the first form of a target is the target itself
  return row;
}

}  // namespace

DeviceForms catalogue_forms(const forms::Catalogue& catalogue, const std::vector<std::string>& targets) {
  DeviceForms all;
  for (FormFunction& function : form_functions(catalogue)) {
    if (!forms::is_wanted(targets, function.target)) continue;
    const bool is_first = all.targets.empty() || all.targets.back().heading.id != function.target;
    if (is_first) all.targets.push_back(target_on_device(catalogue, target_of(catalogue, function.target)));
    all.forms.push_back(
        {all.targets.size() - 1, row_of(function, is_first), function.form, std::move(function.function)});
  }
  if (all.forms.empty())
    throw UserError("--device has no form for --only '" + targets.front() +
                    "': sums of several lights are not measured there, phong-1 is one light");
  return all;
}

}  // namespace shadefit::device
