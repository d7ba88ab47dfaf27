#pragma once

#include <array>
#include <string_view>

#include "approx/scalar.hpp"

/// Instruction counts: what a form costs, counted from the formula itself by the symbolic scalar.
namespace shadefit {

/// `mip_level_of_power` from a stored s + 1: log2(w sqrt(3)) - 1/2 log2(s + 1).
template <class T>
T mip_level_of_successor(const T& width, const T& exponent_plus_one) {
  const T half = integer<T>(1) / integer<T>(2);
  return log2(width * sqrt(integer<T>(3))) - half * log2(exponent_plus_one);
}

/// The part of a Phong highlight by the spherical Gaussian that depends on the view: (A r, -A), r the
/// reflected view vector. Source: Lagarde 2012.
template <class T>
std::array<T, 4> scaled_reflection(const std::array<T, 3>& reflected, const T& base_two) {
  return {base_two * reflected[0], base_two * reflected[1], base_two * reflected[2], -base_two};
}

/// The highlight of a light in the direction l: exp2((A r, -A) . (l, 1)) = exp2(A r.l - A).
template <class T>
T phong_by_exp2(const std::array<T, 4>& scaled, const std::array<T, 3>& light) {
  return exp2(scaled[0] * light[0] + scaled[1] * light[1] + scaled[2] * light[2] + scaled[3]);
}

/// r.l, the cosine of the Phong angle.
template <class T>
T phong_cosine(const std::array<T, 3>& reflected, const std::array<T, 3>& light) {
  return reflected[0] * light[0] + reflected[1] * light[1] + reflected[2] * light[2];
}

/// Static instruction counts of a form's compiled machine code.
struct CompiledCost {
  std::string_view form;  ///< as the inputs of the claims name it
  int nvidia_alu;         ///< vector arithmetic, by `nvidia_compiler`
  int nvidia_transcendental;
  int amd_alu;  ///< by `amd_compiler`
  int amd_transcendental;
};

inline constexpr std::string_view nvidia_compiler = "nvcc 13.0.88 -arch=sm_75 --use_fast_math";
inline constexpr std::string_view amd_compiler = "clang 19.1.7 -mcpu=gfx1030 -cl-denorms-are-zero";

/// Own measurement, 2026. Each kernel computes one form: the exponents are uniform, the cosine is loaded.
/// Counted are the instructions of the cubin and of the AMD assembly, without loads, stores, addresses,
/// constants and control flow. NVIDIA: FMUL, FADD, FFMA, FMNMX, FSETP, FSEL and MUFU. AMD: the corresponding
/// instructions, v_exp and v_log.
inline constexpr std::array compiled_costs{
    CompiledCost{"pow", 1, 2, 1, 2},
    CompiledCost{"gaussian", 1, 1, 1, 1},
    CompiledCost{"schlick-pow", 2, 2, 2, 2},
    CompiledCost{"schlick-squaring", 4, 0, 4, 0},
    CompiledCost{"fresnel-one-term", 1, 1, 1, 1},
    CompiledCost{"fresnel-quadratic", 2, 1, 2, 1},
    CompiledCost{"phong-gaussian", 4, 1, 4, 1},
    CompiledCost{"phong-pow", 5, 2, 5, 2},  // with max(r.l, 0)
};

}  // namespace shadefit
