#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// The timed kernels: a form over an array, compiled for one register width.
namespace shadefit::forms {

/// The register width and its instruction set.
enum class Width { scalar, sse2, avx2, avx512 };

/// The arrays of a kernel. Arrays that a target does not use are null.
template <class Real>
struct Arrays {
  std::array<const Real*, 3> in{};      ///< the cosines; of a target with lights the normal's x, y and z
  const std::uint8_t* codes = nullptr;  ///< the 8-bit gloss of each element
  Real* out = nullptr;
  std::size_t size = 0;  ///< a multiple of 64, so no width has a remainder
};

/// A form over arrays. `parameters` are its constants in the order of its formula, those of the target (the
/// exponent, the lights) before those of the form.
template <class Real>
using Kernel = void (*)(const Arrays<Real>&, std::span<const Real> parameters);

/// A form, its exp2, and the register width that it needs.
struct CompiledForm {
  std::string_view
      form;  ///< the id of a form of the catalogue (bench/forms/catalogue.hpp), "copy" or "multiply-adds"
  int exp2_degree = 0;  ///< of the polynomial in its exp2; 0: the library's, or none
  Kernel<float> in_float = nullptr;
  Kernel<double> in_double = nullptr;
};

/// Every form compiled for a width. Do not call its kernels if `widths_here` lacks that width: each is in its
/// own unit, compiled with the instructions of that width.
std::span<const CompiledForm> compiled_forms(Width width);

/// The widths that this machine supports, narrowest first.
std::vector<Width> widths_here();

std::string_view name(Width width);

}  // namespace shadefit::forms
