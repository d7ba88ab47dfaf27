#include <algorithm>
#include <array>
#include <cmath>

#include "fit/formula/tape_program.hpp"
#include "lint/scan/known_set.hpp"

namespace shadefit::lint {
namespace {

/// For each axis, the places where curves are compared.
using Grid = std::vector<std::vector<double>>;

/// Even steps of the ranges.
Grid even_grid(const KnownSet& set) {
  constexpr std::array<int, most_axes> steps_in{1000, 32, 12};  // in one, two and three variables
  const int steps = steps_in[set.axes.size() - 1];
  Grid grid;
  for (const auto& [name, lower, upper] : set.axes) {
    grid.emplace_back();
    for (int i = 0; i <= steps; ++i) grid.back().push_back(lower + (upper - lower) * i / steps);
  }
  return grid;
}

/// Adds the places on both sides of the thresholds of a form: between two thresholds, the curves may differ
/// most there.
void append_beside_thresholds(const KnownSet& set, const Symbolic& form, const std::vector<double>& constants,
                              Grid& grid) {
  for (std::size_t axis = 0; axis < set.axes.size(); ++axis) {
    const auto& [name, lower, upper] = set.axes[axis];
    for (const double threshold : thresholds_of(set, form, constants, name))
      for (const double place : {std::nextafter(threshold, lower), std::nextafter(threshold, upper)})
        if (lower < place && place < upper) grid[axis].push_back(place);
  }
}

std::vector<double> values_on_grid(const KnownSet& set, const Symbolic& form,
                                   const std::vector<double>& constants, const Grid& grid) {
  std::vector<std::string> inputs;
  for (const KnownAxis& axis : set.axes) inputs.push_back(axis.variable);
  for (const KnownConstant& constant : set.constants) inputs.push_back(constant.name);
  TapeProgram<double> program(tape_of(form, inputs), constants);
  std::vector<double> values, place(set.axes.size());
  const auto visit = [&](const auto& self, std::size_t axis) -> void {
    if (axis == set.axes.size()) {
      program.run(place);
      values.push_back(program.output(0));
      return;
    }
    for (const double at : grid[axis]) {
      place[axis] = at;
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

std::vector<double> thresholds_of(const KnownSet& set, const Symbolic& form,
                                  const std::vector<double>& constants, const std::string& variable) {
  std::vector<double> thresholds;
  for (const Symbolic& part : form.parts()) {
    const std::vector<double> inner = thresholds_of(set, part, constants, variable);
    thresholds.insert(thresholds.end(), inner.begin(), inner.end());
  }
  if (form.kind() != Symbolic::Kind::choice) return thresholds;
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const Symbolic& compared = form.part(side);
    if (compared.kind() != Symbolic::Kind::variable || compared.name() != variable) continue;
    thresholds.push_back(evaluate<double>(form.part(1 - side), [&](const std::string& name) {
      for (std::size_t i = 0; i < set.constants.size(); ++i)
        if (set.constants[i].name == name) return constants[i];
      return std::nan("");
    }));
  }
  return thresholds;
}

Effect effect_of(const KnownSet& set, const Symbolic& form, const std::vector<double>& constants) {
  const std::vector<double> published = published_values(set);
  Grid grid = even_grid(set);
  append_beside_thresholds(set, set.formula, published, grid);
  append_beside_thresholds(set, form, constants, grid);
  const std::vector<double> before = values_on_grid(set, set.formula, published, grid),
                            after = values_on_grid(set, form, constants, grid);
  Effect effect;
  double encoded_codes = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!std::isfinite(before[i])) continue;
    effect.show(before[i], after[i], {});
    const double moved = std::clamp(after[i], 0.0, 1.0) - std::clamp(before[i], 0.0, 1.0);
    encoded_codes = std::max(encoded_codes, 255 * std::abs(moved));
  }
  if (set.is_encoded) effect.srgb_codes = encoded_codes;
  return effect;
}

bool is_shown(const KnownSet& set) {
  // A fit leaves the range of its target by a few percent at most.
  constexpr double slack = 0.05;
  const std::vector<double> values = values_on_grid(set, set.formula, published_values(set), even_grid(set));
  return std::ranges::all_of(
      values, [](double value) { return !std::isfinite(value) || (-slack <= value && value <= 1 + slack); });
}

}  // namespace shadefit::lint
