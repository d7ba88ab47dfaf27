#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fit/formula/tape.hpp"

namespace shadefit {

/// A tape with its table in one scalar, for many places one after the other.
template <class T>
class TapeProgram {
 public:
  /// `parameters` are inputs after the variables.
  TapeProgram(Tape tape, std::span<const T> parameters)
      : tape_(std::move(tape)),
        values_(tape_.register_count() + tape_.input_count() - parameters.size(), integer<T>(0)) {
    values_.insert(values_.end(), parameters.begin(), parameters.end());
    for (const T& constant : tape_.constants<T>()) values_.push_back(constant);
    for (T& value : values_) table_.push_back(&value);
    for (std::size_t i = 0; i < tape_.register_count(); ++i) registers_.push_back(&values_[i]);
  }
  // The table points into the values. A vector that moves keeps them where they are.
  TapeProgram(TapeProgram&&) = default;
  TapeProgram(const TapeProgram&) = delete;
  TapeProgram& operator=(const TapeProgram&) = delete;

  /// Computes the outputs for the variables.
  void run(std::span<const T> variables);
  const Tape& tape() const { return tape_; }
  const T& output(std::size_t i) const { return values_[tape_.output(i)]; }

 private:
  Tape tape_;
  std::vector<T> values_;  ///< registers, inputs, constants
  std::vector<const T*> table_;
  std::vector<T*> registers_;
};

template <class T>
void TapeProgram<T>::run(std::span<const T> variables) {
  std::copy(variables.begin(), variables.end(),
            values_.begin() + static_cast<std::ptrdiff_t>(tape_.register_count()));
  tape_.run_over<T>(table_, registers_, 1);
}

// Fits spend much of their time here: one copy, optimised as tape.cpp is.
extern template void TapeProgram<double>::run(std::span<const double>);
extern template void TapeProgram<long double>::run(std::span<const long double>);

/// The tape of a formula of variables. Its outputs are the formula and the derivatives by the first `slopes`
/// of the variables.
Tape tape_of(const Symbolic& formula, std::span<const std::string> variables, std::size_t slopes = 0);

}  // namespace shadefit
