#include "fit/formula/graph.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "fit/scalars/functions.hpp"

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

template <class List>
int index_of(const List& functions, std::string_view name) {
  const auto* found = find_function(functions, name);
  if (found == nullptr) throw std::logic_error("a function outside the vocabulary: " + std::string(name));
  return static_cast<int>(found - functions.data());
}

/// The operation of a sum, a product, a power or a choice.
Operation operation_of(Kind kind) {
  static const std::map<Kind, Operation> operations{{Kind::add, Operation::add},
                                                    {Kind::subtract, Operation::subtract},
                                                    {Kind::multiply, Operation::multiply},
                                                    {Kind::divide, Operation::divide},
                                                    {Kind::negate, Operation::negate},
                                                    {Kind::real_power, Operation::real_power},
                                                    {Kind::integer_power, Operation::integer_power},
                                                    {Kind::choice, Operation::choice}};
  return operations.at(kind);
}

/// The node of a function, without its operands.
GraphNode called(const std::string& name, std::size_t operands) {
  if (const auto albedo = find_albedo(name)) return {Operation::albedo, index_of(*albedo)};
  if (operands == 1) return {Operation::function, index_of(functions_of_one<double>, name)};
  return {Operation::function_of_two, index_of(functions_of_two<double>, name)};
}

constexpr int albedo_orders = most_albedo_order + 1;

}  // namespace

std::string_view function_name(const GraphNode& node) {
  const auto index = static_cast<std::size_t>(node.index);
  if (node.operation == Operation::function) return functions_of_one<double>[index].name;
  return node.operation == Operation::function_of_two ? functions_of_two<double>[index].name : "";
}

int index_of(const Albedo& albedo) {
  return (static_cast<int>(albedo.index) * albedo_orders + albedo.by_c) * albedo_orders + albedo.by_alpha;
}

Albedo albedo_of(int index) {
  const int orders = index % (albedo_orders * albedo_orders);
  return {static_cast<std::size_t>(index / (albedo_orders * albedo_orders)), orders / albedo_orders,
          orders % albedo_orders};
}

std::size_t operand_count(Operation operation) {
  switch (operation) {
    case Operation::input:
    case Operation::constant:
      return 0;
    case Operation::negate:
    case Operation::integer_power:
    case Operation::function:
      return 1;
    case Operation::choice:
      return 4;
    default:
      return 2;
  }
}

int Graph::node(const GraphNode& wanted) {
  const auto [place, is_new] = known_.emplace(wanted, static_cast<int>(nodes_.size()));
  if (is_new) nodes_.push_back(wanted);
  return place->second;
}

int Graph::constant(const Symbolic& value) {
  const auto [place, is_new] = constant_of_.emplace(to_text(value), static_cast<int>(constants_.size()));
  if (is_new) constants_.push_back(value);
  const int result = node({Operation::constant, place->second});
  if (place->first == "0") zero_ = result;
  return result;
}

int Graph::add(const Symbolic& e) {
  if (e.is_of_numbers()) return constant(e);
  switch (e.kind()) {
    case Kind::variable: {
      const auto found = std::find(inputs_.begin(), inputs_.end(), e.name());
      if (found == inputs_.end()) throw std::logic_error("a variable that is no input: " + e.name());
      return node({Operation::input, static_cast<int>(found - inputs_.begin())});
    }
    case Kind::integral:
      return add(summed(e, rule_));
    default:
      break;
  }
  std::vector<int> parts;
  for (const Symbolic& part : e.parts()) parts.push_back(add(part));
  // The sum of an integral may be a number.
  if (std::ranges::all_of(parts, [&](int i) { return is_constant(i); })) return constant(e);
  GraphNode result =
      e.kind() == Kind::function ? called(e.name(), parts.size()) : GraphNode{operation_of(e.kind())};
  if (e.kind() == Kind::integer_power) result.index = e.exponent();
  std::copy(parts.begin(), parts.end(), result.operands.begin());
  return node(result);
}

std::vector<int> Graph::input_nodes() {
  std::vector<int> result;
  for (int i = 0; i < static_cast<int>(inputs_.size()); ++i) result.push_back(node({Operation::input, i}));
  return result;
}

