#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

/// The languages that source files are written in, and how they are told apart.
namespace shadefit::lint {

/// `c_family`: C, C++, Objective-C++, OpenCL, ISPC and OSL. `markdown`: code in fences.
enum class SourceLanguage {
  glsl,
  hlsl,
  wgsl,
  msl,
  c_family,
  cuda,
  slang,
  javascript,
  typescript,
  python,
  rust,
  go,
  java,
  csharp,
  markdown
};

inline constexpr std::array source_languages{
    SourceLanguage::glsl,       SourceLanguage::hlsl,   SourceLanguage::wgsl,    SourceLanguage::msl,
    SourceLanguage::c_family,   SourceLanguage::cuda,   SourceLanguage::slang,   SourceLanguage::javascript,
    SourceLanguage::typescript, SourceLanguage::python, SourceLanguage::rust,    SourceLanguage::go,
    SourceLanguage::java,       SourceLanguage::csharp, SourceLanguage::markdown};

/// Its name for options and messages: "glsl", "c", "cuda" ..
std::string_view name(SourceLanguage language);

/// The language of that name, or nothing.
std::optional<SourceLanguage> language_named(std::string_view name);

/// The text with small letters for those of ASCII.
std::string in_small_letters(std::string_view text);

/// What the name of a file says about its language.
struct NamedLanguage {
  SourceLanguage language;
  bool is_sure = true;  ///< false: other files have this ending too, `looks_like_shader` decides
};

/// The language of a file by the ending of its name, in large or small letters; nothing for other files.
std::optional<NamedLanguage> language_of(std::string_view file_name);

/// Whether a text has a word that shaders have and that shell scripts, F#, PHP and YAML have not. A script
/// that names its interpreter is none.
bool looks_like_shader(std::string_view beginning);

}  // namespace shadefit::lint
