#include "fit/formula/tape.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/rounded_once.hpp"

namespace shadefit {
namespace {

/// A decimal of at most 18 digits without an exponent: its digits and a power of ten are long doubles, so
/// that their quotient is rounded once. Empty for another text.
std::optional<long double> short_decimal(const std::string& text) {
  constexpr std::size_t most_letters = 18;
  long double digits = 0, unit = 1;
  bool is_behind_point = false;
  if (text.size() > most_letters) return std::nullopt;
  for (const char letter : text) {
    if (letter == '.' && !is_behind_point) {
      is_behind_point = true;
    } else if ('0' <= letter && letter <= '9') {
      digits = 10 * digits + static_cast<long double>(letter - '0');
      if (is_behind_point) unit *= 10;
    } else {
      return std::nullopt;
    }
  }
  return digits / unit;
}

long double rounded_constant(const Symbolic& expression) {
  const bool is_number = expression.kind() == Symbolic::Kind::number;
  if (const auto value = is_number ? short_decimal(expression.name()) : std::nullopt) return *value;
  return rounded_once(expression);
}

/// How many times outputs, and the nodes that they need, use each node. What is given needs no others.
std::vector<int> uses_of(const Graph& graph, std::span<const int> outputs, const std::vector<int>& input_of) {
  std::vector<int> uses(graph.nodes().size());
  std::vector<int> pending(outputs.begin(), outputs.end());
  while (!pending.empty()) {
    const auto i = static_cast<std::size_t>(pending.back());
    pending.pop_back();
    if (++uses[i] > 1 || input_of[i] >= 0) continue;
    const GraphNode& node = graph.nodes()[i];
    for (std::size_t k = 0; k < operand_count(node.operation); ++k) pending.push_back(node.operands[k]);
  }
  return uses;
}

}  // namespace

Tape::Tape(const Graph& graph, std::span<const int> outputs, std::span<const int> given)
    : input_count_(given.size()) {
  std::vector<int> input_of(graph.nodes().size(), -1);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] >= 0) input_of[static_cast<std::size_t>(given[i])] = static_cast<int>(i);
  }
  std::vector<int> uses = uses_of(graph, outputs, input_of);

  // Inputs and constants get their places after the registers, which are counted first: until then they are
  // negative, -1 for the first.
  std::vector<int> place(graph.nodes().size());
  std::vector<int> free_registers;
  const auto take_register = [&] {
    if (free_registers.empty()) return static_cast<int>(register_count_++);
    const int result = free_registers.back();
    free_registers.pop_back();
    return result;
  };
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i] == 0) continue;
    if (input_of[i] >= 0) {
      place[i] = -1 - input_of[i];
      continue;
    }
    const GraphNode& node = graph.nodes()[i];
    if (node.operation == Operation::input) throw std::logic_error("a tape needs an input that is not given");
    if (node.operation == Operation::constant) {
      place[i] = -1 - static_cast<int>(input_count_ + constants_.size());
      constants_.push_back(graph.constants()[static_cast<std::size_t>(node.index)]);
      rounded_constants_.push_back(rounded_constant(constants_.back()));
      continue;
    }
    Instruction step{node.operation, node.index, {-1, -1, -1, -1}, 0};
    for (std::size_t k = 0; k < operand_count(node.operation); ++k)
      step.from[k] = place[static_cast<std::size_t>(node.operands[k])];
    // The result has its own register: a loop over many places may not overwrite its operands.
    step.to = take_register();
    place[i] = step.to;
    code_.push_back(step);
    for (std::size_t k = 0; k < operand_count(node.operation); ++k) {
      const auto operand = static_cast<std::size_t>(node.operands[k]);
      if (--uses[operand] == 0 && place[operand] >= 0) free_registers.push_back(place[operand]);
    }
  }
  const auto final_place = [&](int p) { return p >= 0 ? p : static_cast<int>(register_count_) - 1 - p; };
  for (Instruction& step : code_) {
    for (std::size_t k = 0; k < operand_count(step.operation); ++k) step.from[k] = final_place(step.from[k]);
  }
  for (const int output : outputs) outputs_.push_back(final_place(place[static_cast<std::size_t>(output)]));
}

template void TapeProgram<double>::run(std::span<const double>);
template void TapeProgram<long double>::run(std::span<const long double>);

Tape tape_of(const Symbolic& formula, std::span<const std::string> variables, std::size_t slopes) {
  Graph graph(variables);
  std::vector<int> outputs{graph.add(formula)};
  for (std::size_t i = 0; i < slopes; ++i) outputs.push_back(graph.derivative(outputs.front(), i));
  return {graph, outputs};
}

}  // namespace shadefit