bool Graph::is_whole(int i, int n) const {
  const GraphNode& at = nodes_[static_cast<std::size_t>(i)];
  if (at.operation != Operation::constant) return false;
  // The name of a power is its exponent.
  return constant_at(i).parts().empty() && constant_at(i).name() == std::to_string(n);
}

bool Graph::is_constant(int i) const {
  return nodes_[static_cast<std::size_t>(i)].operation == Operation::constant;
}

const Symbolic& Graph::constant_at(int i) const {
  return constants_[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(i)].index)];
}

int Graph::negative(int a) {
  if (is_zero(a)) return a;
  const GraphNode at = nodes_[static_cast<std::size_t>(a)];
  if (at.operation == Operation::negate) return at.operands[0];
  return node({Operation::negate, 0, {a, -1, -1, -1}});
}

int Graph::sum(int a, int b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  if (is_constant(a) && is_constant(b)) return constant(constant_at(a) + constant_at(b));
  return node({Operation::add, 0, {a, b, -1, -1}});
}

int Graph::difference(int a, int b) {
  if (is_zero(a)) return negative(b);
  if (is_zero(b)) return a;
  if (a == b) return whole(0);
  if (is_constant(a) && is_constant(b)) return constant(constant_at(a) - constant_at(b));
  return node({Operation::subtract, 0, {a, b, -1, -1}});
}

int Graph::product(int a, int b) {
  if (is_zero(a)) return a;
  if (is_zero(b)) return b;
  if (is_whole(a, 1)) return b;
  if (is_whole(b, 1)) return a;
  if (is_constant(a) && is_constant(b)) return constant(constant_at(a) * constant_at(b));
  if (is_reciprocal(a, b) || is_reciprocal(b, a)) return whole(1);
  return node({Operation::multiply, 0, {a, b, -1, -1}});
}

int Graph::quotient(int a, int b) {
  if (is_zero(a) || is_whole(b, 1)) return a;
  return node({Operation::divide, 0, {a, b, -1, -1}});
}

/// Whether a is 1/b. So the slope of x log(x) has no 0/0 at x = 0.
bool Graph::is_reciprocal(int a, int b) const {
  const GraphNode& at = nodes_[static_cast<std::size_t>(a)];
  return at.operation == Operation::divide && at.operands[1] == b && is_whole(at.operands[0], 1);
}

int Graph::replaced(int of, const std::map<int, int>& by) {
  if (const auto found = by.find(of); found != by.end()) return found->second;
  GraphNode result = nodes_[static_cast<std::size_t>(of)];
  for (std::size_t i = 0; i < operand_count(result.operation); ++i)
    result.operands[i] = replaced(result.operands[i], by);
  return node(result);
}

int Graph::function(std::string_view name, int a) {
  return node({Operation::function, index_of(functions_of_one<double>, name), {a, -1, -1, -1}});
}

int Graph::derivative(int of, std::size_t input) {
  const auto index = static_cast<std::size_t>(of);
  std::vector<int>& known = derivatives_[input];
  if (index < known.size() && known[index] != unknown) return known[index];
  const GraphNode at = nodes_[index];
  const int result = derived(at, of, input);
  known.resize(std::max(known.size(), nodes_.size()), unknown);
  return known[index] = result;
}

