#include <algorithm>

#include "bench/device/form_functions.hpp"
#include "bench/device/times/device_forms.hpp"
#include "bench/tradeoff/grid_errors.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

Places places_of(const bench::Grid& grid) {
  Places places;
  for (const std::vector<float>& axis : grid.in) {
    if (!axis.empty()) places.push_back(axis);
  }
  if (!grid.codes.empty()) places.emplace_back(grid.codes.begin(), grid.codes.end());
  return places;
}

/// The inverse of `places_of`. A code is a whole number in any format.
bench::Grid grid_at(const Places& places, forms::Arguments arguments) {
  const bool has_codes = arguments == forms::Arguments::cosine_and_code;
  bench::Grid grid;
  for (std::size_t i = 0; i + (has_codes ? 1 : 0) < places.size(); ++i) grid.in[i] = places[i];
  if (has_codes) {
    for (const float code : places.back()) grid.codes.push_back(static_cast<std::uint8_t>(code));
  }
  return grid;
}

DeviceTarget target_on_device(const forms::Catalogue& catalogue, const forms::Target& target) {
  DeviceTarget made{{std::string(target.id), std::string(target.id) + ": " + std::string(target.text)},
                    {},
                    places_of(bench::grid_of(target)),
                    [=](const Places& places) {
                      return bench::truth_at(grid_at(places, target.arguments), catalogue, target);
                    }};
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
