#include "reports/code/shader_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "tests/forms_of_studies.hpp"
#include "tests/refusal.hpp"
#include "tests/reports/compilers.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::is_shader;
using testing::runs;
using testing::TemporaryDirectory;

Symbolic variable(const char* name) {
  return Symbolic::variable(name);
}
Symbolic number_of(const char* decimal) {
  return Symbolic::number(decimal);
}

/// The Fresnel pair with its published constants.
ShaderFunction fresnel_pair() {
  const auto value_of = [](const std::string& name) {
    return name == "a" ? number_of("-5.55473") : name == "b" ? number_of("-6.98316") : variable("c");
  };
  return {"fresnel", {"c"}, evaluate<Symbolic>(find_family("fresnel-quadratic")->form, value_of)};
}

/// Everything that a shading language has, with a part that is used twice, a choice and whole powers.
ShaderFunction of_everything() {
  const Symbolic c = variable("c"), k = variable("k"), one = integer<Symbolic>(1);
  const Symbolic y = one - c;
  const Symbolic powers = power(y, 5) + power(c, 16) / power(y + one, -3);
  const Symbolic functions = exp(-y) + exp2(k * y) + log(c + one) + log2(c + one) + sqrt(c) + sin(c) + cos(c);
  const Symbolic more = tan(c) + asin(c) - acos(c) + atan(k) * atan2(c, k) + sinh(c) / cosh(k * c) +
                        tanh(y - k) + floor(k - c) * abs(y - k);
  const Symbolic chosen = select(less(c, constant<Symbolic>("0.25")), y, -power(c, k));
  return {"of_everything",
          {"c", "k"},
          powers * (functions - (chosen - y)) + more + min(y, k) / max(pi<Symbolic>() * c, y) -
              (y - ln2<Symbolic>() / constant<Symbolic>("-3")),
          {"All of it."}};
}

/// What formulas have and shading languages have not, or not all of them: by what all have.
ShaderFunction of_rounding() {
  constexpr std::array<std::string_view, 2> names{"c", "k"};
  return {"of_rounding",
          {"c", "k"},
          parse_formula("round(4 c) + trunc(-3 c k) fmod(c - 1, k) - mod(c, k)", names)};
}

/// Everything that CUDA has for half.
ShaderFunction of_half_in_cuda() {
  const Symbolic c = variable("c"), half = constant<Symbolic>("0.5");
  const Symbolic functions = exp(c) + exp2(c * half) - log(c) / log2(c) + sqrt(c) * sin(c) - cos(-c);
  return {
      "of_half", {"c"}, select(less(c, half), functions, floor(c) + abs(c)) + min(power(c, 5), max(c, half))};
}

std::string code_of(const ShaderFunction& function, Language language,
                    ShaderPrecision precision = ShaderPrecision::float32) {
  const std::string code = shader_code(std::span(&function, 1), language, precision, {});
  const bool is_header = language == Language::c || language == Language::cpp || language == Language::cuda ||
                         language == Language::opencl;
  EXPECT_EQ(code.find("#ifndef") != std::string::npos, is_header) << code;
  if (!is_header) return code;
  // What stands in the guard.
  const std::size_t begin = code.find('\n', code.find("\n#define SHADEFIT_") + 1) + 1;
  const std::string_view end = "\n#endif\n";
  EXPECT_TRUE(code.ends_with(end)) << code;
  return code.substr(begin, code.size() - end.size() - begin);
}

