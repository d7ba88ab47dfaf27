#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "lint/scan/literals.hpp"

/// The languages of source files, and how to tell them apart.
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

/// How it writes comments.
CommentStyle comments_of(SourceLanguage language);

/// The language of that name; empty if there is none.
std::optional<SourceLanguage> language_named(std::string_view name);

/// What the name of a file tells about its language.
struct NamedLanguage {
  SourceLanguage language;
  bool is_sure = true;  ///< false: other files have this ending too, `looks_like_shader` decides
};

/// The language of a file by the ending of its name, in upper or lower case; empty for other files.
std::optional<NamedLanguage> language_of(std::string_view file_name);

/// Whether a text has a word that occurs in shaders, but not in shell scripts, F#, PHP and YAML. A script
/// that names its interpreter is not a shader.
bool looks_like_shader(std::string_view beginning);

}  // namespace shadefit::lint
