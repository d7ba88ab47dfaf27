#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "approx/scalar.hpp"
#include "fit/scalars/albedo_in.hpp"
#include "fit/scalars/functions.hpp"

/// The symbolic scalar: a formula that runs on it returns its own expression. The expression can be printed
/// and evaluated in any other scalar, and its operations can be counted.
namespace shadefit {

/// An expression: an immutable tree, cheap to copy.
class Symbolic {
 public:
  enum class Kind {
    variable,       ///< `name`
    number,         ///< `name` is its decimal text
    constant,       ///< `name` is pi or ln2
    add,            ///< parts 0 + 1, and so on
    subtract,       ///<
    multiply,       ///<
    divide,         ///<
    negate,         ///<
    function,       ///< `name` of parts 0, or of 0 and 1; also an albedo (fit/truths/albedos.hpp)
    real_power,     ///< part 0 to the power of part 1, part 0 not negative
    integer_power,  ///< part 0 to the power `exponent`
    choice,         ///< part 0 < part 1 ? part 2 : part 3
    integral,       ///< of part 0 over the variable `name` from part 1 to part 2 (fit/scalars/integral.hpp)
  };

  static Symbolic variable(std::string_view name) { return {Kind::variable, std::string(name), {}}; }
  static Symbolic number(std::string_view decimal) { return {Kind::number, std::string(decimal), {}}; }
  static Symbolic constant(std::string_view name) { return {Kind::constant, std::string(name), {}}; }
  static Symbolic operation(Kind kind, std::vector<Symbolic> parts) { return {kind, "", std::move(parts)}; }
  static Symbolic function(std::string_view name, std::vector<Symbolic> parts) {
    return {Kind::function, std::string(name), std::move(parts)};
  }
  static Symbolic integral(std::string_view variable, std::vector<Symbolic> parts) {
    return {Kind::integral, std::string(variable), std::move(parts)};
  }
  static Symbolic integer_power(const Symbolic& x, int n) {
    return {Kind::integer_power, std::to_string(n), {x}};
  }

  /// The same operation of other parts.
  Symbolic with_parts(std::vector<Symbolic> parts) const { return {kind(), name(), std::move(parts)}; }

  Kind kind() const { return node_->kind; }
  const std::string& name() const { return node_->name; }
  int exponent() const { return std::stoi(node_->name); }
  const std::vector<Symbolic>& parts() const { return node_->parts; }
  const Symbolic& part(std::size_t i) const { return node_->parts.at(i); }
  /// The depth: operations inside one another; 0 for a number or a name.
  std::size_t depth() const { return node_->depth; }
  /// Whether no variable is inside, not even that of an integral.
  bool is_of_numbers() const { return node_->is_of_numbers; }

  friend Symbolic operator+(const Symbolic& a, const Symbolic& b) { return operation(Kind::add, {a, b}); }
  friend Symbolic operator-(const Symbolic& a, const Symbolic& b) {
    return operation(Kind::subtract, {a, b});
  }
  friend Symbolic operator*(const Symbolic& a, const Symbolic& b) {
    return operation(Kind::multiply, {a, b});
  }
  friend Symbolic operator/(const Symbolic& a, const Symbolic& b) { return operation(Kind::divide, {a, b}); }
  friend Symbolic operator-(const Symbolic& a) { return operation(Kind::negate, {a}); }

 private:
  struct Node {
    Kind kind;
    std::string name;
    std::vector<Symbolic> parts;
    std::size_t depth;
    bool is_of_numbers;
  };

  static std::size_t depth_over(const std::vector<Symbolic>& parts) {
    std::size_t depth = 0;
    for (const Symbolic& part : parts) depth = std::max(depth, part.depth() + 1);
    return depth;
  }

  Symbolic(Kind kind, std::string name, std::vector<Symbolic> parts) {
    const std::size_t depth = depth_over(parts);
    const bool is_of_numbers = kind != Kind::variable && std::ranges::all_of(parts, &Symbolic::is_of_numbers);
    node_ = std::make_shared<const Node>(Node{kind, std::move(name), std::move(parts), depth, is_of_numbers});
  }

  std::shared_ptr<const Node> node_;
};

/// The adapter: every function of the vocabulary is a node. A comparison is kept until `select` takes it.
template <>
struct Scalar<Symbolic> {
  struct Less {
    Symbolic a, b;
  };