// A copy of a header is passed over, another function of its name is an error of the compiler.
TEST(ShaderCode, AHeaderMayBeIncludedTwice) {
  const TemporaryDirectory directory;
  const auto header = [](const char* decimal, Language language) {
    const ShaderFunction function{"f", {"c"}, number_of(decimal) * variable("c")};
    return shader_code(std::span(&function, 1), language, ShaderPrecision::float32, {});
  };
  for (const Language language : {Language::c, Language::cpp}) {
    directory.file("one.h", header("2.5", language));
    directory.file("copy.h", header("2.5", language));
    directory.file("other.h", header("3.5", language));
    const bool is_c = language == Language::c;
    for (const std::string& compiler : is_c ? testing::c_compilers() : testing::cpp_compilers()) {
      const auto compiles = [&](const std::string& second) {
        const std::string source =
            directory.file(is_c ? "a.c" : "a.cpp", "#include \"one.h\"\n#include \"" + second +
                                                       "\"\nfloat g(float c) { return f(c); }\n");
        return runs(compiler + " -fsyntax-only '" + source + "'", directory);
      };
      EXPECT_TRUE(compiles("one.h")) << compiler << read_file(directory / "said");
      EXPECT_TRUE(compiles("copy.h")) << compiler << read_file(directory / "said");
      EXPECT_FALSE(compiles("other.h")) << compiler;
    }
  }
}

TEST(ShaderCode, OfThePairInEveryLanguage) {
  EXPECT_EQ(code_of(fresnel_pair(), Language::glsl),
            "\nfloat fresnel(float c) {\n  return exp2((-5.55473 * c - 6.98316) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::hlsl),
            "\nfloat fresnel(float c) {\n  return exp2((-5.55473f * c - 6.98316f) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::c),
            "\n#include <math.h>\n\nstatic inline float fresnel(float c) {\n"
            "  return exp2f((-5.55473f * c - 6.98316f) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::cpp),
            "\n#include <algorithm>\n#include <cmath>\n\ninline float fresnel(float c) {\n"
            "  return std::exp2((-5.55473f * c - 6.98316f) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::wgsl),
            "\nfn fresnel(c: f32) -> f32 {\n  return exp2((-5.55473f * c - 6.98316f) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::msl),
            "\n#include <metal_stdlib>\n\ninline float fresnel(float c) {\n"
            "  return metal::exp2((-5.55473f * c - 6.98316f) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::cuda),
            "\n__device__ __forceinline__ float fresnel(float c) {\n"
            "  return exp2f((-5.55473f * c - 6.98316f) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::opencl),
            "\nfloat fresnel(float c) {\n  return exp2((-5.55473f * c - 6.98316f) * c);\n}\n");
}

// A half has three to four digits, and says so in the languages that have one.
TEST(ShaderCode, OfHalf) {
  EXPECT_EQ(code_of(fresnel_pair(), Language::hlsl, ShaderPrecision::float16),
            "\nmin16float fresnel(min16float c) {\n  return exp2((-5.555h * c - 6.984h) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::glsl, ShaderPrecision::float16),
            "\nmediump float fresnel(mediump float c) {\n  return exp2((-5.555 * c - 6.984) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::wgsl, ShaderPrecision::float16),
            "\nenable f16;\n\nfn fresnel(c: f16) -> f16 {\n  return exp2((-5.555h * c - 6.984h) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::opencl, ShaderPrecision::float16),
            "\n#pragma OPENCL EXTENSION cl_khr_fp16 : enable\n\nhalf fresnel(half c) {\n"
            "  return exp2((-5.555h * c - 6.984h) * c);\n}\n");
  EXPECT_EQ(code_of(fresnel_pair(), Language::cuda, ShaderPrecision::float16),
            "\n#include <cuda_fp16.h>\n\n__device__ __forceinline__ __half fresnel(__half c) {\n"
            "  return hexp2((__float2half(-5.555f) * c - __float2half(6.984f)) * c);\n}\n");
  const ShaderFunction arc{"f", {"c"}, acos(variable("c"))};
  EXPECT_EQ(testing::refusal([&] { code_of(arc, Language::cuda, ShaderPrecision::float16); }),
            "f: 'cuda' has no acos of half");
  for (const Language language : {Language::c, Language::cpp})
    EXPECT_THROW(code_of(fresnel_pair(), language, ShaderPrecision::float16), UserError);
}

