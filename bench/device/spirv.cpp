#include "bench/device/spirv.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <spirv-tools/optimizer.hpp>
#include <stdexcept>

namespace shadefit::device {
namespace {

[[noreturn]] void refuse(const std::string& what, const char* log, const std::string& source) {
  throw std::logic_error("glslang: " + what + ": " + log + "\n" + source);
}

std::vector<std::uint32_t> with_halves(const std::vector<std::uint32_t>& spirv) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.RegisterPass(spvtools::CreateConvertRelaxedToHalfPass());
  std::vector<std::uint32_t> words;
  if (!optimizer.Run(spirv.data(), spirv.size(), &words))
    throw std::logic_error("the shader has no version in half");
  return words;
}

}  // namespace

ShaderCompiler::ShaderCompiler() {
  glslang::InitializeProcess();
}

ShaderCompiler::~ShaderCompiler() {
  glslang::FinalizeProcess();
}

std::vector<std::uint32_t> ShaderCompiler::spirv(const std::string& source, ShaderPrecision precision,
                                                 Language language) const {
  const bool is_hlsl = language == Language::hlsl;
  constexpr int glsl_version = 450, vulkan_version = 100;
  auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  if (is_hlsl) messages = static_cast<EShMessages>(messages | EShMsgReadHlsl | EShMsgHlslOffsets);
  const char* const text = source.c_str();

  glslang::TShader shader(EShLangCompute);
  shader.setStrings(&text, 1);
  shader.setEntryPoint("main");
  shader.setSourceEntryPoint("main");
  shader.setEnvInput(is_hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, EShLangCompute,
                     glslang::EShClientVulkan, vulkan_version);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  if (!shader.parse(GetDefaultResources(), glsl_version, false, messages))
    refuse("the shader is not valid", shader.getInfoLog(), source);
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages)) refuse("the shader does not link", program.getInfoLog(), source);
  std::vector<std::uint32_t> words;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words);
  return precision == ShaderPrecision::float16 ? with_halves(words) : words;
}

}  // namespace shadefit::device
