#include "reports/code/shader_code.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <sstream>
#include <string>

#include "reports/io/files.hpp"
#include "tests/reports/compilers.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::TemporaryDirectory;

/// Words that mean something in one language or another, and names that people give.
std::vector<std::string> candidates() {
  std::istringstream words(
      "return float main if int double long signed restrict inline class new and or not this template std auto "
      "mutable import export sin exp exp2 exp2f pow sqrt min max clamp mix lerp saturate select step smoothstep "
      "length dot cross distance reflect refract normalize fma fmaf round floor ceil abs fabs gamma lgamma y0 y1f "
      "j0 jn index signgam significand drem sincos hypot cbrt erf erfc trunc rint fract frac mad rsqrt rcp "
      "inversesqrt float3 float4x4 vec2 vec3 mat4 half half4 uint uint2 fixed hvec2 sampler2D isampler3D texture "
      "sample filter input output common partition active public in out inout discard precise smooth flat patch "
      "buffer shared subroutine varying attribute uniform kernel vertex fragment device constant thread threadgroup "
      "metal fn let var loop override f32 f16 array atomic ptr bitcast target unless where with yield move match "
      "mod ref self super trait type use matrix vector string technique pass line point triangle linear register "
      "cbuffer snorm unorm dword row_major gl_x a__b _ _a __a _A errno assert lobe fresnel schlick specular c k t0 "
      "shade my_lobe Lobe lobe2 x y f g noise noise1 atan2 ldexp isnan isinf sign degrees transpose determinant "
      "asfloat lit dst clip log10 tanh sinh all any equal not_eq xor compl bitand concept requires co_await char8_t "
      "constexpr nullptr static_assert typeof bool true false alignas thread_local asm fortran namespace using "
      "goto sizeof typedef union volatile unsigned interface resource noinline external superp nointerpolation "
      "groupshared RWBuffer StructuredBuffer printf abort malloc free rand time read write remainder scalb expm1 "
      "log1p logb nan modf frexp tgamma exp10 pow10 fmin fmax fdim nextafter copysign asint asuint countbits ushort u_int size_t my_t double_t "
      "threadIdx dim3 make_float2 rnorm3df umax llmin rsqrtf global local private float8 float16 longlong2 "
      "as_int convert_float vload4 atomic_add get_global_id native_exp2 mad24 step2 global_light cuda_lobe");
  std::vector<std::string> found;
  for (std::string word; words >> word;) found.push_back(word);
  return found;
}

/// A file of the functions of these names; each calls what it can of the library.
std::string file_of(const std::vector<std::string>& names, Language language) {
  std::vector<ShaderFunction> functions;
  for (const std::string& name : names) {
    const Symbolic c = Symbolic::variable("c");
    functions.push_back({name, {"c"}, min(exp2(c), sqrt(c))});
  }
  return shader_code(functions, language, ShaderPrecision::float32, {});
}

std::vector<std::string> accepted() {
  std::vector<std::string> names;
  for (const std::string& name : candidates()) {
    if (reason_to_refuse_name(name).empty()) names.push_back(name);
  }
  return names;
}

// What is not refused compiles, all of it in one file, in each language.
TEST(ReservedNames, WhatIsAcceptedCompiles) {
  const TemporaryDirectory directory;
  const std::string c = directory.file("a.c", file_of(accepted(), Language::c)),
                    cpp = directory.file("a.cpp", file_of(accepted(), Language::cpp));
  for (const std::string& compiler : testing::c_compilers())
    EXPECT_TRUE(testing::runs(
        compiler + " -std=gnu11 -fsyntax-only -Wall -Wno-unused-function -Werror '" + c + "'", directory))
        << compiler << read_file(directory / "said");
  for (const std::string& compiler : testing::cpp_compilers())
    EXPECT_TRUE(testing::runs(
        compiler + " -std=c++20 -fsyntax-only -Wall -Wno-unused-function -Werror '" + cpp + "'", directory))
        << compiler << read_file(directory / "said");
  if (testing::c_compilers().size() > 1) {  // clang is one
    const std::string cuda = directory.file("a.cu", file_of(accepted(), Language::cuda)),
                      opencl = directory.file("a.cl", file_of(accepted(), Language::opencl));
    EXPECT_TRUE(testing::is_cuda(cuda, directory)) << read_file(directory / "said");
    EXPECT_TRUE(testing::is_opencl(opencl, directory)) << read_file(directory / "said");
  }
  const std::string reason = testing::reason_without_shaders();
  if (!reason.empty()) GTEST_SKIP() << reason;
  const std::string glsl =
      directory.file("a.frag", "#version 450\n" + file_of(accepted(), Language::glsl) + "void main() {}\n");
  EXPECT_TRUE(testing::is_shader(glsl, false, directory)) << read_file(directory / "said");
  const std::string hlsl = directory.file(
      "b.frag", file_of(accepted(), Language::hlsl) + "float4 main() : SV_Target { return 0; }\n");
  EXPECT_TRUE(testing::is_shader(hlsl, true, directory)) << read_file(directory / "said");
}

TEST(ReservedNames, ARefusalSaysWhy) {
  for (const char* name : {"lobe", "my_lobe", "fresnel2", "Lobe", "textureColour", "vec"})
    EXPECT_EQ(reason_to_refuse_name(name), "") << name;
  for (const char* name :
       {"return", "exp2", "float3x4", "float16", "sqrtf", "rnormf", "lerp", "let", "kernel"})
    EXPECT_EQ(reason_to_refuse_name(name), "it is a word or a function of a language") << name;
  for (const char* name : {"gl_x", "a__b", "vload4", "my_t", "isampler3D"})
    EXPECT_EQ(reason_to_refuse_name(name), "names of that form are reserved in a language") << name;
}

}  // namespace
}  // namespace shadefit