TEST(ShaderCode, SharesWhatIsUsedTwiceAndFoldsNumbers) {
  const Symbolic c = variable("c"), t0 = variable("t0");
  const ShaderFunction squares{"f", {"c", "t0"}, power(c, 5) + t0};
  EXPECT_EQ(code_of(squares, Language::glsl),
            "\nfloat f(float c, float t0) {\n  float t1 = c * c;\n  return t1 * t1 * c + t0;\n}\n");
  const ShaderFunction folded{"f", {"c"}, (constant<Symbolic>("16.775") / ln2<Symbolic>()) * c};
  EXPECT_EQ(code_of(folded, Language::wgsl), "\nfn f(c: f32) -> f32 {\n  return 24.20121f * c;\n}\n");
  EXPECT_EQ(code_of({"f", {"c"}, c - (c - integer<Symbolic>(-3))}, Language::hlsl),
            "\nfloat f(float c) {\n  return c - (c + 3.0f);\n}\n");
  EXPECT_EQ(code_of({"f", {"c"}, c * integer<Symbolic>(-3)}, Language::hlsl),
            "\nfloat f(float c) {\n  return c * (-3.0f);\n}\n");
}

TEST(ShaderCode, TakesExp2WhereAFactorIsANumber) {
  const Symbolic y = integer<Symbolic>(1) - variable("c");
  const ShaderFunction of_number{"f", {"c"}, exp(Symbolic(constant<Symbolic>("-16.775") * y))};
  EXPECT_EQ(code_of(of_number, Language::glsl),
            "\nfloat f(float c) {\n  return exp2(-24.20121 * (1.0 - c));\n}\n");
  const ShaderFunction of_variable{"f", {"c", "k"}, exp(Symbolic(variable("k") * y))};
  EXPECT_EQ(code_of(of_variable, Language::glsl),
            "\nfloat f(float c, float k) {\n  return exp(k * (1.0 - c));\n}\n");
}

TEST(ShaderCode, NamesWhatALanguageLacks) {
  const ShaderFunction function{"f", {"c"}, log1p(variable("c"))};
  EXPECT_EQ(testing::refusal([&] { code_of(function, Language::glsl); }), "f: 'glsl' has no log1p");
  EXPECT_EQ(code_of(function, Language::c),
            "\n#include <math.h>\n\nstatic inline float f(float c) {\n  return log1pf(c);\n}\n");
  EXPECT_EQ(code_of(function, Language::cuda),
            "\n__device__ __forceinline__ float f(float c) {\n  return log1pf(c);\n}\n");
  EXPECT_EQ(code_of(function, Language::opencl), "\nfloat f(float c) {\n  return log1p(c);\n}\n");
  const ShaderFunction sign{"f", {"c"}, signum(variable("c"))};
  EXPECT_EQ(testing::refusal([&] { code_of(sign, Language::cuda); }), "f: 'cuda' has no sign");
  EXPECT_EQ(code_of(sign, Language::opencl), "\nfloat f(float c) {\n  return sign(c);\n}\n");
  EXPECT_EQ(testing::refusal([&] { code_of(sign, Language::c); }), "f: 'c' has no sign");
  EXPECT_EQ(code_of(sign, Language::wgsl), "\nfn f(c: f32) -> f32 {\n  return sign(c);\n}\n");
}

/// A whole shader around functions, which calls `of_everything`.
std::string fragment_shader(const std::string& code) {
  return "#version 450\nprecision highp float;\nlayout(location = 0) in vec2 at;\n"
         "layout(location = 0) out vec4 colour;\n" +
         code + "void main() { colour = vec4(of_everything(at.x, at.y)); }\n";
}
std::string pixel_shader(const std::string& code, const std::string& type) {
  return code + type + "4 main(float2 at : TEXCOORD0) : SV_Target {\n  " + type + " v = of_everything((" +
         type + ")at.x, (" + type + ")at.y);\n  return " + type + "4(v, v, v, v);\n}\n";
}

