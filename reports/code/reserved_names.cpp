#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>

#include "reports/code/reserved_files.hpp"
#include "reports/code/shader_code.hpp"

namespace shadefit {
namespace {

/// Whether `is_it` holds for a word of a list, a file of reports/code/reserved:
/// - `c_functions`: functions of <math.h> and of CUDA without the suffixes of C, and what else stands in the
///   headers of C or what <cmath> and <algorithm> may bring;
/// - `words`: keywords, reserved words, types and functions of all languages;
/// - `vector_types`: bases of the types of vectors and matrices;
/// - `forms`: forms of names that a language reserves for itself and its implementations; '*' is any text.
bool any_of(std::string_view list, const std::function<bool(const std::string&)>& is_it) {
  std::istringstream words{std::string(embedded_text(reserved_files, list))};
  for (std::string word; words >> word;) {
    if (is_it(word)) return true;
  }
  return false;
}

bool holds_word(std::string_view list, std::string_view word) {
  return any_of(list, [&](const std::string& one) { return one == word; });
}

/// "float3x3", "vec2", "half16": a base with the counts of a vector or a matrix.
bool is_vector(std::string_view name) {
  const std::string_view base = name.substr(0, name.find_last_not_of("1234568x") + 1);
  return base.size() < name.size() && holds_word("vector_types", base);
}

/// A function of a library like C's, with its suffix for float, long double, _FloatN or a decimal type.
bool is_c_function(std::string_view name) {
  constexpr std::array suffixes{"",     "f",   "l",   "f16",  "f32", "f64", "f128", "f32x",
                                "f64x", "d32", "d64", "d128", "_r",  "f_r", "l_r"};
  return std::ranges::any_of(suffixes, [&](std::string_view suffix) {
    return name.ends_with(suffix) && holds_word("c_functions", name.substr(0, name.size() - suffix.size()));
  });
}

}  // namespace

std::string_view reason_to_refuse_name(std::string_view name) {
  if (holds_word("words", name) || is_vector(name) || is_c_function(name))
    return "it is a word or a function of a language";
  const bool is_of_form = any_of("forms", [&](const std::string& form) {
    return ::fnmatch(form.c_str(), std::string(name).c_str(), 0) == 0;
  });
  return is_of_form ? "names of that form are reserved in a language" : "";
}

}  // namespace shadefit
