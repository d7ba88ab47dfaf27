#include "fit/truths/graded_rule.hpp"

#include <numbers>

namespace shadefit {
namespace {

constexpr std::size_t rule_step = 8, most_rules = 36;

/// The zeros of the Legendre polynomial by Newton's method, in long double, so that their doubles are right.
std::vector<RuleNode> legendre_rule(std::size_t count) {
  std::vector<RuleNode> nodes;
  const auto n = static_cast<long double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    long double x =
        std::cos(std::numbers::pi_v<long double> * (static_cast<long double>(k) + 0.75L) / (n + 0.5L));
    long double slope = 1;
    for (int pass = 0; pass < 6; ++pass) {
      long double last = 1, value = x;
      for (std::size_t m = 2; m <= count; ++m) {
        const auto degree = static_cast<long double>(m);
        const long double next = ((2 * degree - 1) * x * value - (degree - 1) * last) / degree;
        last = value;
        value = next;
      }
      slope = n * (x * value - last) / (x * x - 1);
      x -= value / slope;
    }
    nodes.push_back(
        {static_cast<double>((1 - x) / 2), static_cast<double>(1 / ((1 - x * x) * slope * slope))});
  }
  return nodes;
}

}  // namespace

const std::vector<RuleNode>& gauss_on_unit(std::size_t count) {
  static const std::vector<std::vector<RuleNode>> rules = [] {
    std::vector<std::vector<RuleNode>> result;
    for (std::size_t i = 2; i <= most_rules; ++i) result.push_back(legendre_rule(i * rule_step));
    return result;
  }();
  const std::size_t multiple = (count + rule_step - 1) / rule_step;
  return rules.at(multiple < 2 ? 0 : multiple - 2);
}

}  // namespace shadefit
