#pragma once

#include <array>
#include <string_view>

#include "reports/code/shader_code.hpp"

/// The languages of generated code, as data.
namespace shadefit {

/// The differences between the languages.
struct Dialect {
  std::string_view name;
  std::string_view prologue = {};       ///< before the first function, a line or more; or empty
  std::string_view prologue_half = {};  ///< the same for arithmetic in half
  std::string_view type;
  std::string_view half = {};                      ///< the type of half; empty if there is none
  std::string_view suffix = {}, half_suffix = {};  ///< of literals
  std::string_view half_prefix = {};               ///< in front of a literal of half
  std::string_view functions = {};                 ///< in front of the name of a function of the library
  std::string_view float_suffix = {};              ///< behind it
  std::string_view before_min = {};                ///< in front of min, max and abs: C has fminf, not minf
  std::string_view before = {};                    ///< in front of a function's definition
  std::string_view half_functions = {};            ///< "exp=hexp ..": all of half, if they have other names
  bool has_functions_of_c = false;                 ///< expm1, log1p, erf, erfc
  bool has_sign = false;
  bool has_guard = false;  ///< the file is a header: it may be included twice
};

inline constexpr std::array<Dialect, languages.size()> dialects{{
    {.name = "glsl", .type = "float", .half = "mediump float", .has_sign = true},
    {.name = "hlsl",
     .type = "float",
     .half = "min16float",
     .suffix = "f",
     .half_suffix = "h",
     .has_sign = true},
    {.name = "c",
     .prologue = "#include <math.h>\n",
     .type = "float",
     .suffix = "f",
     .float_suffix = "f",
     .before_min = "f",
     .before = "static inline ",
     .has_functions_of_c = true,
     .has_guard = true},
    {.name = "cpp",
     .prologue = "#include <algorithm>\n#include <cmath>\n",
     .type = "float",
     .suffix = "f",
     .functions = "std::",
     .before = "inline ",
     .has_functions_of_c = true,
     .has_guard = true},
    {.name = "wgsl",
     .prologue_half = "enable f16;\n",
     .type = "f32",
     .half = "f16",
     .suffix = "f",
     .half_suffix = "h",
     .has_sign = true},
    {.name = "msl",
     .prologue = "#include <metal_stdlib>\n",
     .prologue_half = "#include <metal_stdlib>\n",
     .type = "float",
     .half = "half",
     .suffix = "f",
     .half_suffix = "h",
     .functions = "metal::",
     .before = "inline ",
     .has_sign = true},
    // nvcc and NVRTC bring the functions themselves: NVRTC finds no header of C. The functions of half are
    // those of the CUDA Math API, "Half Precision Intrinsics"; half has no literals.
    {.name = "cuda",
     .prologue_half = "#include <cuda_fp16.h>\n",
     .type = "float",
     .half = "__half",
     .suffix = "f",
     .half_suffix = "f)",
     .half_prefix = "__float2half(",
     .float_suffix = "f",
     .before_min = "f",
     .before = "__device__ __forceinline__ ",
     .half_functions = "exp=hexp exp2=hexp2 log=hlog log2=hlog2 sqrt=hsqrt sin=hsin cos=hcos floor=hfloor "
                       "abs=__habs min=__hmin max=__hmax",
     .has_functions_of_c = true,
     .has_guard = true},
    // A program is a text given at run time, so a copy of a function may stand in it twice.
    {.name = "opencl",
     .prologue_half = "#pragma OPENCL EXTENSION cl_khr_fp16 : enable\n",
     .type = "float",
     .half = "half",
     .suffix = "f",
     .half_suffix = "h",
     .before_min = "f",
     .has_functions_of_c = true,
     .has_sign = true,
     .has_guard = true},
}};

}  // namespace shadefit
