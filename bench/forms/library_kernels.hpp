#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "bench/forms/kernel.hpp"

/// The forms in additional arithmetics, only for their errors, not timed.
namespace shadefit::forms {

/// A form with the functions of `Library`, and in half, each operation of which is rounded.
struct LibraryForm {
  std::string_view form;
  Kernel<float> in_float;
  Kernel<double> in_double;
  Kernel<Eigen::half> in_half;
  Kernel<long double> in_long_double;
};

/// Every form, in the order of `AllForms`.
std::span<const LibraryForm> library_forms();

}  // namespace shadefit::forms
