#include "lint/expression/calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "fit/formula/shader_calls.hpp"
#include "fit/support/lines.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// The three components of vec3(a, b, c) or [a, b, c]; empty for any other text.
std::vector<std::string_view> components_of(std::string_view vector) {
  std::size_t open = end_of_run(vector, 0, is_of_name);
  const std::string_view type = vector.substr(0, open);
  if (open > 0 && open < vector.size() && vector[open] == '<') open = vector.find('(', open);
  if (open >= vector.size()) return {};
  const bool is_list = type.empty() && vector[open] == '[' && vector.back() == ']';
  const bool is_call = is_number_type(type) && vector[open] == '(' && vector.back() == ')';
  if (!is_list && !is_call) return {};
  std::vector<std::string_view> parts = arguments_in(vector.substr(open + 1, vector.size() - open - 2));
  return parts.size() == 3 ? parts : std::vector<std::string_view>{};
}

}  // namespace

bool is_number_type(std::string_view word) {
  constexpr std::array<std::string_view, 9> stems{"vec", "float", "half", "double", "min16float",
                                                  "f16", "f32",   "f64",  "real"};
  for (const std::string_view stem : stems) {
    if (!word.starts_with(stem)) continue;
    const std::string_view rest = word.substr(stem.size());
    if (rest.empty() || (rest.size() <= 2 && is_digit(rest.front()))) return true;
    if (rest == "f" || rest.ends_with("f")) return rest.size() == 2 && is_digit(rest.front());  // vec3f
  }
  return word == "Vec3" || word == "VEC3" || word == "Spectrum" || word == "Float" || word == "F1" ||
         word == "F3";
}

std::string usual_name(std::string_view word) {
  const std::string small = in_small_letters(word);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> names{{
      {"powr", "pow"},
      {"spow", "pow"},
      {"powi", "pow"},
      {"power", "pow"},
      {"muladd", "fma"},
      {"madd", "fma"},
      {"deg2rad", "radians"},
      {"degtorad", "radians"},
      {"rad2deg", "degrees"},
      {"radtodeg", "degrees"},
  }};
  for (const auto& [other, usual] : names)
    if (small == other) return std::string(usual);
  if (small.ends_with("sqrt") && !small.ends_with("rsqrt") && small.find("inv") == std::string::npos)
    return "sqrt";
  // Functions of C++ libraries begin with a capital letter: Clamp, Pow.
  return argument_counts(word).empty() ? small : std::string(word);
}

std::optional<std::string> pi_in(std::string_view path) {
  const bool is_constant = std::ranges::none_of(path, [](char c) { return 'a' <= c && c <= 'z'; }) ||
                           path == "pi" || path == "half_pi" || path == "halfPi";
  if (!is_constant) return std::nullopt;
  std::string letters = in_small_letters(path);
  std::erase(letters, '_');
  struct Ending {
    std::string_view words, formula;
  };
  // The first one counts. SQRT_PI and QUARTER_PI are ordinary names.
  constexpr std::array<Ending, 5> endings{{
      {"pidiv2 pi2 piover2 pihalf halfpi", "(pi/2)"},
      {"tau twopi 2pi", "(2*pi)"},
      {"invpi inversepi reciprocalpi rcppi recippi 1pi 1divpi 1overpi oneoverpi", "(1/pi)"},
      {"sqrtpi quarterpi threepi fourpi 3pi 4pi 8pi logpi divpi overpi", ""},
      {"pi", "pi"},
  }};
  for (const auto& [words, formula] : endings) {
    std::istringstream each{std::string(words)};
    for (std::string word; each >> word;)
      if (letters.ends_with(word))
        return formula.empty() ? std::nullopt : std::optional<std::string>(formula);
  }
  return std::nullopt;
}

std::vector<std::string_view> arguments_in(std::string_view list) {
  std::vector<std::string_view> arguments;
  for (;;) {
    const std::size_t comma = place_outside(list, ",");
    arguments.push_back(trimmed(list.substr(0, comma)));
    if (comma == list.size()) return arguments;
    list.remove_prefix(comma + 1);
  }
}

std::optional<std::string> dot_product(std::string_view arguments) {
  const std::vector<std::string_view> vectors = arguments_in(arguments);
  if (vectors.size() != 2) return std::nullopt;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const std::vector<std::string_view> factors = components_of(vectors[i]);
    if (factors.empty()) continue;
    return fmt::format("({1})*first_of({0}) + ({2})*second_of({0}) + ({3})*third_of({0})", vectors[1 - i],
                       factors[0], factors[1], factors[2]);
  }
  return std::nullopt;
}

}  // namespace shadefit::lint