TEST(GeneratedShader, CompilesAsGlslAndHlsl) {
  const std::string reason = testing::reason_without_shaders();
  if (!reason.empty()) GTEST_SKIP() << reason;
  const TemporaryDirectory directory;
  for (const ShaderPrecision precision : shader_precisions) {
    directory.file("a.frag", fragment_shader(code_of(of_everything(), Language::glsl, precision)));
    EXPECT_TRUE(is_shader(directory / "a.frag", false, directory)) << read_file(directory / "said");
    const std::string type = precision == ShaderPrecision::float32 ? "float" : "min16float";
    directory.file("b.frag", pixel_shader(code_of(of_everything(), Language::hlsl, precision), type));
    EXPECT_TRUE(is_shader(directory / "b.frag", true, directory)) << read_file(directory / "said");
  }
}

std::vector<ShaderFunction> functions_of_studies() {
  std::vector<ShaderFunction> functions;
  for (const testing::FormOfStudy& form : testing::forms_of_studies()) functions.push_back(form.function);
  return functions;
}

/// "f(x, x)"
std::string call_of(const ShaderFunction& function) {
  std::string call = function.name + "(x";
  for (std::size_t i = 1; i < function.arguments.size(); ++i) call += ", x";
  return call + ")";
}

/// "f(x, x) + g(x)": a call of each.
std::string sum_of_calls(const std::vector<ShaderFunction>& functions) {
  std::string sum;
  for (const ShaderFunction& function : functions) sum += (sum.empty() ? "" : " + ") + call_of(function);
  return sum;
}

// In one file of each language, so that each compiler runs once.
TEST(GeneratedShader, OfEveryStudyCompiles) {
  const TemporaryDirectory directory;
  std::vector<ShaderFunction> functions = functions_of_studies();
  EXPECT_GT(functions.size(), 100u);
  functions.push_back(of_rounding());
  const std::string sum = sum_of_calls(functions);
  const auto code = [&](Language language) {
    return shader_code(functions, language, ShaderPrecision::float32, {});
  };
  const std::string flags = " -fsyntax-only -Wall -Wextra -Wconversion -Werror '";
  for (const Language language : {Language::c, Language::cpp}) {
    const bool is_c = language == Language::c;
    const std::string source =
        directory.file(is_c ? "a.c" : "a.cpp",
                       code(language) + "float all(float x);\nfloat all(float x) { return " + sum + "; }\n");
    for (const std::string& compiler : is_c ? testing::c_compilers() : testing::cpp_compilers())
      EXPECT_TRUE(runs(compiler + flags + source + "'", directory))
          << compiler << read_file(directory / "said");
  }
  const std::string reason = testing::reason_without_shaders();
  if (!reason.empty()) GTEST_SKIP() << reason;
  directory.file("a.frag",
                 "#version 450\nprecision highp float;\nlayout(location = 0) in float x;\n"
                 "layout(location = 0) out float colour;\n" +
                     code(Language::glsl) + "void main() { colour = " + sum + "; }\n");
  EXPECT_TRUE(is_shader(directory / "a.frag", false, directory)) << read_file(directory / "said");
  directory.file("b.frag", code(Language::hlsl) +
                               "float4 main(float x : TEXCOORD0) : SV_Target {\n  float v = " + sum +
                               ";\n  return float4(v, v, v, v);\n}\n");
  EXPECT_TRUE(is_shader(directory / "b.frag", true, directory)) << read_file(directory / "said");
}

