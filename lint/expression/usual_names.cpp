#include "lint/expression/usual_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fit/formula/shader_calls.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// pi/2 for names such as PI_DIV_2 and M_PI_2, 2 pi for TAU.
std::optional<std::string> divided_pi(std::string_view letters) {
  for (const std::string_view word : {"pidiv2", "pi2", "piover2", "pihalf"})
    if (letters.ends_with(word)) return "(pi/2)";
  return letters.ends_with("tau") ? std::optional<std::string>("(2*pi)") : std::nullopt;
}

/// The name of a faster or exactly rounded function without what says so: __powf and __fmaf_rn of CUDA,
/// native_exp2 of OpenCL.
std::string_view plain_name(std::string_view word) {
  for (const std::string_view prefix : {"__builtin_", "native_", "half_", "__"}) {
    if (!word.starts_with(prefix)) continue;
    word.remove_prefix(prefix.size());
    break;
  }
  for (const std::string_view rounding : {"_rn", "_rz", "_ru", "_rd"})
    if (word.ends_with(rounding)) word.remove_suffix(rounding.size());
  return word;
}

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
  word = plain_name(word);
  const std::string small = lower_case_of(word);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 17> names{{
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
      {"arccos", "acos"},
      {"arctan", "atan"},
      {"frcp", "rcp"},  // of CUDA
      {"drcp", "rcp"},
      {"recip", "rcp"},  // of OpenCL
      {"frsqrt", "rsqrt"},
      {"fdividef", "fdiv"},
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
  if (!is_constant || !letters.ends_with("pi")) return is_constant ? divided_pi(letters) : std::nullopt;
  letters.resize(letters.size() - 2);
  const auto ends = [&](std::string_view word) { return letters.ends_with(word); };
  if (ends("half")) return "(pi/2)";
  if (ends("two") || ends("2")) return "(2*pi)";
  for (const std::string_view word :
       {"inv", "inverse", "reciprocal", "rcp", "recip", "1", "1div", "1over", "oneover"})
    if (ends(word)) return "(1/pi)";
  // SQRT_PI and QUARTER_PI are ordinary names.
  for (const std::string_view word :
       {"sqrt", "quarter", "three", "four", "3", "4", "8", "log", "div", "over"})
    if (ends(word)) return std::nullopt;
  return "pi";
}

}  // namespace shadefit::lint
