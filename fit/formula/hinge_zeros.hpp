#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/scalars/rounded_interval.hpp"

/// The zeros of the parts at which a formula is not smooth.
namespace shadefit {

/// A place where some formula of a study is not smooth in a variable.
struct StudyEdge {
  double at;
  int power = 1;         ///< the formula is smooth in this root of the distance
  bool is_jump = false;  ///< whether it has another value on each side, and perhaps a third one here
};

/// How close to a root or a logarithm the nodes go.
inline constexpr int power_at_root = 8;

/// A formula along one variable. The other variables have given values.
class HingeCurve {
 public:
  /// `variables` are that variable and then the others.
  HingeCurve(const Symbolic& formula, std::span<const std::string> variables)
      : program_(tape_of(formula, variables, 1), {}),
        enclosed_(program_.tape(), {}),
        values_(variables.size()),
        is_smooth_(hinges_of(formula).empty()) {}

  /// Gives the other variables their values.
  void set_others(std::span<const long double> values) {
    std::copy(values.begin(), values.end(), values_.begin() + 1);
  }

  double value(double x) {
    values_.front() = x;
    program_.run(values_);
    return program_.output(0);
  }
  double slope(double x) {
    value(x);
    return program_.output(1);
  }
  /// What enclosures tell of a range.
  struct Range {
    bool may_be_zero;  ///< whether some value is 0 or rounding
    bool is_monotone;  ///< certainly
  };
  Range range(double lower, double upper) {
    std::vector<Enclosure> inputs(values_.begin(), values_.end());
    inputs.front() = Enclosure(lower, upper);
    enclosed_.run(inputs);
    const auto has_zero = [&](std::size_t i) {
      return enclosed_.output(i).lower() <= 0 && 0 <= enclosed_.output(i).upper();
    };
    return {has_zero(0), is_smooth_ && !has_zero(1)};
  }

 private:
  using Enclosure = RoundedInterval<OutwardArithmetic>;

  TapeProgram<double> program_;
  TapeProgram<Enclosure> enclosed_;
  std::vector<double> values_;
  bool is_smooth_;
};

/// Appends the zeros of a hinge on a range as edges; `part` is its formula. The search looks at 592 places,
/// so it can miss two zeros that are closer.
void append_zeros(const Hinge& hinge, HingeCurve& part, double lower, double upper,
                  std::vector<StudyEdge>& edges);

}  // namespace shadefit