  static Symbolic exp(const Symbolic& x) { return Symbolic::function("exp", {x}); }
  static Symbolic exp2(const Symbolic& x) { return Symbolic::function("exp2", {x}); }
  static Symbolic log(const Symbolic& x) { return Symbolic::function("log", {x}); }
  static Symbolic log2(const Symbolic& x) { return Symbolic::function("log2", {x}); }
  static Symbolic expm1(const Symbolic& x) { return Symbolic::function("expm1", {x}); }
  static Symbolic log1p(const Symbolic& x) { return Symbolic::function("log1p", {x}); }
  static Symbolic log1p_remainder(const Symbolic& x) { return Symbolic::function("log1p_remainder", {x}); }
  static Symbolic erfc(const Symbolic& x) { return Symbolic::function("erfc", {x}); }
  static Symbolic sqrt(const Symbolic& x) { return Symbolic::function("sqrt", {x}); }
  static Symbolic sin(const Symbolic& x) { return Symbolic::function("sin", {x}); }
  static Symbolic cos(const Symbolic& x) { return Symbolic::function("cos", {x}); }
  static Symbolic tan(const Symbolic& x) { return Symbolic::function("tan", {x}); }
  static Symbolic asin(const Symbolic& x) { return Symbolic::function("asin", {x}); }
  static Symbolic acos(const Symbolic& x) { return Symbolic::function("acos", {x}); }
  static Symbolic atan(const Symbolic& x) { return Symbolic::function("atan", {x}); }
  static Symbolic atan2(const Symbolic& y, const Symbolic& x) { return Symbolic::function("atan2", {y, x}); }
  static Symbolic sinh(const Symbolic& x) { return Symbolic::function("sinh", {x}); }
  static Symbolic cosh(const Symbolic& x) { return Symbolic::function("cosh", {x}); }
  static Symbolic tanh(const Symbolic& x) { return Symbolic::function("tanh", {x}); }
  static Symbolic erf(const Symbolic& x) { return Symbolic::function("erf", {x}); }
  static Symbolic floor(const Symbolic& x) { return Symbolic::function("floor", {x}); }
  static Symbolic abs(const Symbolic& x) { return Symbolic::function("abs", {x}); }
  static Symbolic sign(const Symbolic& x) { return Symbolic::function("sign", {x}); }
  static Symbolic power(const Symbolic& x, const Symbolic& p) {
    return Symbolic::operation(Symbolic::Kind::real_power, {x, p});
  }
  static Symbolic integer_power(const Symbolic& x, int n) { return Symbolic::integer_power(x, n); }
  static Less less(const Symbolic& a, const Symbolic& b) { return {a, b}; }
  static Symbolic select(const Less& condition, const Symbolic& a, const Symbolic& b) {
    return Symbolic::operation(Symbolic::Kind::choice, {condition.a, condition.b, a, b});
  }
  static Symbolic min(const Symbolic& a, const Symbolic& b) { return Symbolic::function("min", {a, b}); }
  static Symbolic max(const Symbolic& a, const Symbolic& b) { return Symbolic::function("max", {a, b}); }
  static Symbolic integer(int n) { return Symbolic::number(std::to_string(n)); }
  static Symbolic from_decimal(std::string_view decimal) { return Symbolic::number(decimal); }
  static Symbolic pi() { return Symbolic::constant("pi"); }
  static Symbolic ln2() { return Symbolic::constant("ln2"); }
};

/// The expression as a person writes it: products by a space, `exp2((a c + b) c)`, `(1 - c)^5`.
std::string to_text(const Symbolic& expression);

/// The expression for LaTeX's math mode: `2^{\left(a c + b\right) c}`.
std::string to_latex(const Symbolic& expression);

/// What a shader executes for an expression. Equal subexpressions are computed once. Subexpressions of
/// numbers are computed before the shader runs. A sign is free. A sum with a product that is used nowhere
/// else is one multiply-add. exp and log are exp2 and log2 with a multiplication; a real power is log2, a
/// multiplication and exp2; a whole power is repeated squaring.
struct Operations {
  int add = 0;           ///< additions and subtractions
  int multiply = 0;      ///<
  int multiply_add = 0;  ///<
  int divide = 0;        ///<
  int exp2 = 0;          ///<
  int log2 = 0;          ///<
  int other = 0;         ///< square roots, sines, minima, comparisons ..
  int dot3 = 0;          ///< sums of three products, if the processor has them
  int dot4 = 0;          ///< and of four
  int total() const { return add + multiply + multiply_add + divide + exp2 + log2 + other + dot3 + dot4; }
  bool operator==(const Operations&) const = default;
};

/// The operations of `a` that are not in `b`.
Operations operator-(const Operations& a, const Operations& b);

/// Special instructions of a processor.
struct InstructionSet {
  /// A sum of three products is one DOT3; one of four, or of three and a term (a product with 1), one DOT4.
  bool dot_products = false;
  /// A result used nowhere else times one of these is free, as the NV40 family's results are times 2, 4, 8,
  /// 1/2, 1/4 and 1/8 (its fragment programs have a field for it: Mesa, src/gallium/drivers/nouveau/nv30).
  std::vector<double> free_scales = {};
};

Operations count_operations(const Symbolic& expression, const InstructionSet& instructions = {});

/// Several results: common subexpressions are computed once.
Operations count_operations(std::span<const Symbolic> results, const InstructionSet& instructions = {});

/// "MAD, MUL, EXP2": each as many times as it is executed.
std::string to_text(const Operations& operations);

/// A node of the rule for integrals, in [0, 1], by its distance from the nearer end, and its weight.
template <class T>
struct IntegralNode {
  T distance;
  bool is_from_upper;
  T weight;
};

/// The usual rule; its numbers as decimal text.
const std::vector<IntegralNode<std::string>>& usual_integral_nodes();

/// An integral with its variables replaced, but for the one that it runs over.
Symbolic with_parts(const Symbolic& integral, const std::function<Symbolic(const std::string&)>& value_of);

template <class T, class ValueOf>
T evaluate(const Symbolic& expression, const ValueOf& value_of);

/// The value of an integral by the usual rule.
template <class T>
T value_of_integral(const Symbolic& e, const std::function<T(const std::string&)>& value_of) {
  static const std::vector<IntegralNode<T>> nodes = [] {
    std::vector<IntegralNode<T>> result;
    for (const auto& node : usual_integral_nodes())
      result.push_back({constant<T>(node.distance), node.is_from_upper, constant<T>(node.weight)});
    return result;
  }();
  const T lower = evaluate<T>(e.part(1), value_of), upper = evaluate<T>(e.part(2), value_of);
  const T length = upper - lower;
  T place = lower, sum = integer<T>(0);
  const std::function<T(const std::string&)> inside = [&](const std::string& name) {
    return name == e.name() ? place : value_of(name);
  };
  for (const IntegralNode<T>& node : nodes) {
    place = node.is_from_upper ? upper - length * node.distance : lower + length * node.distance;
    sum = sum + node.weight * evaluate<T>(e.part(0), inside);
  }
  return length * sum;
}

/// What evaluate() does, as a template for every scalar.
template <class T, class ValueOf>
T evaluated(const Symbolic& expression, const ValueOf& value_of) {
  using Kind = Symbolic::Kind;
  const auto part = [&](std::size_t i) { return evaluate<T>(expression.part(i), value_of); };
  const std::string& name = expression.name();
  switch (expression.kind()) {
    case Kind::variable:
      return value_of(name);
    case Kind::number:
      return constant<T>(name);
    case Kind::constant:
      return name == "pi" ? pi<T>() : ln2<T>();
    case Kind::add:
      return part(0) + part(1);
    case Kind::subtract:
      return part(0) - part(1);
    case Kind::multiply:
      return part(0) * part(1);
    case Kind::divide:
      return part(0) / part(1);
    case Kind::negate:
      return -part(0);
    case Kind::real_power:
      return power(part(0), part(1));
    case Kind::integer_power:
      return power(part(0), expression.exponent());
    case Kind::choice:
      return select(less(part(0), part(1)), part(2), part(3));
    case Kind::integral:
      if constexpr (std::same_as<T, Symbolic>) {
        return with_parts(expression, value_of);
      } else {
        return value_of_integral<T>(expression, value_of);
      }
    case Kind::function:
      break;
  }
  if (expression.parts().size() == 1) {
    if (const auto* function = find_function(functions_of_one<T>, name)) return (*function)(part(0));
  } else if (const auto* function = find_function(functions_of_two<T>, name)) {
    return (*function)(part(0), part(1));
  } else if (const auto albedo = find_albedo(name)) {
    if constexpr (std::same_as<T, Symbolic>) {
      return Symbolic::function(name, {part(0), part(1)});
    } else {
      return AlbedoIn<T>::value(*albedo, part(0), part(1));
    }
  }
  throw std::logic_error("a function outside the vocabulary: " + name);
}

/// The expression with an expression for each variable. It is compiled once, and not where it is called.
Symbolic substituted(const Symbolic& expression, const std::function<Symbolic(const std::string&)>& value_of);

/// The expression in the scalar T; `value_of(name)` gives a variable. An integral is computed by the usual
/// rule, so in intervals its value is no enclosure. Throws std::logic_error for a function that is not of the
/// vocabulary.
template <class T, class ValueOf>
T evaluate(const Symbolic& expression, const ValueOf& value_of) {
  if constexpr (std::same_as<T, Symbolic>) {
    return substituted(expression, value_of);
  } else {
    return evaluated<T>(expression, value_of);
  }
}

}  // namespace shadefit
