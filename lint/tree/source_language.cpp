#include "lint/tree/source_language.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// What is known of a language: its name, its comments, and the endings of its files behind the last dot.
struct LanguageRow {
  std::string_view name;
  CommentStyle comments;
  std::string_view sure, unsure = {};
};

/// In the order of `SourceLanguage`.
/// From the files of engines: glslang (stages), Godot (gdshader), Defold (vp, fp), jMonkeyEngine (glsllib),
/// bgfx (sc, sh), Cocos (chunk, effect), Filament (mat, fs, vs), Unity (shader, cginc, compute, raytrace),
/// Unreal (usf, ush), O3DE (azsl, srgi), CryEngine (cfx, cfi), Stride (sdsl, sdfx), Diligent (psh, vsh, csh),
/// OGRE and Source (cg, fxc), Dagor (dshl), OpenUSD (glslfx), Falcor (slangh). The unsure endings may also be
/// those of a shell script, F#, PHP, MATLAB, PostScript or a material of Unity.
constexpr std::array<LanguageRow, source_languages.size()> languages{{
    {"glsl", CommentStyle::c,
     "glsl glslfx vert frag geom comp tesc tese rgen rint rahit rchit rmiss rcall gl glslinc glsllib glslf glslv glslh "
     "vsh fsh gsh gdshader gdshaderinc",
     "mesh task vp fp vs fs gs sc sh mat matx effect chunk isf"},
    {"hlsl", CommentStyle::c, "hlsl hlsli hlslinc fxh cginc cgfx psh usf ush azsl azsli srgi sdsl sdfx dshl",
     "fx fxc cg cfx cfi csh ps compute shader raytrace"},
    {"wgsl", CommentStyle::c, "wgsl wesl"},
    {"msl", CommentStyle::c, "metal msl"},
    {"c", CommentStyle::c, "h hpp hh hxx h++ inl ipp tpp c cc cpp cxx c++ cppm ixx mm clh ispc isph osl",
     "inc cl m mdl"},
    {"cuda", CommentStyle::c, "cu cuh"},
    {"slang", CommentStyle::c, "slang slangh"},
    {"javascript", CommentStyle::c, "js mjs cjs jsx"},
    {"typescript", CommentStyle::c, "ts mts cts tsx"},
    {"python", CommentStyle::hash, "py"},
    {"rust", CommentStyle::rust, "rs"},
    {"go", CommentStyle::c, "go"},
    {"java", CommentStyle::c, "java"},
    {"csharp", CommentStyle::c, "cs"},
    {"markdown", CommentStyle::none, "md markdown mdx"},
}};

/// Whether a list of words, separated by blanks, has a word.
bool has_word(std::string_view words, std::string_view word) {
  return !word.empty() && fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

/// Words in the first lines of shaders: directives, storage classes, types.
constexpr std::string_view shader_words[] = {"#version", "#include", "#define",  "#ifdef", "#ifndef",
                                             "#pragma",  "uniform ", "varying ", "gl_",    "void main",
                                             "vec2",     "vec3",     "vec4",     "float2", "float3",
                                             "float4",   "half3",    "half4",    "sampler"};

}  // namespace

std::string_view name(SourceLanguage language) {
  return languages[static_cast<std::size_t>(language)].name;
}

CommentStyle comments_of(SourceLanguage language) {
  return languages[static_cast<std::size_t>(language)].comments;
}

std::optional<SourceLanguage> language_named(std::string_view text) {
  const auto found =
      std::ranges::find_if(source_languages, [&](SourceLanguage language) { return name(language) == text; });
  return found == source_languages.end() ? std::nullopt : std::optional(*found);
}

std::optional<NamedLanguage> language_of(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return std::nullopt;
  const std::string whole = in_small_letters(file_name), ending = whole.substr(dot + 1);
  // Babylon.js has GLSL in files with the ending of HLSL.
  if (whole.ends_with(".fragment.fx") || whole.ends_with(".vertex.fx"))
    return NamedLanguage{SourceLanguage::glsl};
  for (const SourceLanguage language : source_languages) {
    const LanguageRow& row = languages[static_cast<std::size_t>(language)];
    if (has_word(row.sure, ending)) return NamedLanguage{language};
    if (has_word(row.unsure, ending)) return NamedLanguage{language, false};
  }
  return std::nullopt;
}

bool looks_like_shader(std::string_view beginning) {
  if (beginning.starts_with("#!")) return false;
  return std::ranges::any_of(
      shader_words, [&](std::string_view word) { return beginning.find(word) != std::string_view::npos; });
}

}  // namespace shadefit::lint
