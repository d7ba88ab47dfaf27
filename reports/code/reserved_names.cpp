#include "reports/code/shader_code.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

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
bool is_c_function(std::string_view name, WordList functions) {
  for (const std::string_view suffix : {"", "f", "l", "f16", "f32", "f64", "f128", "f32x", "f64x", "d32",
                                        "d64", "d128", "_r", "f_r", "l_r"}) {
    if (name.ends_with(suffix) && holds_word(functions, name.substr(0, name.size() - suffix.size())))
      return true;
  }
  return false;
}

bool is_vector(std::string_view name) {
  return holds_word(reserved::vector_types, base_of_type(name));
}

bool is_glsl_type(std::string_view name) {
  return is_vector(name) || is_opaque_type(name);
}

/// The names that mean something in a language.
struct ReservedNames {
  std::vector<WordList> words;
  std::vector<WordList> functions;
  std::vector<WordList> c_functions;  ///< also with the suffixes of C
  /// Forms of names that a language reserves for itself and its implementations; '*' is any text.
  WordList forms;
  bool (*is_type)(std::string_view name) = [](std::string_view) { return false; };
};

ReservedNames reserved_in(Language language) {
  using namespace reserved;
  switch (language) {
    case Language::glsl:
      return {{c_words, glsl_words}, {glsl_functions}, {}, "*__* gl_*", is_glsl_type};
    case Language::hlsl:
      return {{c_words, hlsl_words}, {hlsl_functions}, {}, "*__*", is_vector};
    case Language::c:
      return {{c_words, only_c_words}, {}, {c_functions}, "*__* _* *_t"};  // the last by POSIX.1, 2.2.2
    case Language::cpp:
      return {{c_words, cpp_words}, {cpp_functions}, {c_functions}, "*__* _* *_t"};
    case Language::wgsl:
      return {{wgsl_words}, {wgsl_functions}, {}, "_ __*"};
    case Language::msl:
      return {{c_words, cpp_words, msl_words}, {msl_functions}, {}, "*__* _*", is_vector};
    case Language::cuda:
      return {{c_words, cpp_words, cuda_words},
              {cpp_functions},
              {c_functions, cuda_functions},
              "*__* _* *_t make_*",
              is_vector};
    case Language::opencl:
      // Functions on the bits of types, vectors, atomics and work groups have the other forms.
      return {{c_words, opencl_words},
              {opencl_functions},
              {},
              "*__* _* as_* convert_* vload* vstore* atom_* atomic_* work_group_* sub_group_*",
              is_opencl_vector};
  }
  return {};
}

bool has_form_of(WordList forms, const std::string& name) {
  std::istringstream each{std::string(forms)};
  for (std::string form; each >> form;) {
    if (::fnmatch(form.c_str(), name.c_str(), 0) == 0) return true;
  }
  return false;
}

}  // namespace

std::string_view reason_to_refuse_name(std::string_view name, Language language) {
  const ReservedNames names = reserved_in(language);
  const auto is_in = [&](WordList words) { return holds_word(words, name); };
  const auto is_c_function_in = [&](WordList functions) { return is_c_function(name, functions); };
  if (std::ranges::any_of(names.words, is_in) || names.is_type(name)) return "it is a word of the language";
  if (std::ranges::any_of(names.functions, is_in) || std::ranges::any_of(names.c_functions, is_c_function_in))
    return "it is a function of the language or its library";
  if (has_form_of(names.forms, std::string(name))) return "names of that form are reserved";
  return "";
}

}  // namespace shadefit
