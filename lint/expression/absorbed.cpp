#include "lint/expression/absorbed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "lint/expression/compare.hpp"

namespace shadefit::lint {
namespace {

/// Adds the parts that have one variable and, of the constants, only missing ones.
void append_inner(const KnownSet& set, const Symbolic& part, const std::vector<std::size_t>& missing,
                  std::vector<Symbolic>& inner) {
  const std::set<std::string> names = names_of(part);
  const auto constants = std::ranges::count_if(
      missing, [&](std::size_t constant) { return names.contains(set.constants[constant].name); });
  const auto variables =
      std::ranges::count_if(set.axes, [&](const KnownAxis& axis) { return names.contains(axis.variable); });
  if (constants > 0 && variables == 1 && std::ssize(names) == constants + 1) inner.push_back(part);
  for (const Symbolic& one : part.parts()) append_inner(set, one, missing, inner);
}

/// The range of a part over that of its variable.
KnownAxis range_of(const Symbolic& part, const KnownAxis& axis, const KnownSet& set,
                   const std::vector<double>& constants) {
  constexpr int steps = 32;
  KnownAxis range{axis.variable + "'", std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= steps; ++i) {
    const double place = axis.lower + (axis.upper - axis.lower) * i / steps;
    const double value = evaluate<double>(part, [&](const std::string& name) {
      const auto constant = std::ranges::find(set.constants, name, &KnownConstant::name);
      const auto at = static_cast<std::size_t>(constant - set.constants.begin());
      return constant == set.constants.end() ? place : constants[at] / set.factor;
    });
    range.lower = std::min(range.lower, value);
    range.upper = std::max(range.upper, value);
  }
  return range;
}

}  // namespace

std::vector<Absorbed> absorbed_in(const KnownSet& set, const std::vector<double>& constants,
                                  const std::vector<std::size_t>& missing) {
  std::vector<Symbolic> inner;
  append_inner(set, set.formula, missing, inner);
  std::vector<Absorbed> found;
  for (const Symbolic& part : inner) {
    const std::set<std::string> names = names_of(part);
    KnownSet outer = set;
    const auto axis = std::ranges::find_if(
        outer.axes, [&](const KnownAxis& known) { return names.contains(known.variable); });
    const std::string variable = axis->variable;
    *axis = range_of(part, *axis, set, constants);
    const std::string name = axis->variable;
    outer.formula = with_part(set.formula, part, Symbolic::variable(name));
    if (names_of(outer.formula).contains(variable) || !std::isfinite(axis->upper - axis->lower) ||
        !(axis->lower < axis->upper))
      continue;
    found.push_back({part, std::move(outer), name, variable});
  }
  return found;
}

Symbolic with_part(const Symbolic& formula, const Symbolic& part, const Symbolic& other) {
  if (formula.depth() < part.depth()) return formula;
  if (formula.depth() == part.depth()) return to_text(formula) == to_text(part) ? other : formula;
  std::vector<Symbolic> parts = formula.parts();
  for (Symbolic& one : parts) one = with_part(one, part, other);
  return formula.with_parts(std::move(parts));
}

}  // namespace shadefit::lint
