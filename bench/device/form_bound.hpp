#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fit/bounds/running_narrow.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "reports/code/shader_code.hpp"

/// The value of a form in double, and how far a device's result may be from it.
namespace shadefit::device {

/// The function that `emit` writes: its constants are the decimals of the code in that precision. In double,
/// `values_at` has its values (fit/formula/batch.hpp).
Tape tape_of_code(const ShaderFunction& function, ShaderPrecision precision = ShaderPrecision::float32);

/// Bounds |computed - real| of the same function on a device, in float or in half: `RunningNarrow` with its
/// model.
template <class Format = FloatFormat>
class FormBound {
 public:
  FormBound(const ShaderFunction& function, const GpuModel& gpu);

  /// The bound for all arguments of the format in a box. It includes the rounding of the real value to
  /// double.
  double on(std::span<const Domain> box);

 private:
  GpuModel gpu_;
  TapeProgram<RunningNarrow<Format>> program_;
};

extern template class FormBound<FloatFormat>;
extern template class FormBound<HalfFormat>;

/// The floats of [0, 1], cut into panels on which a bound is sharp to a few percent. The result has the first
/// float of each. A panel spans 1/64 of a power of two of c and of 1 - c, because forms vanish at both ends.
std::vector<std::uint32_t> unit_panels();

/// A bound for each panel, for a function of one argument.
std::vector<double> bounds_on(std::span<const std::uint32_t> panels, const ShaderFunction& function,
                              const GpuModel& gpu);

}  // namespace shadefit::device
