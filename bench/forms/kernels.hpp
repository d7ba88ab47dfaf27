#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Every form over arrays, in each arithmetic.
namespace shadefit::forms {

/// The inputs of a form at places: the cosines, or the cosines and the codes of their gloss, or the normals'
/// x, y and z. There may be more of them than the form reads.
template <class Real>
using Inputs = std::vector<std::vector<Real>>;

/// The values of a form at places. `parameters` are its constants in the order of its formula, those of the
/// target (the exponent, the lights) before those of the form.
template <class Real>
using Kernel = std::vector<Real> (*)(const Inputs<Real>& in, std::span<const Real> parameters);

/// A form and its exp2. Where the form has no such kernel, the pointer is null.
struct FormKernels {
  std::string_view form;  ///< the id of a form of the catalogue (bench/forms/catalogue.hpp)
  int exp2_degree = 0;    ///< of the polynomial in its exp2; 0: the library's, or none
  Kernel<float> in_float = nullptr;
  Kernel<double> in_double = nullptr;
  // Only of degree 0. The functions of the first two are the same on every machine: they are evaluated in
  // long double and rounded once.
  Kernel<float> exact_float = nullptr;
  Kernel<double> exact_double = nullptr;
  Kernel<Eigen::half> in_half = nullptr;
  Kernel<long double> in_long_double = nullptr;
  Kernel<Symbolic> in_symbols = nullptr;  ///< its results are formulas
};

/// The kernels of a form, first those with the exp2 of the library. Empty for an unknown form.
std::span<const FormKernels> kernels_of(std::string_view form);

}  // namespace shadefit::forms
