#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "fit/formula/tape.hpp"
#include "fit/formula/tape_program.hpp"

/// Functions of variables and parameters at many nodes at a time.
namespace shadefit {

/// Nodes of a graph in three parts: what depends on the variables alone is computed once for all parameters,
/// what depends on the parameters alone once for all nodes, and the rest at each node.
class StagedTape {
 public:
  /// The first `variables` inputs of the graph are variables, the others are parameters.
  StagedTape(const Graph& graph, std::span<const int> outputs, std::size_t variables)
      : StagedTape(graph, outputs, cuts(graph, outputs, variables)) {}

  const Tape& of_variables() const { return of_variables_; }
  const Tape& of_parameters() const { return of_parameters_; }
  /// Its inputs are the outputs of the first two, in this order.
  const Tape& of_both() const { return of_both_; }

 private:
  struct Cuts {
    std::vector<int> variables, parameters;            ///< the graph's inputs
    std::vector<int> from_variables, from_parameters;  ///< what the rest needs
  };
  static Cuts cuts(const Graph& graph, std::span<const int> outputs, std::size_t variables);
  StagedTape(const Graph& graph, std::span<const int> outputs, const Cuts& cuts);

  Tape of_variables_, of_parameters_, of_both_;
};

/// A staged tape at given nodes. In double the two nodes of a pack are computed together. It has its own
/// working memory, so one thread uses it at a time.
template <class T>
class Batch {
 public:
  using Lanes = SideBySide<T>;
  using S = typename Lanes::Type;
  static constexpr std::size_t lanes = Lanes::size;
  /// The most packs of a visit: as many as fit into a small cache with the registers of a formula.
  static constexpr std::size_t block = 64;
  static_assert(block == WideLoops::group * WideLoops::most_groups);

  /// `coordinates`: for each variable its value at each node. The last one is repeated until the packs
  /// are full.
  Batch(const StagedTape& tape, std::span<const std::vector<T>> coordinates);
  // The tables point into the values. A vector that moves keeps them where they are.
  Batch(Batch&&) = default;
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  /// The packs of so many nodes. In double whole groups of `WideLoops`.
  static std::size_t packs_of(std::size_t nodes);
  /// Appends numbers in packs, and `beyond` until they are full.
  static void append_packed(std::span<const T> numbers, T beyond, std::vector<S>& packs);

  std::size_t nodes() const { return nodes_; }

  /// Calls `visit` for some packs after the others, with their first one, their number, and for each output a
  /// pointer to that many results.
  template <class Visit>
  void visit(std::span<const T> parameters, const Visit& visit) const;

 private:
  const StagedTape* tape_;
  std::size_t nodes_, packs_;
  std::vector<std::vector<S>> prepared_;  ///< by output of `of_variables`
  std::vector<S> constants_;              ///< of `of_both`, each `block` times
  // Working memory: the registers of `of_both` and what depends on the parameters alone, each `block` times.
  mutable std::vector<S> values_, given_;
  mutable std::vector<const S*> table_, outputs_;
  mutable std::vector<S*> registers_;
  mutable TapeProgram<S> of_parameters_;
};

template <class T>
template <class Visit>
void Batch<T>::visit(std::span<const T> parameters, const Visit& visit) const {
  const Tape& rest = tape_->of_both();
  given_.assign(parameters.begin(), parameters.end());
  of_parameters_.run(given_);
  const std::size_t used = std::min(block, packs_);
  for (std::size_t i = 0; i < tape_->of_parameters().output_count(); ++i)
    std::fill_n(&values_[(rest.register_count() + i) * block], used, of_parameters_.output(i));
  for (std::size_t from = 0; from < packs_; from += block) {
    const std::size_t count = std::min(block, packs_ - from);
    for (std::size_t i = 0; i < prepared_.size(); ++i)
      table_[rest.register_count() + i] = prepared_[i].data() + from;
    rest.run_over<S>(table_, registers_, count);
    for (std::size_t i = 0; i < outputs_.size(); ++i) outputs_[i] = table_[rest.output(i)];
    visit(from, count, std::span<const S* const>(outputs_));
  }
}

/// The first output of a tape at places: `coordinates` has for each variable its value at each of them;
/// `parameters` are inputs after the variables.
std::vector<double> values_at(const Tape& tape, std::span<const std::vector<double>> coordinates,
                              std::span<const double> parameters);

extern template class Batch<double>;
extern template class Batch<long double>;

}  // namespace shadefit
