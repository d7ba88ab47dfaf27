#pragma once

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/temporary_directory.hpp"

/// Compilers of generated code, run as programs.
namespace shadefit::testing {

/// Runs a tool; its output is in the file `said`.
inline bool runs(const std::string& command, const TemporaryDirectory& directory) {
  return std::system((command + " >'" + directory / "said" + "' 2>&1").c_str()) == 0;
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

/// Whether a file compiles as CUDA for the device.
inline bool is_cuda(const std::string& file, const TemporaryDirectory& directory) {
  const std::string header = directory.file("cuda.h", cuda_header);
  return runs(
      "clang -x cuda --cuda-device-only -nocudainc -nocudalib -Wno-unknown-cuda-version -fsyntax-only -Wall "
      "-Werror -include '" +
          header + "' '" + file + "'",
      directory);
}

/// Whether a file compiles as OpenCL C, with what clang declares of its library.
inline bool is_opencl(const std::string& file, const TemporaryDirectory& directory) {
  return runs(
      "clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -fsyntax-only -Wall -Werror '" + file + "'",
      directory);
}

}  // namespace shadefit::testing
