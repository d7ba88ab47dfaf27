#include "fit/scalars/integral.hpp"

#include <algorithm>
#include <ios>
#include <span>
#include <vector>

#include "fit/scalars/multiprecision.hpp"
#include "fit/truths/albedos.hpp"

namespace shadefit {
namespace {

using NodeTexts = std::vector<IntegralNode<std::string>>;

NodeTexts nodes_with_step(int steps) {
  const Decimal50 pi = Scalar<Decimal50>::pi(), least = pow(Decimal50(2), -50);
  std::vector<IntegralNode<Decimal50>> nodes;
  Decimal50 total = 0;
  for (int k = 0;; ++k) {
    const Decimal50 u = Decimal50(k) / steps;
    const Decimal50 distance = 1 / (1 + exp(pi * sinh(u)));
    if (distance < least) break;
    const Decimal50 weight = cosh(u) * distance * (1 - distance);
    nodes.push_back({distance, true, weight});
    if (k > 0) nodes.push_back({distance, false, weight});
    total += k > 0 ? 2 * weight : weight;
  }
  const auto text = [](const Decimal50& value) { return value.str(40, std::ios_base::scientific); };
  NodeTexts result;
  for (const auto& node : nodes)
    result.push_back({text(node.distance), node.is_from_upper, text(node.weight / total)});
  return result;
}

const NodeTexts& nodes_of(IntegralRule rule) {
  static const NodeTexts usual = nodes_with_step(12), check = nodes_with_step(16);
  return rule == IntegralRule::usual ? usual : check;
}

/// A sum as a tree of little depth.
Symbolic sum_of(std::span<const Symbolic> terms) {
  if (terms.size() == 1) return terms.front();
  const std::size_t half = terms.size() / 2;
  return sum_of(terms.first(half)) + sum_of(terms.subspan(half));
}

}  // namespace

const NodeTexts& usual_integral_nodes() {
  return nodes_of(IntegralRule::usual);
}

Symbolic summed(const Symbolic& e, IntegralRule rule) {
  const Symbolic &body = e.part(0), &lower = e.part(1), &upper = e.part(2);
  const Symbolic length = upper - lower;
  std::vector<Symbolic> terms;
  for (const auto& node : nodes_of(rule)) {
    const Symbolic step = length * Symbolic::number(node.distance);
    const Symbolic place = node.is_from_upper ? upper - step : lower + step;
    terms.push_back(Symbolic::number(node.weight) * evaluate<Symbolic>(body, [&](const std::string& name) {
                      return name == e.name() ? place : Symbolic::variable(name);
                    }));
  }
  return length * sum_of(terms);
}

Symbolic with_parts(const Symbolic& e, const std::function<Symbolic(const std::string&)>& value_of) {
  // A name for the variable that the new parts do not have.
  std::string variable = e.name();
  std::set<std::string> taken;
  for (const std::string& name : free_variables(e.part(0))) {
    if (name != e.name()) taken.merge(free_variables(value_of(name)));
  }
  while (taken.contains(variable)) variable += '_';
  const auto inside = [&](const std::string& name) {
    return name == e.name() ? Symbolic::variable(variable) : value_of(name);
  };
  return Symbolic::integral(variable,
                            {evaluate<Symbolic>(e.part(0), inside), evaluate<Symbolic>(e.part(1), value_of),
                             evaluate<Symbolic>(e.part(2), value_of)});
}

std::set<std::string> free_variables(const Symbolic& e) {
  std::set<std::string> names;
  if (e.kind() == Symbolic::Kind::variable) names.insert(e.name());
  for (const Symbolic& part : e.parts()) names.merge(free_variables(part));
  if (e.kind() == Symbolic::Kind::integral) names.erase(e.name());
  return names;
}

bool contains_any(const Symbolic& formula, const std::vector<std::string>& names) {
  const std::set<std::string> variables = free_variables(formula);
  return std::ranges::any_of(names, [&](const std::string& name) { return variables.contains(name); });
}

int integral_depth(const Symbolic& e) {
  int depth = 0;
  for (const Symbolic& part : e.parts()) depth = std::max(depth, integral_depth(part));
  if (e.kind() == Symbolic::Kind::function && find_albedo(e.name())) return depth + 2;
  return depth + (e.kind() == Symbolic::Kind::integral ? 1 : 0);
}

}  // namespace shadefit
