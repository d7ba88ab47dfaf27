#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/integral.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/truths/albedos.hpp"

/// Formulas as one graph, in which each subexpression stands once, and their derivatives.
namespace shadefit {

/// An operation of a graph or a tape.
enum class Operation : unsigned char {
  input,            ///< `index` among the inputs
  constant,         ///< `index` among the constants
  add,              ///<
  subtract,         ///<
  multiply,         ///<
  divide,           ///<
  negate,           ///<
  real_power,       ///<
  integer_power,    ///< of operand 0 to the power `index`
  choice,           ///< operand 0 < operand 1 ? operand 2 : operand 3
  function,         ///< `index` in `functions_of_one`
  function_of_two,  ///< `index` in `functions_of_two`
  albedo,           ///< of operands 0 and 1; `index` is `index_of(Albedo)`
};

/// An albedo and the orders of its derivatives as one number.
int index_of(const Albedo& albedo);
Albedo albedo_of(int index);

/// The number of operands of an operation.
std::size_t operand_count(Operation operation);

/// A node of a graph. Operands are earlier nodes.
struct GraphNode {
  Operation operation;
  int index = 0;
  std::array<int, 4> operands{-1, -1, -1, -1};
  auto operator<=>(const GraphNode&) const = default;
};

/// The name of a function; empty for any other operation.
std::string_view function_name(const GraphNode& node);

class Graph {
 public:
  /// Integrals are computed by this rule.
  explicit Graph(std::span<const std::string> inputs, IntegralRule rule = IntegralRule::usual)
      : inputs_(inputs.begin(), inputs.end()), rule_(rule), derivatives_(inputs.size()) {}

  /// The node of an expression. Its variables are inputs of the graph. An expression of numbers alone becomes
  /// one constant. Throws std::logic_error for a variable that is no input.
  int add(const Symbolic& expression);

  /// The node of the derivative of a node by an input. A derivative that is 0 for every value is the constant
  /// 0: `is_zero` says so. At a kink it is that of one side.
  int derivative(int node, std::size_t input);

  bool is_zero(int node) const { return node == zero_; }

  // Operations with the simplifications that a derivative needs: of 0, of 1, and of two constants.
  int difference(int a, int b);
  int product(int a, int b);
  int quotient(int a, int b);

  /// The node of a formula with other nodes in place of some of its nodes.
  int replaced(int node, const std::map<int, int>& by);

  std::span<const GraphNode> nodes() const { return nodes_; }
  std::span<const std::string> inputs() const { return inputs_; }
  /// The node of each input.
  std::vector<int> input_nodes();
  /// Expressions of numbers alone.
  std::span<const Symbolic> constants() const { return constants_; }

 private:
  int node(const GraphNode& wanted);
  int constant(const Symbolic& value);
  int whole(int n) { return n == 0 && zero_ >= 0 ? zero_ : constant(Symbolic::number(std::to_string(n))); }
  bool is_whole(int node, int n) const;
  bool is_constant(int node) const;
  bool is_reciprocal(int a, int b) const;
  const Symbolic& constant_at(int node) const;

  int sum(int a, int b);
  int negative(int a);
  int function(std::string_view name, int a);

  int derived(const GraphNode& node, int self, std::size_t input);
  int derived_function(std::string_view name, int x, int self);
  int derived_albedo(const GraphNode& node, std::size_t input);

  std::vector<std::string> inputs_;
  IntegralRule rule_;
  std::vector<GraphNode> nodes_;
  std::map<GraphNode, int> known_;
  std::vector<Symbolic> constants_;
  std::map<std::string, int> constant_of_;  ///< by text
  static constexpr int unknown = -1;
  std::vector<std::vector<int>> derivatives_;  ///< by input and node
  int zero_ = -1;
};

}  // namespace shadefit
