#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/code/shader_code.hpp"

/// Shaders as SPIR-V, compiled by glslang.
namespace shadefit::device {

/// A compiler of compute shaders. A thread may have only one at a time: it holds the state of glslang.
class ShaderCompiler {
 public:
  ShaderCompiler();
  ~ShaderCompiler();
  ShaderCompiler(const ShaderCompiler&) = delete;
  ShaderCompiler& operator=(const ShaderCompiler&) = delete;

  /// Compiles a shader in GLSL or HLSL with the entry point `main`. It is not optimised: the driver does
  /// that. Throws std::logic_error with glslang's messages if the source is not valid, because the sources
  /// are ours.
  ///
  /// A shader in float16 gets halves for its `mediump` numbers (RelaxedPrecision in SPIR-V). For a driver
  /// `mediump` is only a hint, which most ignore. The emitted text stays as it is. The device must have
  /// halves.
  std::vector<std::uint32_t> spirv(const std::string& source, ShaderPrecision precision,
                                   Language language = Language::glsl) const;
};

}  // namespace shadefit::device
