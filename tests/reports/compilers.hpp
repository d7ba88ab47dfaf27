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

}  // namespace shadefit::testing
