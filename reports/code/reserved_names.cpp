#include <fnmatch.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>

#include "reports/code/reserved_words.hpp"
#include "reports/code/shader_code.hpp"

namespace shadefit {
namespace {

using reserved::WordList;

/// Whether `is_it` holds for a word of a list.
bool any_of(WordList list, const std::function<bool(const std::string&)>& is_it) {
  std::istringstream words{std::string(list)};
  for (std::string word; words >> word;) {
    if (is_it(word)) return true;
  }
  return false;
}

bool holds_word(WordList words, std::string_view word) {
  return any_of(words, [&](const std::string& one) { return one == word; });
}

/// "float3x3", "vec2", "half16": a base with the counts of a vector or a matrix.
bool is_vector(std::string_view name) {
  const std::string_view base = name.substr(0, name.find_last_not_of("1234568x") + 1);
  return base.size() < name.size() && holds_word(reserved::vector_types, base);
}

/// A function of a library like C's, with its suffix for float, long double, _FloatN or a decimal type.
bool is_c_function(std::string_view name) {
  constexpr std::array suffixes{"",     "f",   "l",   "f16",  "f32", "f64", "f128", "f32x",
                                "f64x", "d32", "d64", "d128", "_r",  "f_r", "l_r"};
  return std::ranges::any_of(suffixes, [&](std::string_view suffix) {
    return name.ends_with(suffix) &&
           holds_word(reserved::c_functions, name.substr(0, name.size() - suffix.size()));
  });
}

}  // namespace

std::string_view reason_to_refuse_name(std::string_view name) {
  if (holds_word(reserved::words, name) || is_vector(name) || is_c_function(name))
    return "it is a word or a function of a language";
  const bool is_of_form = any_of(reserved::forms, [&](const std::string& form) {
    return ::fnmatch(form.c_str(), std::string(name).c_str(), 0) == 0;
  });
  return is_of_form ? "names of that form are reserved in a language" : "";
}

}  // namespace shadefit
