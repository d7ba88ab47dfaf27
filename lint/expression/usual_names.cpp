#include "lint/expression/usual_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fit/scalars/shader_calls.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

std::string lower_case_of(std::string_view word) {
  std::string small(word);
  for (char& c : small)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
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
  const std::string small = lower_case_of(word);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> names{{
      {"powr", "pow"},
      {"powi", "pow"},
      {"power", "pow"},
      {"muladd", "fma"},
      {"madd", "fma"},
      {"arccos", "acos"},
      {"arctan", "atan"},
  }};
  for (const auto& [other, usual] : names)
    if (small == other) return std::string(usual);
  if (small.ends_with("sqrt") && !small.ends_with("rsqrt") && small.find("inv") == std::string::npos)
    return "sqrt";
  // Functions of C++ libraries begin with a capital letter: Clamp, Pow.
  return argument_counts(word).empty() ? small : std::string(word);
}

std::optional<std::string> pi_in(std::string_view path) {
  const bool is_constant =
      std::none_of(path.begin(), path.end(), [](char c) { return 'a' <= c && c <= 'z'; }) || path == "pi" ||
      path == "half_pi" || path == "halfPi";
  std::string letters = lower_case_of(path);
  std::erase(letters, '_');
  const auto ends = [&](std::string_view word) { return is_constant && letters.ends_with(word); };
  if (ends("halfpi") || ends("pidiv2") || ends("pi2") || ends("piover2")) return "(pi/2)";
  if (ends("invpi") || ends("1pi") || ends("1divpi")) return "(1/pi)";
  if (ends("twopi") || ends("2pi") || ends("tau")) return "(2*pi)";
  if (ends("pi")) return "pi";
  return std::nullopt;
}

}  // namespace shadefit::lint
