#pragma once

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/temporary_directory.hpp"

/// Compilers of generated code, run as programs.
namespace shadefit::testing {

/// Runs a tool; what it says stands in the file `said`.
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

/// The C++ compilers at hand.
inline std::vector<std::string> cpp_compilers() {
  std::istringstream all(SHADEFIT_COMPILERS);  // "c=cc c++=g++ .."
  std::vector<std::string> found;
  for (std::string one; all >> one;) {
    if (one.starts_with("c++=")) found.push_back(one.substr(4));
  }
  return found;
}

}  // namespace shadefit::testing
