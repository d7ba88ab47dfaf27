#include "lint/tree/source_language.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace shadefit::lint {
namespace {

using Language = SourceLanguage;

/// The endings of a language's files, after the last dot.
struct Endings {
  Language language;
  std::string_view sure, unsure = {};
};

/// From the files of engines: glslang (stages), Godot (gdshader), Defold (vp, fp), jMonkeyEngine (glsllib),
/// bgfx (sc, sh), Cocos (chunk, effect), Filament (mat, fs, vs), Unity (shader, cginc, compute, raytrace),
/// Unreal (usf, ush), O3DE (azsl, srgi), CryEngine (cfx, cfi), Stride (sdsl, sdfx), Diligent (psh, vsh, csh),
/// OGRE and Source (cg, fxc), Dagor (dshl), OpenUSD (glslfx), Falcor (slangh). The unsure endings may also be
/// those of a shell script, F#, PHP, MATLAB, PostScript or a material of Unity.
constexpr Endings endings[] = {
    {Language::glsl,
     "glsl glslfx vert frag geom comp tesc tese rgen rint rahit rchit rmiss rcall gl glslinc glsllib glslf glslv glslh "
     "vsh fsh gsh gdshader gdshaderinc",
     "mesh task vp fp vs fs gs sc sh mat matx effect chunk isf"},
    {Language::hlsl, "hlsl hlsli hlslinc fxh cginc cgfx psh usf ush azsl azsli srgi sdsl sdfx dshl",
     "fx fxc cg cfx cfi csh ps compute shader raytrace"},
    {Language::wgsl, "wgsl wesl"},
    {Language::msl, "metal msl"},
    {Language::slang, "slang slangh"},
    {Language::c_family, "h hpp hh hxx h++ inl ipp tpp c cc cpp cxx c++ cppm ixx mm clh ispc isph osl",
     "inc cl m mdl"},
    {Language::cuda, "cu cuh"},
    {Language::javascript, "js mjs cjs jsx"},
    {Language::typescript, "ts mts cts tsx"},
    {Language::python, "py"},
    {Language::rust, "rs"},
    {Language::go, "go"},
    {Language::java, "java"},
    {Language::csharp, "cs"},
    {Language::markdown, "md markdown mdx"},
};

/// Whether a list of words, separated by blanks, has a word.
bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return !word.empty();
  }
  return false;
}

/// Words in the first lines of shaders: directives, storage classes, types.
constexpr std::string_view shader_words[] = {"#version", "#include", "#define",  "#ifdef", "#ifndef",
                                             "#pragma",  "uniform ", "varying ", "gl_",    "void main",
                                             "vec2",     "vec3",     "vec4",     "float2", "float3",
                                             "float4",   "half3",    "half4",    "sampler"};

}  // namespace

std::string_view name(SourceLanguage language) {
  switch (language) {
    case Language::glsl:
      return "glsl";
    case Language::hlsl:
      return "hlsl";
    case Language::wgsl:
      return "wgsl";
    case Language::msl:
      return "msl";
    case Language::c_family:
      return "c";
    case Language::cuda:
      return "cuda";
    case Language::slang:
      return "slang";
    case Language::javascript:
      return "javascript";
    case Language::typescript:
      return "typescript";
    case Language::python:
      return "python";
    case Language::rust:
      return "rust";
    case Language::go:
      return "go";
    case Language::java:
      return "java";
    case Language::csharp:
      return "csharp";
    case Language::markdown:
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

std::string in_small_letters(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::optional<NamedLanguage> language_of(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return std::nullopt;
  const std::string whole = in_small_letters(file_name), ending = whole.substr(dot + 1);
  // Babylon.js has GLSL in files with the ending of HLSL.
  if (whole.ends_with(".fragment.fx") || whole.ends_with(".vertex.fx")) return NamedLanguage{Language::glsl};
  for (const Endings& one : endings) {
    if (has_word(one.sure, ending)) return NamedLanguage{one.language};
    if (has_word(one.unsure, ending)) return NamedLanguage{one.language, false};
  }
  return std::nullopt;
}

bool looks_like_shader(std::string_view beginning) {
  if (beginning.starts_with("#!")) return false;
  return std::any_of(std::begin(shader_words), std::end(shader_words),
                     [&](std::string_view word) { return beginning.find(word) != std::string_view::npos; });
}

}  // namespace shadefit::lint
