#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Shaders as SPIR-V, compiled by glslang.
namespace shadefit::device {

enum class ShaderLanguage { glsl, hlsl };

/// A compiler of compute shaders. Only one may exist at a time in a thread of work; it holds what glslang
/// prepares once.
class ShaderCompiler {
 public:
  ShaderCompiler();
  ~ShaderCompiler();
  ShaderCompiler(const ShaderCompiler&) = delete;
  ShaderCompiler& operator=(const ShaderCompiler&) = delete;

  /// A shader with the entry point `main`. Nothing is optimised here: the driver does that. Throws
  /// std::logic_error with glslang's messages if the source is not valid: sources are ours.
  std::vector<std::uint32_t> spirv(const std::string& source, ShaderLanguage language) const;
};

/// A shader whose `mediump` numbers (RelaxedPrecision in SPIR-V) are halves: to a driver that word is only a
/// hint, which most of them ignore. The emitted text stays as it is. The device must have halves.
std::vector<std::uint32_t> with_halves(const std::vector<std::uint32_t>& spirv);

}  // namespace shadefit::device
