#include "fit/formula/batch.hpp"

#include <concepts>

namespace shadefit {

StagedTape::Cuts StagedTape::cuts(const Graph& graph, std::span<const int> outputs, std::size_t variables) {
  const auto nodes = graph.nodes();
  // What each node depends on. Operands stand before their nodes.
  std::vector<bool> on_variables(nodes.size()), on_parameters(nodes.size());
  Cuts result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const GraphNode& node = nodes[i];
    if (node.operation == Operation::input) {
      const bool is_variable = static_cast<std::size_t>(node.index) < variables;
      (is_variable ? on_variables : on_parameters)[i] = true;
    }
    for (std::size_t k = 0; k < operand_count(node.operation); ++k) {
      const auto operand = static_cast<std::size_t>(node.operands[k]);
      if (on_variables[operand]) on_variables[i] = true;
      if (on_parameters[operand]) on_parameters[i] = true;
    }
  }
  // Inputs in their order; one that nothing needs has no node.
  for (std::size_t input = 0; input < graph.inputs().size(); ++input) {
    const GraphNode wanted{Operation::input, static_cast<int>(input)};
    const auto found = std::find(nodes.begin(), nodes.end(), wanted);
    const int node = found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
    (input < variables ? result.variables : result.parameters).push_back(node);
  }
  std::vector<bool> is_needed(nodes.size());
  std::vector<int> pending(outputs.begin(), outputs.end());
  while (!pending.empty()) {
    const auto i = static_cast<std::size_t>(pending.back());
    pending.pop_back();
    if (is_needed[i]) continue;
    is_needed[i] = true;
    if (on_variables[i] != on_parameters[i]) continue;
    for (std::size_t k = 0; k < operand_count(nodes[i].operation); ++k)
      pending.push_back(nodes[i].operands[k]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_needed[i] || on_variables[i] == on_parameters[i]) continue;
    (on_variables[i] ? result.from_variables : result.from_parameters).push_back(static_cast<int>(i));
  }
  return result;
}

namespace {

std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The table of a tape after its program ran at places, a row of `packs` packs for each register, each
/// variable, each parameter, and each constant.
template <class T>
std::vector<typename Batch<T>::S> run_at(const Tape& tape, std::span<const std::vector<T>> coordinates,
                                         std::span<const T> parameters, std::size_t packs) {
  using S = typename Batch<T>::S;
  const std::vector<S> constants = tape.constants<S>();
  const std::size_t rows = tape.register_count() + tape.input_count() + constants.size();
  std::vector<S> values;
  values.reserve(rows * packs);
  values.resize(tape.register_count() * packs);
  for (const auto& of_variable : coordinates)
    Batch<T>::append_packed(of_variable, of_variable.back(), values);
  for (const T& parameter : parameters) values.insert(values.end(), packs, S(parameter));
  for (const S& constant : constants) values.insert(values.end(), packs, constant);
  std::vector<const S*> table;
  std::vector<S*> registers;
  for (std::size_t i = 0; i < rows; ++i) table.push_back(&values[i * packs]);
  for (std::size_t i = 0; i < tape.register_count(); ++i) registers.push_back(&values[i * packs]);
  tape.run_over<S>(table, registers, packs);
  return values;
}

}  // namespace

StagedTape::StagedTape(const Graph& graph, std::span<const int> outputs, const Cuts& cuts)
    : of_variables_(graph, cuts.from_variables, cuts.variables),
      of_parameters_(graph, cuts.from_parameters, cuts.parameters),
      of_both_(graph, outputs, joined(cuts.from_variables, cuts.from_parameters)) {}

template <class T>
std::size_t Batch<T>::packs_of(std::size_t nodes) {
  constexpr std::size_t group = std::same_as<T, double> ? WideLoops::group : 1;
  constexpr std::size_t size = group * lanes;
  return (nodes + size - 1) / size * group;
}

template <class T>
void Batch<T>::append_packed(std::span<const T> numbers, T beyond, std::vector<S>& packs) {
  const std::size_t first = packs.size(), full = numbers.size() / lanes;
  packs.resize(first + packs_of(numbers.size()));
  std::array<T, lanes> group;
  for (std::size_t pack = 0; first + pack < packs.size(); ++pack) {
    for (std::size_t l = 0; l < lanes; ++l)
      group[l] = pack < full || pack * lanes + l < numbers.size() ? numbers[pack * lanes + l] : beyond;
    packs[first + pack] = Lanes::joined(group);
  }
}

template <class T>
Batch<T>::Batch(const StagedTape& tape, std::span<const std::vector<T>> coordinates)
    : tape_(&tape),
      nodes_(coordinates.front().size()),
      packs_(packs_of(nodes_)),
      of_parameters_(tape.of_parameters(), {}) {
  const Tape& first = tape.of_variables();
  const std::vector<S> table = run_at<T>(first, coordinates, {}, packs_);
  for (std::size_t i = 0; i < first.output_count(); ++i)
    prepared_.emplace_back(&table[first.output(i) * packs_], &table[first.output(i) * packs_] + packs_);

  const Tape& rest = tape.of_both();
  for (const S& constant : rest.constants<S>()) constants_.insert(constants_.end(), block, constant);
  const std::size_t uniform = tape.of_parameters().output_count();
  values_.resize((rest.register_count() + uniform) * block);
  for (std::size_t i = 0; i < rest.register_count(); ++i) registers_.push_back(&values_[i * block]);
  table_.assign(registers_.begin(), registers_.end());
  table_.resize(table_.size() + prepared_.size());
  for (std::size_t i = 0; i < uniform; ++i) table_.push_back(&values_[(rest.register_count() + i) * block]);
  for (std::size_t i = 0; i < constants_.size(); i += block) table_.push_back(&constants_[i]);
  for (std::size_t i = 0; i < rest.output_count(); ++i) outputs_.push_back(nullptr);
}

std::vector<double> values_at(const Tape& tape, std::span<const std::vector<double>> coordinates,
                              std::span<const double> parameters) {
  using Lanes = Batch<double>::Lanes;
  std::vector<double> result(coordinates.front().size());
  const std::size_t packs = Batch<double>::packs_of(result.size());
  const std::vector<TwoLanes> table = run_at<double>(tape, coordinates, parameters, packs);
  const TwoLanes* row = &table[tape.output(0) * packs];
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = Lanes::lane(row[i / Lanes::size], i % Lanes::size);
  return result;
}

template class Batch<double>;
template class Batch<long double>;

}  // namespace shadefit