// With what these two have of C's library, and OpenCL with sign. A function of the host is not for the
// device, and min of a float and a double is ambiguous in OpenCL.
TEST(GeneratedShader, CompilesAsCudaAndOpenCl) {
  if (testing::compilers_of("c").size() < 2) GTEST_SKIP() << "without a second compiler: package clang";
  const TemporaryDirectory directory;
  const Symbolic c = variable("c");
  const ShaderFunction like_c{"f", {"c"}, expm1(c) + log1p(c) + erf(c) * erfc(c)};
  const ShaderFunction sign{"g", {"c"}, signum(c)};
  const std::vector<ShaderFunction> in_cuda{of_everything(), like_c},
      in_opencl{of_everything(), like_c, sign};
  // clang judges the body of an inline function where it is called
  const std::string cuda = directory.file(
      "a.cu", shader_code(in_cuda, Language::cuda, ShaderPrecision::float32, {}) +
                  "__device__ float sum(float c, float k) { return of_everything(c, k) + f(c); }\n");
  EXPECT_TRUE(testing::is_cuda(cuda, directory)) << read_file(directory / "said");
  directory.file("cuda_fp16.h", testing::cuda_half_header);
  const ShaderFunction of_half = of_half_in_cuda();
  const std::string cuda_half = directory.file(
      "c.cu", shader_code(std::span(&of_half, 1), Language::cuda, ShaderPrecision::float16, {}) +
                  "__device__ __half same(__half c) { return of_half(c); }\n");
  EXPECT_TRUE(testing::is_cuda(cuda_half, directory)) << read_file(directory / "said");
  for (const ShaderPrecision precision : shader_precisions) {
    const std::string opencl =
        directory.file("a.cl", shader_code(in_opencl, Language::opencl, precision, {}));
    EXPECT_TRUE(testing::is_opencl(opencl, directory)) << read_file(directory / "said");
  }
  const std::string of_host =
                        directory.file("b.cu", "__device__ float f(float c) { return significandf(c); }\n"),
                    of_double = directory.file("b.cl", "float f(float c) { return fmin(c, 1.0); }\n");
  EXPECT_FALSE(testing::is_cuda(of_host, directory));
  EXPECT_FALSE(testing::is_opencl(of_double, directory));
}

/// With four powers, over 10 000 points.
constexpr int cosine_steps = 2500;

/// Cosines and powers in the order in which the programs below try them.
template <class Visit>
void every_argument(const Visit& visit) {
  for (int i = 0; i <= cosine_steps; ++i) {
    for (const int k : {1, 3, 16, 100})
      visit(static_cast<float>(i) / cosine_steps, static_cast<float>(k) / 4);
  }
}

/// A program that prints the bits of what the function gives for each.
std::string program(const std::string& code) {
  return "#include <stdio.h>\n#include <string.h>\n" + code +
         "int main(void) {\n  static const int powers[] = {1, 3, 16, 100};\n  const int steps = " +
         std::to_string(cosine_steps) +
         ";\n  for (int i = 0; i <= steps; ++i)\n    for (int k = 0; k < 4; ++k) {\n"
         "      float x = of_everything((float)i / (float)steps, (float)powers[k] / 4);\n      unsigned bits;\n"
         "      memcpy(&bits, &x, sizeof bits);\n      printf(\"%08x\\n\", bits);\n    }\n  return 0;\n}\n";
}

std::string bits_in_process(const ShaderFunction& function) {
  const Symbolic generated = as_generated(function.result, ShaderPrecision::float32);
  std::string text;
  every_argument([&](float c, float k) {
    const float value =
        evaluate<float>(generated, [&](const std::string& name) { return name == "c" ? c : k; });
    char line[16];
    std::snprintf(line, sizeof line, "%08x\n", std::bit_cast<unsigned>(value));
    text += line;
  });
  return text;
}

