#include "lint/tree/source_language.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace shadefit::lint {
namespace {

struct Ending {
  std::string_view text;  ///< behind the last dot
  NamedLanguage language;
};

constexpr NamedLanguage sure(SourceLanguage language) {
  return {language, true};
}

constexpr NamedLanguage unsure(SourceLanguage language) {
  return {language, false};
}

using enum SourceLanguage;

/// By the files of engines: glslang (stages), Godot (gdshader), Defold (vp, fp), jMonkeyEngine (glsllib),
/// bgfx (sc, sh), Cocos (chunk, effect), Filament (mat, fs, vs), Unity (shader, cginc, compute, raytrace),
/// Unreal (usf, ush), O3DE (azsl, srgi), CryEngine (cfx, cfi), Stride (sdsl, sdfx), Diligent (psh, vsh, csh),
/// OGRE and Source (cg, fxc), Falcor (slangh). A shell script, F#, PHP, MATLAB or a material of Unity may
/// have the endings that are not sure.
constexpr Ending endings[] = {
    {"glsl", sure(glsl)},       {"vert", sure(glsl)},      {"frag", sure(glsl)},
    {"geom", sure(glsl)},       {"comp", sure(glsl)},      {"tesc", sure(glsl)},
    {"tese", sure(glsl)},       {"mesh", unsure(glsl)},    {"task", unsure(glsl)},
    {"rgen", sure(glsl)},       {"rint", sure(glsl)},      {"rahit", sure(glsl)},
    {"rchit", sure(glsl)},      {"rmiss", sure(glsl)},     {"rcall", sure(glsl)},
    {"gl", sure(glsl)},         {"glslinc", sure(glsl)},   {"glsllib", sure(glsl)},
    {"glslf", sure(glsl)},      {"glslv", sure(glsl)},     {"glslh", sure(glsl)},
    {"vsh", sure(glsl)},        {"fsh", sure(glsl)},       {"gsh", sure(glsl)},
    {"vp", unsure(glsl)},       {"fp", unsure(glsl)},      {"vs", unsure(glsl)},
    {"fs", unsure(glsl)},       {"gs", unsure(glsl)},      {"sc", unsure(glsl)},
    {"sh", unsure(glsl)},       {"gdshader", sure(glsl)},  {"gdshaderinc", sure(glsl)},
    {"mat", unsure(glsl)},      {"matx", unsure(glsl)},    {"effect", unsure(glsl)},
    {"chunk", unsure(glsl)},    {"isf", unsure(glsl)},     {"hlsl", sure(hlsl)},
    {"hlsli", sure(hlsl)},      {"hlslinc", sure(hlsl)},   {"fx", unsure(hlsl)},
    {"fxh", sure(hlsl)},        {"fxc", unsure(hlsl)},     {"cginc", sure(hlsl)},
    {"cg", unsure(hlsl)},       {"cgfx", sure(hlsl)},      {"cfx", unsure(hlsl)},
    {"cfi", unsure(hlsl)},      {"compute", unsure(hlsl)}, {"shader", unsure(hlsl)},
    {"raytrace", unsure(hlsl)}, {"psh", sure(hlsl)},       {"csh", unsure(hlsl)},
    {"usf", sure(hlsl)},        {"ush", sure(hlsl)},       {"azsl", sure(hlsl)},
    {"azsli", sure(hlsl)},      {"srgi", sure(hlsl)},      {"sdsl", sure(hlsl)},
    {"sdfx", sure(hlsl)},       {"wgsl", sure(wgsl)},      {"metal", sure(msl)},
    {"msl", sure(msl)},         {"slang", sure(slang)},    {"slangh", sure(slang)},
    {"h", sure(c_family)},      {"hpp", sure(c_family)},   {"hh", sure(c_family)},
    {"hxx", sure(c_family)},    {"h++", sure(c_family)},   {"inl", sure(c_family)},
    {"ipp", sure(c_family)},    {"tpp", sure(c_family)},   {"inc", unsure(c_family)},
    {"c", sure(c_family)},      {"cc", sure(c_family)},    {"cpp", sure(c_family)},
    {"cxx", sure(c_family)},    {"c++", sure(c_family)},   {"cppm", sure(c_family)},
    {"ixx", sure(c_family)},    {"mm", sure(c_family)},    {"cl", unsure(c_family)},
    {"clh", sure(c_family)},    {"ispc", sure(c_family)},  {"isph", sure(c_family)},
    {"osl", sure(c_family)},    {"cu", sure(cuda)},        {"cuh", sure(cuda)},
    {"js", sure(javascript)},   {"mjs", sure(javascript)}, {"cjs", sure(javascript)},
    {"jsx", sure(javascript)},  {"ts", sure(typescript)},  {"mts", sure(typescript)},
    {"cts", sure(typescript)},  {"tsx", sure(typescript)}, {"py", sure(python)},
    {"rs", sure(rust)},         {"go", sure(go)},          {"java", sure(java)},
    {"cs", sure(csharp)},       {"md", sure(markdown)},    {"markdown", sure(markdown)},
    {"mdx", sure(markdown)},
};

/// What shaders have in their first lines: directives, storage classes, types.
constexpr std::string_view shader_words[] = {"#version", "#include", "#define",  "#ifdef", "#ifndef",
                                             "#pragma",  "uniform ", "varying ", "gl_",    "void main",
                                             "vec2",     "vec3",     "vec4",     "float2", "float3",
                                             "float4",   "half3",    "half4",    "sampler"};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace

std::string_view name(SourceLanguage language) {
  switch (language) {
    case glsl:
      return "glsl";
    case hlsl:
      return "hlsl";
    case wgsl:
      return "wgsl";
    case msl:
      return "msl";
    case c_family:
      return "c";
    case cuda:
      return "cuda";
    case slang:
      return "slang";
    case javascript:
      return "javascript";
    case typescript:
      return "typescript";
    case python:
      return "python";
    case rust:
      return "rust";
    case go:
      return "go";
    case java:
      return "java";
    case csharp:
      return "csharp";
    case markdown:
      return "markdown";
  }
  return "unknown";
}

std::optional<SourceLanguage> language_named(std::string_view text) {
  const auto found = std::find_if(source_languages.begin(), source_languages.end(),
                                  [&](SourceLanguage language) { return name(language) == text; });
  if (found == source_languages.end()) return std::nullopt;
  return *found;
}

std::optional<NamedLanguage> language_of(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return std::nullopt;
  const std::string whole = lower(file_name), ending = whole.substr(dot + 1);
  // Babylon.js keeps GLSL in files with the ending of HLSL.
  if (whole.ends_with(".fragment.fx") || whole.ends_with(".vertex.fx")) return sure(glsl);
  for (const Ending& one : endings)
    if (one.text == ending) return one.language;
  return std::nullopt;
}

bool looks_like_shader(std::string_view beginning) {
  if (beginning.starts_with("#!")) return false;
  return std::any_of(std::begin(shader_words), std::end(shader_words),
                     [&](std::string_view word) { return beginning.find(word) != std::string_view::npos; });
}

}  // namespace shadefit::lint