int Graph::derived(const GraphNode& at, int self, std::size_t input) {
  const auto [a, b, yes, no] = at.operands;
  const auto slope = [&](int operand) { return derivative(operand, input); };
  switch (at.operation) {
    case Operation::input:
      return whole(at.index == static_cast<int>(input) ? 1 : 0);
    case Operation::constant:
      return whole(0);
    case Operation::add:
      return sum(slope(a), slope(b));
    case Operation::subtract:
      return difference(slope(a), slope(b));
    case Operation::multiply: {
      const int left = product(slope(a), b), right = product(a, slope(b));
      return sum(left, right);
    }
    case Operation::divide: {
      // (a' - (a/b) b')/b; all derivatives share 1/b
      const int numerator = difference(slope(a), product(self, slope(b)));
      return is_constant(b) ? quotient(numerator, b) : product(numerator, quotient(whole(1), b));
    }
    case Operation::negate:
      return negative(slope(a));
    case Operation::integer_power: {
      if (at.index == 0) return whole(0);
      const int lower = at.index == 1   ? whole(1)
                        : at.index == 2 ? a
                                        : node({Operation::integer_power, at.index - 1, {a, -1, -1, -1}});
      return product(product(whole(at.index), lower), slope(a));
    }
    case Operation::real_power: {
      // p x^(p-1) x' + x^p log(x) p'; at x = 0 the second term is 0 for p > 0
      const int base = slope(a), exponent = slope(b);
      int result = whole(0);
      if (!is_zero(base)) {
        const int lower = node({Operation::real_power, 0, {a, difference(b, whole(1)), -1, -1}});
        result = product(product(b, lower), base);
      }
      if (is_zero(exponent)) return result;
      const int logarithm = product(self, function("log", a));
      const int safe = node({Operation::choice, 0, {whole(0), self, logarithm, whole(0)}});
      return sum(result, product(safe, exponent));
    }
    case Operation::choice: {
      const int left = slope(yes), right = slope(no);
      return left == right ? left : node({Operation::choice, 0, {a, b, left, right}});
    }
    case Operation::function: {
      const int inner = slope(a);
      return is_zero(inner) ? inner : product(derived_function(function_name(at), a, self), inner);
    }
    case Operation::function_of_two: {
      const std::string_view name = function_name(at);
      const int first = slope(a), second = slope(b);
      if (first == second && name != "atan2") return first;
      if (name == "min") return node({Operation::choice, 0, {b, a, second, first}});
      if (name == "max") return node({Operation::choice, 0, {a, b, second, first}});
      // atan2(y, x): (x y' - y x')/(x^2 + y^2)
      const int numerator = difference(product(b, first), product(a, second));
      return quotient(numerator, sum(product(a, a), product(b, b)));
    }
    case Operation::albedo:
      return derived_albedo(at, input);
  }
  throw std::logic_error("an operation without a derivative");
}

/// With the derivatives by the logarithms of c and of alpha: their sum, by_c c'/c + by_alpha alpha'/alpha.
int Graph::derived_albedo(const GraphNode& at, std::size_t input) {
  int result = whole(0);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const int slope = derivative(at.operands[k], input);
    if (is_zero(slope)) continue;
    Albedo albedo = albedo_of(at.index);
    int& order = k == 0 ? albedo.by_c : albedo.by_alpha;
    if (++order > most_albedo_order) throw std::logic_error("a fourth derivative of an albedo");
    const int by_logarithm = node({Operation::albedo, index_of(albedo), at.operands});
    result = sum(result, product(by_logarithm, quotient(slope, at.operands[k])));
  }
  return result;
}

/// The slope of a function at x, where `self` is its value.
int Graph::derived_function(std::string_view name, int x, int self) {
  const int one = whole(1);
  const auto log_of = [&](int n) { return constant(log(Symbolic::number(std::to_string(n)))); };
  // 1/sqrt((1 - x)(1 + x))
  const auto arc = [&] { return quotient(one, function("sqrt", product(difference(one, x), sum(one, x)))); };
  // 2/sqrt(pi) exp(-x^2)
  const auto bell = [&] {
    const Symbolic scale = Symbolic::number("2") / sqrt(Symbolic::constant("pi"));
    return product(constant(scale), function("exp", negative(product(x, x))));
  };
  if (name == "exp") return self;
  if (name == "exp2") return product(self, log_of(2));
  if (name == "log") return quotient(one, x);
  if (name == "log2") return quotient(one, product(x, log_of(2)));
  if (name == "expm1") return function("exp", x);
  if (name == "log1p") return quotient(one, sum(one, x));
  if (name == "log1p_remainder") return negative(quotient(x, sum(one, x)));
  if (name == "erf") return bell();
  if (name == "erfc") return negative(bell());
  if (name == "sqrt") return quotient(one, sum(self, self));
  if (name == "sin") return function("cos", x);
  if (name == "cos") return negative(function("sin", x));
  if (name == "tan") return sum(one, product(self, self));
  if (name == "asin") return arc();
  if (name == "acos") return negative(arc());
  if (name == "atan") return quotient(one, sum(one, product(x, x)));
  if (name == "sinh") return function("cosh", x);
  if (name == "cosh") return function("sinh", x);
  if (name == "tanh") {
    const int inverse = quotient(one, function("cosh", x));
    return product(inverse, inverse);
  }
  if (name == "abs") return function("sign", x);
  if (name == "floor" || name == "sign") return whole(0);
  throw std::logic_error("a function without a derivative: " + std::string(name));
}

}  // namespace shadefit
