#include "reports/code/shader_code.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>

#include "reports/code/reserved_words.hpp"

namespace shadefit {
namespace {

using reserved::WordList;

/// Whether a list holds a word.
bool holds_word(WordList words, std::string_view word) {
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (words.substr(begin, end - begin) == word) return true;
    begin = end + 1;
  }
  return false;
}

/// "float3x3" as "float", "vec2" as "vec": what is before the counts of a vector or a matrix; empty where
/// there are none.
std::string_view base_of_type(std::string_view name) {
  const auto is_count = [&](std::size_t i) { return i < name.size() && name[i] >= '1' && name[i] <= '4'; };
  const std::size_t size = name.size();
  if (size > 3 && is_count(size - 1) && name[size - 2] == 'x' && is_count(size - 3))
    return name.substr(0, size - 3);
  return size > 1 && is_count(size - 1) ? name.substr(0, size - 1) : "";
}

/// A vector or matrix of OpenCL C: its vectors may also have 8 or 16 parts.
bool is_opencl_vector(std::string_view name) {
  const std::size_t count = name.ends_with("16") ? 2 : name.ends_with("8") ? 1 : 0;
  return holds_word(reserved::vector_types,
                    count > 0 ? name.substr(0, name.size() - count) : base_of_type(name));
}

/// Types of GLSL's textures begin with one of these.
bool is_opaque_type(std::string_view name) {
  for (const std::string_view prefix :
       {"sampler", "isampler", "usampler", "image", "iimage", "uimage", "texture", "itexture", "utexture",
        "subpassInput", "isubpassInput", "usubpassInput"}) {
    if (!name.starts_with(prefix)) continue;
    const std::string_view rest = name.substr(prefix.size());
    if (rest.empty() || rest == "Buffer" || rest == "Shadow" || rest.starts_with("1D") ||
        rest.starts_with("2D") || rest.starts_with("3D") || rest.starts_with("Cube") || rest == "MS" ||
        rest == "ExternalOES")
      return true;
  }
  return false;
}

/// A function of a library like C's, with its suffix for float, long double, _FloatN or a decimal type.
bool is_c_function(std::string_view name, WordList functions = reserved::c_functions) {
  for (const std::string_view suffix : {"", "f", "l", "f16", "f32", "f64", "f128", "f32x", "f64x", "d32",
                                        "d64", "d128", "_r", "f_r", "l_r"}) {
    if (name.ends_with(suffix) && holds_word(functions, name.substr(0, name.size() - suffix.size())))
      return true;
  }
  return false;
}

/// A function of OpenCL C on vectors, atomics, work groups or the bits of types begins so.
bool has_opencl_prefix(std::string_view name) {
  constexpr std::array prefixes{"as_",   "convert_", "vload",       "vstore",
                                "atom_", "atomic_",  "work_group_", "sub_group_"};
  return std::ranges::any_of(prefixes, [&](const char* p) { return name.starts_with(p); });
}

bool is_any_of(std::string_view name, std::initializer_list<WordList> lists) {
  return std::ranges::any_of(lists, [&](WordList list) { return holds_word(list, name); });
}

bool is_word(std::string_view name, Language language) {
  const bool is_type = holds_word(reserved::vector_types, base_of_type(name));
  switch (language) {
    case Language::glsl:
      return is_type || is_opaque_type(name) || is_any_of(name, {reserved::c_words, reserved::glsl_words});
    case Language::hlsl:
      return is_type || is_any_of(name, {reserved::c_words, reserved::hlsl_words});
    case Language::c:
      return is_any_of(name, {reserved::c_words, reserved::only_c_words});
    case Language::cpp:
      return is_any_of(name, {reserved::c_words, reserved::cpp_words});
    case Language::wgsl:
      return holds_word(reserved::wgsl_words, name);
    case Language::msl:
      return is_type || is_any_of(name, {reserved::c_words, reserved::cpp_words, reserved::msl_words});
    case Language::cuda:
      return is_type || is_any_of(name, {reserved::c_words, reserved::cpp_words, reserved::cuda_words});
    case Language::opencl:
      return is_opencl_vector(name) || is_any_of(name, {reserved::c_words, reserved::opencl_words});
  }
  return false;
}

bool is_function(std::string_view name, Language language) {
  switch (language) {
    case Language::glsl:
      return holds_word(reserved::glsl_functions, name);
    case Language::hlsl:
      return holds_word(reserved::hlsl_functions, name);
    case Language::c:
      return is_c_function(name);
    case Language::cpp:
      return is_c_function(name) || holds_word(reserved::cpp_functions, name);
    case Language::wgsl:
      return holds_word(reserved::wgsl_functions, name);
    case Language::msl:
      return holds_word(reserved::msl_functions, name);
    case Language::cuda:
      return is_c_function(name) || is_c_function(name, reserved::cuda_functions) ||
             holds_word(reserved::cpp_functions, name);
    case Language::opencl:
      return holds_word(reserved::opencl_functions, name);
  }
  return false;
}

/// Forms of names that a language reserves for itself and its implementations.
bool is_reserved_form(std::string_view name, Language language) {
  const bool has_two = name.find("__") != std::string_view::npos;
  switch (language) {
    case Language::glsl:
      return has_two || name.starts_with("gl_");
    case Language::wgsl:
      return name == "_" || name.starts_with("__");
    case Language::hlsl:
      return has_two;
    case Language::c:
    case Language::cpp:
      return has_two || name.starts_with('_') || name.ends_with("_t");  // the last by POSIX.1, 2.2.2
    case Language::cuda:
      return has_two || name.starts_with('_') || name.ends_with("_t") || name.starts_with("make_");
    case Language::msl:
      return has_two || name.starts_with('_');
    case Language::opencl:
      return has_two || name.starts_with('_') || has_opencl_prefix(name);
  }
  return false;
}

}  // namespace

std::string_view reason_to_refuse_name(std::string_view name, Language language) {
  if (is_word(name, language)) return "it is a word of the language";
  if (is_function(name, language)) return "it is a function of the language or its library";
  if (is_reserved_form(name, language)) return "names of that form are reserved";
  return "";
}

}  // namespace shadefit
