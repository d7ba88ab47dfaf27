#pragma once

#include <string>
#include <string_view>

#include "reports/code/shader_code.hpp"

/// Names that a language reserves.
namespace shadefit {

/// Why a function in generated code cannot have this name, an identifier of letters, digits and '_': it is a
/// keyword or a function of the language, or has a reserved form. Empty if the name is allowed.
///
/// Sources: GLSL 4.60 and GLSL ES 3.20 (3.6 Keywords, 3.7 Identifiers, 8 Built-in Functions); Microsoft's
/// HLSL reference (Keywords, Reserved Words, Intrinsic Functions); WGSL (15 Keyword and Token Summary, 17
/// Built-in Functions); Metal Shading Language Specification 3 (C++14 without exceptions, chapters 2, 4, 5
/// and 6); ISO C23 6.4.1, 7.1.3 and 7.12; ISO C++20 [lex.key], [lex.name], [extern.names]; CUDA C++
/// Programming Guide (C++ Language Extensions, Mathematical Functions); The OpenCL C Specification 3.0
/// (6.1, 6.3, 6.15).
std::string_view reason_to_refuse_name(std::string_view name, Language language);

}  // namespace shadefit
