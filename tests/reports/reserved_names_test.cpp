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

std::vector<std::string> accepted(Language language) {
  std::vector<std::string> names;
  for (const std::string& name : candidates()) {
    if (reason_to_refuse_name(name, language).empty()) names.push_back(name);
  }
  return names;
}

// What is not refused compiles, all of it in one file; with candidates of all languages in each.
TEST(ReservedNames, WhatIsAcceptedCompiles) {
  const TemporaryDirectory directory;
  const std::string c = directory.file("a.c", file_of(accepted(Language::c), Language::c)),
                    cpp = directory.file("a.cpp", file_of(accepted(Language::cpp), Language::cpp));
  for (const std::string& compiler : testing::c_compilers())
    EXPECT_TRUE(testing::runs(
        compiler + " -std=gnu11 -fsyntax-only -Wall -Wno-unused-function -Werror '" + c + "'", directory))
        << compiler << read_file(directory / "said");
  for (const std::string& compiler : testing::cpp_compilers())
    EXPECT_TRUE(testing::runs(
        compiler + " -std=c++20 -fsyntax-only -Wall -Wno-unused-function -Werror '" + cpp + "'", directory))
        << compiler << read_file(directory / "said");
  if (testing::c_compilers().size() > 1) {  // clang is one
    const std::string cuda = directory.file("a.cu", file_of(accepted(Language::cuda), Language::cuda)),
                      opencl = directory.file("a.cl", file_of(accepted(Language::opencl), Language::opencl));
    EXPECT_TRUE(testing::is_cuda(cuda, directory)) << read_file(directory / "said");
    EXPECT_TRUE(testing::is_opencl(opencl, directory)) << read_file(directory / "said");
  }
  const std::string reason = testing::reason_without_shaders();
  if (!reason.empty()) GTEST_SKIP() << reason;
  const std::string glsl = directory.file(
      "a.frag", "#version 450\n" + file_of(accepted(Language::glsl), Language::glsl) + "void main() {}\n");
  EXPECT_TRUE(testing::is_shader(glsl, false, directory)) << read_file(directory / "said");
  const std::string hlsl = directory.file("b.frag", file_of(accepted(Language::hlsl), Language::hlsl) +
                                                        "float4 main() : SV_Target { return 0; }\n");
  EXPECT_TRUE(testing::is_shader(hlsl, true, directory)) << read_file(directory / "said");
}

TEST(ReservedNames, ARefusalSaysWhy) {
  for (const Language language : languages) {
    for (const char* name : {"lobe", "my_lobe", "fresnel2", "Lobe"})
      EXPECT_EQ(reason_to_refuse_name(name, language), "") << name << " " << shadefit::name(language);
    EXPECT_NE(reason_to_refuse_name("return", language), "");
    EXPECT_NE(reason_to_refuse_name("exp2", language), "");
  }
  EXPECT_EQ(reason_to_refuse_name("float3x4", Language::hlsl), "it is a word of the language");
  EXPECT_EQ(reason_to_refuse_name("float3x5", Language::hlsl), "");
  EXPECT_EQ(reason_to_refuse_name("sqrtf", Language::c), "it is a function of the language or its library");
  EXPECT_EQ(reason_to_refuse_name("gl_x", Language::glsl), "names of that form are reserved");
  EXPECT_EQ(reason_to_refuse_name("a__b", Language::cpp), "names of that form are reserved");
  EXPECT_EQ(reason_to_refuse_name("a__b", Language::wgsl), "");
  EXPECT_EQ(reason_to_refuse_name("float16", Language::opencl), "it is a word of the language");
  EXPECT_EQ(reason_to_refuse_name("float16", Language::cuda), "");
  EXPECT_EQ(reason_to_refuse_name("rnormf", Language::cuda),
            "it is a function of the language or its library");
  EXPECT_EQ(reason_to_refuse_name("vload4", Language::opencl), "names of that form are reserved");
}

}  // namespace
}  // namespace shadefit
