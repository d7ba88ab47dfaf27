#include <functional>
#include <string_view>
#include <utility>

#include "lint/expression/compare.hpp"

namespace shadefit::lint {
namespace {

using Kind = Symbolic::Kind;

/// The other functions of the same family.
std::vector<std::string_view> kin_of(std::string_view function) {
  const std::vector<std::string_view> families[] = {
      {"exp", "exp2", "expm1"}, {"log", "log2", "log1p"}, {"sin", "cos", "tan"}, {"min", "max"}};
  for (std::vector<std::string_view> family : families)
    if (std::erase(family, function) > 0) return family;
  return {};
}

bool is_sum(const Symbolic& formula) {
  return formula.kind() == Kind::add || formula.kind() == Kind::subtract;
}
bool is_product(const Symbolic& formula) {
  return formula.kind() == Kind::multiply || formula.kind() == Kind::divide;
}

/// Whether a product or quotient only has a constant factor such as 1/pi: programs fold it into other
/// factors.
bool is_scaled(const Symbolic& formula) {
  return formula.part(0).is_of_numbers() || formula.part(1).is_of_numbers();
}

/// a (b + c) as a b + c, (a + b) c as a + b c; the same for quotients and differences.
void append_lost_parentheses(const Symbolic& formula, std::vector<Symbolic>& others) {
  const Symbolic &a = formula.part(0), &b = formula.part(1);
  if (is_sum(b))
    others.push_back(b.with_parts({Symbolic::operation(formula.kind(), {a, b.part(0)}), b.part(1)}));
  if (is_sum(a))
    others.push_back(a.with_parts({a.part(0), Symbolic::operation(formula.kind(), {a.part(1), b})}));
  if (formula.kind() == Kind::divide && b.kind() == Kind::multiply)
    others.push_back(a / b.part(0) * b.part(1));
}

/// a b + c as a (b + c); the same for a difference.
void append_moved_parentheses(const Symbolic& formula, std::vector<Symbolic>& others) {
  const Symbolic& product = formula.part(0);
  if (product.kind() != Kind::multiply) return;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    others.push_back(product.part(i) * formula.with_parts({product.part(1 - i), formula.part(1)}));
}

/// Whether a formula is a function, or a power, of its first part.
bool is_applied(const Symbolic& formula) {
  return formula.kind() == Kind::function || formula.kind() == Kind::real_power;
}

/// f(x) b as f(x b); the same for each operation.
void append_moved_into_argument(const Symbolic& operation, std::vector<Symbolic>& others) {
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const Symbolic& function = operation.part(i);
    if (!is_applied(function)) continue;
    std::vector<Symbolic> operands = operation.parts(), arguments = function.parts();
    operands[i] = function.part(0);
    arguments.front() = operation.with_parts(std::move(operands));
    others.push_back(function.with_parts(std::move(arguments)));
  }
}

/// The slips that may replace an operation.
std::vector<Symbolic> slips_of(const Symbolic& formula) {
  std::vector<Symbolic> others;
  const auto operation = [&](Kind kind) { others.push_back(Symbolic::operation(kind, formula.parts())); };
  const auto parts = [&] { others.insert(others.end(), formula.parts().begin(), formula.parts().end()); };
  if (is_product(formula) && is_scaled(formula)) return others;
  switch (formula.kind()) {
    case Kind::add:
      operation(Kind::subtract);
      operation(Kind::multiply);
      parts();
      break;
    case Kind::subtract:
      operation(Kind::add);
      others.push_back(formula.part(1) - formula.part(0));
      parts();
      break;
    case Kind::multiply:
      operation(Kind::add);
      operation(Kind::divide);
      parts();
      break;
    case Kind::divide:
      operation(Kind::multiply);
      others.push_back(formula.part(1) / formula.part(0));
      others.push_back(formula.part(0));
      break;
    case Kind::negate:
      others.push_back(formula.part(0));
      break;
    case Kind::integer_power:
      for (const int change : {-1, 1})
        if (formula.exponent() + change != 0)
          others.push_back(Symbolic::integer_power(formula.part(0), formula.exponent() + change));
      break;
    case Kind::real_power:  // without its exponent it may be a power that is computed elsewhere
      others.push_back(
          Symbolic::operation(Kind::real_power, {formula.part(0), Symbolic::number("1") / formula.part(1)}));
      break;
    case Kind::choice:
      others.push_back(
          formula.with_parts({formula.part(0), formula.part(1), formula.part(3), formula.part(2)}));
      break;
    case Kind::function:
      for (const std::string_view other : kin_of(formula.name()))
        others.push_back(Symbolic::function(other, formula.parts()));
      if (formula.parts().size() == 1) parts();
      break;
    case Kind::variable:
    case Kind::number:
    case Kind::constant:
    case Kind::integral:
      break;
  }
  if (is_sum(formula)) append_moved_parentheses(formula, others);
  if (is_product(formula)) append_lost_parentheses(formula, others);
  if (is_sum(formula) || is_product(formula)) append_moved_into_argument(formula, others);
  return others;
}

/// Adds the whole formula with each slip of each part.
void append_mutants(const Symbolic& part, const std::function<Symbolic(const Symbolic&)>& around,
                    std::vector<Mutant>& mutants) {
  for (const Symbolic& other : slips_of(part))
    mutants.push_back({around(other), to_text(other) + " for " + to_text(part)});
  for (std::size_t i = 0; i < part.parts().size(); ++i) {
    const auto with_part = [&](const Symbolic& inner) {
      std::vector<Symbolic> parts = part.parts();
      parts[i] = inner;
      return around(part.with_parts(std::move(parts)));
    };
    append_mutants(part.part(i), with_part, mutants);
  }
}

}  // namespace

std::vector<Mutant> mutants_of(const Symbolic& formula) {
  std::vector<Mutant> mutants;
  append_mutants(formula, std::identity(), mutants);
  return mutants;
}

}  // namespace shadefit::lint
