#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/study_proof/running_narrow.hpp"
#include "fit/tape/tape_program.hpp"
#include "reports/code/shader_code.hpp"

/// What a form may be on a device: its value in double, and how far a device may be from it.
namespace shadefit::device {

/// A function as `emit` writes it, in double, for many arguments at a time. The numbers are the decimals of
/// the code in that precision.
class FormInDouble {
 public:
  explicit FormInDouble(const ShaderFunction& function, ShaderPrecision precision = ShaderPrecision::float32);

  /// `arguments` has for each argument a pointer to `count` numbers, at most `most`. Several threads may call
  /// it.
  void operator()(std::span<const double* const> arguments, double* results, std::size_t count) const;
  static constexpr std::size_t most = 1024;

 private:
  Tape tape_;
  std::vector<double> constants_;  ///< each of them `most` times
};

/// Bounds |computed - real| of the same function on a device, in float or in half: `RunningNarrow` with its
/// model.
template <class Format = FloatFormat>
class FormBound {
 public:
  FormBound(const ShaderFunction& function, const GpuModel& gpu);

  /// At all numbers of the format whose arguments lie in a box. A rounding of the real value to double is
  /// included.
  double on(std::span<const Domain> box);

 private:
  GpuModel gpu_;
  TapeProgram<RunningNarrow<Format>> program_;
};

extern template class FormBound<FloatFormat>;
extern template class FormBound<HalfFormat>;

/// The floats of [0, 1], cut into panels on which a bound is sharp to a few percent: [first, next panel's).
/// Each has 1/64 of a power of two of c and of 1 - c; both count, as forms vanish at both ends.
std::vector<std::uint32_t> unit_panels();

/// A bound for each panel, for a function of one argument.
std::vector<double> bounds_on(std::span<const std::uint32_t> panels, const ShaderFunction& function,
                              const GpuModel& gpu);

/// Whether a device's result is a number within a bound of the real value.
inline bool is_within(float result, double real, double bound) {
  return std::abs(static_cast<double>(result) - real) <= bound;
}

}  // namespace shadefit::device
