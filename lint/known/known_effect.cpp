#include <algorithm>
#include <array>
#include <cmath>

#include "fit/tape/tape_program.hpp"
#include "lint/known/known_set.hpp"

namespace shadefit::lint {
namespace {

std::vector<double> values_on_grid(const KnownSet& set, const Symbolic& form,
                                   const std::vector<double>& constants) {
  constexpr std::array<int, most_axes> steps_in{1000, 32, 12};  // in one, two and three variables
  const int steps = steps_in[set.axes.size() - 1];
  std::vector<std::string> inputs;
  for (const KnownAxis& axis : set.axes) inputs.push_back(axis.variable);
  for (const KnownConstant& constant : set.constants) inputs.push_back(constant.name);
  std::vector<double> published = constants;
  for (double& value : published) value /= set.factor;
  TapeProgram<double> program(tape_of(form, inputs), published);
  std::vector<double> values, place(set.axes.size());
  const auto visit = [&](const auto& self, std::size_t axis) -> void {
    if (axis == set.axes.size()) {
      program.run(place);
      values.push_back(program.output(0));
      return;
    }
    const auto& [name, lower, upper] = set.axes[axis];
    for (int i = 0; i <= steps; ++i) {
      place[axis] = lower + (upper - lower) * i / steps;
      self(self, axis + 1);
    }
  };
  visit(visit, 0);
  return values;
}

}  // namespace

std::vector<double> published_values(const KnownSet& set) {
  std::vector<double> values;
  for (const KnownConstant& constant : set.constants) values.push_back(constant.value);
  return values;
}

Effect effect_of(const KnownSet& set, const Symbolic& form, const std::vector<double>& constants) {
  const std::vector<double> before = values_on_grid(set, set.formula, published_values(set)),
                            after = values_on_grid(set, form, constants);
  Effect effect;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (std::isfinite(before[i])) effect.show(before[i], after[i], {});
  return effect;
}

bool is_shown(const KnownSet& set) {
  // A fit leaves the range of its target by a few percent at most.
  constexpr double slack = 0.05;
  const std::vector<double> values = values_on_grid(set, set.formula, published_values(set));
  return std::all_of(values.begin(), values.end(), [](double value) {
    return !std::isfinite(value) || (-slack <= value && value <= 1 + slack);
  });
}

}  // namespace shadefit::lint