// What the C and C++ code computes is what is evaluated here, bit for bit, by every compiler at hand. Metal's
// is that of C++ with another library in front. CUDA's is C++ with two words more. OpenCL C's is C whose
// functions are those of their argument's type, as <tgmath.h> makes them.
TEST(GeneratedCode, ComputesTheBitsThatAreEvaluatedHere) {
  const TemporaryDirectory directory;
  const ShaderFunction function = of_everything();
  const std::string expected = bits_in_process(function);
  directory.file("metal_stdlib",
                 "#pragma once\n#include <cmath>\n#include <algorithm>\nnamespace metal {\n"
                 "using namespace std;\n}\n");
  directory.file("a.c", program(code_of(function, Language::c)));
  directory.file("b.cpp", program(code_of(function, Language::cpp)));
  directory.file("c.cpp", program(code_of(function, Language::msl)));
  directory.file("d.cpp", "#include <cmath>\n#define __device__\n#define __forceinline__ inline\n" +
                              program(code_of(function, Language::cuda)));
  directory.file("e.c", "#include <tgmath.h>\n" + program(code_of(function, Language::opencl)));
  std::istringstream compilers(SHADEFIT_COMPILERS);  // "c=cc c++=g++ .."
  int programs = 0;
  for (std::string compiler; compilers >> compiler;) {
    const bool is_c = compiler.starts_with("c=");
    const std::string path = compiler.substr(compiler.find('=') + 1);
    for (const std::string& source : is_c ? std::vector<std::string>{"a.c", "e.c"}
                                          : std::vector<std::string>{"b.cpp", "c.cpp", "d.cpp"}) {
      const std::string options =
          " -O2 -Wall -Wextra -Werror -ffp-contract=off -I'" + directory.path().string() + "'";
      ASSERT_TRUE(runs(path + (is_c ? " -std=c11" : " -std=c++11") + options + " -o '" +
                           directory / "program" + "' '" + directory / source + "' -lm",
                       directory))
          << compiler << read_file(directory / "said");
      ASSERT_TRUE(runs("'" + directory / "program" + "'", directory));
      EXPECT_EQ(read_file(directory / "said"), expected) << compiler << " " << source;
      ++programs;
    }
  }
  EXPECT_GE(programs, 5);
}

/// Of the places i/32 that `OfEveryStudy` tries; at the ends some forms are not finite.
constexpr int places_of_studies = 32;

/// The bits, or "nan": which NaN it is is no business of a formula.
std::string line_of(const ShaderFunction& function, float x) {
  const Symbolic generated = as_generated(function.result, ShaderPrecision::float32);
  const float value = evaluate<float>(generated, [&](const std::string&) { return x; });
  char line[16];
  std::snprintf(line, sizeof line, "%08x\n", std::bit_cast<unsigned>(value));
  return std::isnan(value) ? "nan\n" : line;
}

// The forms of all studies in one program of C and one of C++, against what is evaluated here.
TEST(GeneratedCode, OfEveryStudyComputesTheBitsThatAreEvaluatedHere) {
  const TemporaryDirectory directory;
  const std::vector<ShaderFunction> functions = functions_of_studies();
  std::string expected, calls;
  for (const ShaderFunction& function : functions) {
    for (int i = 0; i <= places_of_studies; ++i)
      expected += line_of(function, static_cast<float>(i) / places_of_studies);
    calls += "  for (int i = 0; i <= steps; ++i) {\n    const float x = (float)i / (float)steps;\n    show(" +
             call_of(function) + ");\n  }\n";
  }
  for (const Language language : {Language::c, Language::cpp}) {
    const bool is_c = language == Language::c;
    const std::string source = directory.file(
        is_c ? "studies.c" : "studies.cpp",
        "#include <stdio.h>\n#include <string.h>\n" +
            shader_code(functions, language, ShaderPrecision::float32, {}) +
            "static void show(float x) {\n  unsigned bits;\n  memcpy(&bits, &x, sizeof bits);\n"
            "  if (x != x) printf(\"nan\\n\");\n  else printf(\"%08x\\n\", bits);\n}\n"
            "int main(void) {\n  const int steps = " +
            std::to_string(places_of_studies) + ";\n" + calls + "  return 0;\n}\n");
    for (const std::string& compiler : is_c ? testing::c_compilers() : testing::cpp_compilers()) {
      ASSERT_TRUE(
          runs(compiler + " -O1 -ffp-contract=off -o '" + directory / "program" + "' '" + source + "' -lm",
               directory))
          << compiler << read_file(directory / "said");
      ASSERT_TRUE(runs("'" + directory / "program" + "'", directory));
      EXPECT_EQ(read_file(directory / "said"), expected) << compiler;
    }
  }
}

}  // namespace
}  // namespace shadefit
