#pragma once

#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/temporary_directory.hpp"

/// Compilers of generated code, run as programs.
namespace shadefit::testing {

/// Runs a tool; its output is in the file `said`.
inline bool runs(const std::string& command, const TemporaryDirectory& directory) {
  return std::system((command + " >'" + directory / "said" + "' 2>&1").c_str()) == 0;
}

/// Why shaders cannot be compiled here: a tool that is missing, and its package. Empty if they can.
inline std::string reason_without_shaders() {
  for (const auto& [tool, package] :
       {std::pair("glslangValidator", "glslang-tools"), {"spirv-val", "spirv-tools"}}) {
    if (std::system((std::string("command -v ") + tool + " >/dev/null").c_str()) != 0)
      return std::string("without ") + tool + ": package " + package;
  }
  return "";
}

/// Whether a file is a fragment shader in GLSL or HLSL, by glslangValidator, and good SPIR-V, by spirv-val.
inline bool is_shader(const std::string& file, bool is_hlsl, const TemporaryDirectory& directory) {
  const std::string spirv = directory / "shader.spv";
  return runs(std::string("glslangValidator -V ") + (is_hlsl ? "-D -e main " : "") + "-o '" + spirv + "' '" +
                  file + "'",
              directory) &&
         runs("spirv-val '" + spirv + "'", directory);
}

/// The compilers at hand of a kind, "c" or "c++".
inline std::vector<std::string> compilers_of(const std::string& kind) {
  std::istringstream all(SHADEFIT_COMPILERS);  // "c=cc c++=g++ .."
  std::vector<std::string> found;
  for (std::string one; all >> one;) {
    if (one.starts_with(kind + "=")) found.push_back(one.substr(kind.size() + 1));
  }
  return found;
}
inline std::vector<std::string> c_compilers() {
  return compilers_of("c");
}
inline std::vector<std::string> cpp_compilers() {
  return compilers_of("c++");
}

/// What clang needs to compile CUDA without NVIDIA's headers: the two words of ours, and the functions of
/// CUDA's library from clang's own headers for them, with what these expect of others.
inline constexpr const char* cuda_header =
    "#define __device__ __attribute__((device))\n"
    "#define __forceinline__ __inline__ __attribute__((always_inline))\n"
    "#define CUDA_VERSION 11050\n#include <limits.h>\n#include <math.h>\n#include <string.h>\n"
    "__device__ void *memcpy(void *, const void *, size_t);\n__device__ void *memset(void *, int, size_t);\n"
    "#include <__clang_cuda_libdevice_declares.h>\n__device__ long long __float2ll_rn(float);\n"
    "__device__ long long __double2ll_rn(double);\n#include <__clang_cuda_math.h>\n";

/// What generated code uses of NVIDIA's cuda_fp16.h, declared as it is there. A half is not made of a float
/// silently.
inline constexpr const char* cuda_half_header =
    "struct __half { unsigned short bits; };\n__device__ __half __float2half(const float);\n"
    "__device__ __half operator+(const __half &, const __half &);\n"
    "__device__ __half operator-(const __half &, const __half &);\n"
    "__device__ __half operator*(const __half &, const __half &);\n"
    "__device__ __half operator/(const __half &, const __half &);\n__device__ __half operator-(const __half &);\n"
    "__device__ bool operator<(const __half &, const __half &);\n__device__ __half hexp(const __half);\n"
    "__device__ __half hexp2(const __half);\n__device__ __half hlog(const __half);\n"
    "__device__ __half hlog2(const __half);\n__device__ __half hsqrt(const __half);\n"
    "__device__ __half hsin(const __half);\n__device__ __half hcos(const __half);\n"
    "__device__ __half hfloor(const __half);\n__device__ __half __habs(const __half);\n"
    "__device__ __half __hmin(const __half, const __half);\n__device__ __half __hmax(const __half, const __half);\n";

/// Whether a file compiles as CUDA for the device.
inline bool is_cuda(const std::string& file, const TemporaryDirectory& directory) {
  const std::string header = directory.file("cuda.h", cuda_header);
  return runs(
      "clang -x cuda --cuda-device-only -nocudainc -nocudalib -Wno-unknown-cuda-version -fsyntax-only -Wall "
      "-Werror -I'" +
          directory.path().string() + "' -include '" + header + "' '" + file + "'",
      directory);
}

/// Whether a file compiles as OpenCL C, with what clang declares of its library.
inline bool is_opencl(const std::string& file, const TemporaryDirectory& directory) {
  return runs(
      "clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -fsyntax-only -Wall -Werror '" + file + "'",
      directory);
}

}  // namespace shadefit::testing
