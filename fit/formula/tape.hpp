#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "approx/scalar.hpp"
#include "fit/formula/graph.hpp"
#include "fit/formula/wide_loops.hpp"
#include "fit/scalars/functions.hpp"
#include "fit/scalars/two_lanes.hpp"

/// A formula as a flat program. It runs in every scalar, for one place or for many at a time.
namespace shadefit {

/// One operation on places of a table: registers first, then inputs, then constants.
struct Instruction {
  Operation operation;
  int index;
  std::array<int, 4> from;
  int to;
};

/// The constants of a graph in a scalar. They are computed in 50 digits and rounded once; a scalar that is
/// wider than that, or an interval, computes them itself.
template <class T>
T constant_as(const Symbolic& expression, long double rounded) {
  if constexpr (std::floating_point<T> || std::same_as<T, TwoLanes>) {
    return static_cast<T>(rounded);
  } else {
    return evaluate<T>(expression, [](const std::string&) { return integer<T>(0); });
  }
}

class Tape {
 public:
  /// The program that computes nodes of a graph from given nodes of it. What the outputs do not need is left
  /// out. Throws std::logic_error if an output needs an input of the graph that is not given.
  Tape(const Graph& graph, std::span<const int> outputs, std::span<const int> given);
  /// From all inputs of the graph.
  Tape(Graph& graph, std::span<const int> outputs) : Tape(graph, outputs, graph.input_nodes()) {}

  std::size_t input_count() const { return input_count_; }
  std::size_t output_count() const { return outputs_.size(); }
  std::size_t register_count() const { return register_count_; }

  template <class T>
  std::vector<T> constants() const {
    std::vector<T> result;
    for (std::size_t i = 0; i < constants_.size(); ++i)
      result.push_back(constant_as<T>(constants_[i], rounded_constants_[i]));
    return result;
  }

  /// Runs the program over `count` places. `table` has a pointer to that many numbers for each register, each
  /// input and each constant, in this order; `registers` has the first of them again, to be written.
  /// Afterwards the outputs stand at `table[output(i)]`.
  template <class T>
  void run_over(std::span<const T* const> table, std::span<T* const> registers, std::size_t count) const {
    for (const Instruction& step : code_) execute(step, table, registers, count);
  }

  std::size_t output(std::size_t i) const { return static_cast<std::size_t>(outputs_[i]); }

 private:
  template <class T>
  static void execute(const Instruction& step, std::span<const T* const> table, std::span<T* const> registers,
                      std::size_t count) {
    const auto operand = [&](std::size_t i) -> const T* {
      return table[static_cast<std::size_t>(step.from[i])];
    };
    T* result = registers[static_cast<std::size_t>(step.to)];
    if constexpr (std::same_as<T, TwoLanes>) {
      if (is_wide(step.operation) && count % WideLoops::group == 0) {
        const TwoLanes* a = operand(0);
        const TwoLanes* b = step.operation == Operation::negate ? a : operand(1);
        return wide_loops().combine(step.operation, a, b, result, count / WideLoops::group);
      }
      constexpr auto exp2_index = find_function(functions_of_one<T>, "exp2") - functions_of_one<T>.data();
      if (step.operation == Operation::function && step.index == exp2_index && count % WideLoops::group == 0)
        return wide_loops().exp2(operand(0), result, count / WideLoops::group);
    }
    const auto each = [&](const auto& value) {
      for (std::size_t i = 0; i < count; ++i) result[i] = value(i);
    };
    const auto by_two = [&](const auto& combine) {
      const T *a = operand(0), *b = operand(1);
      if constexpr (requires { Scalar<T>::put(*result, combine, *a, *b); }) {
        for (std::size_t i = 0; i < count; ++i) Scalar<T>::put(result[i], combine, a[i], b[i]);
      } else {
        each([&](std::size_t i) -> T { return combine(a[i], b[i]); });
      }
    };
    const auto index = static_cast<std::size_t>(step.index);
    switch (step.operation) {
      case Operation::add:
        return by_two(std::plus<>{});
      case Operation::subtract:
        return by_two(std::minus<>{});
      case Operation::multiply:
        return by_two(std::multiplies<>{});
      case Operation::divide:
        return by_two(std::divides<>{});
      case Operation::real_power:
        return by_two([](const T& a, const T& b) -> T { return power(a, b); });
      case Operation::negate:
        return each([a = operand(0)](std::size_t i) -> T { return -a[i]; });
      case Operation::integer_power:
        return each([a = operand(0), n = step.index](std::size_t i) -> T { return power(a[i], n); });
      case Operation::choice:
        return each([a = operand(0), b = operand(1), yes = operand(2), no = operand(3)](std::size_t i) -> T {
          return select(less(a[i], b[i]), yes[i], no[i]);
        });
      case Operation::function:
        return functions_of_one<T>[index].over(operand(0), result, count);
      case Operation::function_of_two:
        return functions_of_two<T>[index].over(operand(0), operand(1), result, count);
      case Operation::albedo:
        return each([a = operand(0), b = operand(1), albedo = albedo_of(step.index)](std::size_t i) -> T {
          return AlbedoIn<T>::value(albedo, a[i], b[i]);
        });
      case Operation::input:
      case Operation::constant:
        return;  // they stand in the table
    }
  }

  std::vector<Instruction> code_;
  std::size_t register_count_ = 0;
  std::size_t input_count_ = 0;
  std::vector<int> outputs_;
  std::vector<Symbolic> constants_;
  std::vector<long double> rounded_constants_;
};

}  // namespace shadefit
