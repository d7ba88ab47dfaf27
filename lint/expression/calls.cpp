#include "lint/expression/calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "fit/formula/shader_calls.hpp"
#include "lint/expression/statements.hpp"
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

bool is_comparison(std::string_view text) {
  return std::min(place_outside(text, "<"), place_outside(text, ">")) < text.size();
}

std::optional<std::string> choice_of(std::string_view name, const std::vector<std::string_view>& all) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> comparisons{
      {{"lessthan", "<"}, {"lessthanequal", "<="}, {"greaterthan", ">"}, {"greaterthanequal", ">="}}};
  for (const auto& [word, sign] : comparisons)
    if (name == word && all.size() == 2) return fmt::format("({}) {} ({}) ? 1 : 0", all[0], sign, all[1]);
  if ((name != "select" && name != "where") || all.size() != 3) return std::nullopt;
  if (is_comparison(all[0])) return fmt::format("{} ? ({}) : ({})", all[0], all[1], all[2]);
  if (is_comparison(all[2])) return fmt::format("{} ? ({}) : ({})", all[2], all[1], all[0]);
  return std::nullopt;
}

/// __fmul_rn(a, b) of CUDA, without its prefix and rounding, as a * b.
std::optional<std::string> operation_of(std::string_view name, const std::vector<std::string_view>& both) {
  if (both.size() != 2 || (!name.starts_with('f') && !name.starts_with('d'))) return std::nullopt;
  const std::string_view sign = operator_of(name.substr(1));
  return sign.empty() ? std::nullopt : std::optional(fmt::format("({}){}({})", both[0], sign, both[1]));
}

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

std::optional<std::string> product_of(const std::vector<std::string_view>& vectors) {
  if (vectors.size() != 2) return std::nullopt;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const std::vector<std::string_view> factors = components_of(vectors[i]);
    if (factors.empty()) continue;
    return fmt::format("({1})*first_of({0}) + ({2})*second_of({0}) + ({3})*third_of({0})", vectors[1 - i],
                       factors[0], factors[1], factors[2]);
  }
  return std::nullopt;
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
  const std::string small = in_small_letters(word);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 15> names{{
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
  const bool is_constant = std::ranges::none_of(path, [](char c) { return 'a' <= c && c <= 'z'; }) ||
                           path == "pi" || path == "half_pi" || path == "halfPi";
  std::string letters = in_small_letters(path);
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

std::vector<std::string_view> arguments_in(std::string_view list) {
  std::vector<std::string_view> arguments;
  for (;;) {
    const std::size_t comma = place_outside(list, ",");
    arguments.push_back(trimmed(list.substr(0, comma)));
    if (comma == list.size()) return arguments;
    list.remove_prefix(comma + 1);
  }
}

std::string_view operator_of(std::string_view word) {
  if (word == "mul") return " * ";
  if (word == "add") return " + ";
  if (word == "sub") return " - ";
  return word == "div" ? " / " : "";
}

std::optional<std::string> call_as_formula(std::string_view function, std::string_view arguments) {
  const std::string name = usual_name(function);
  const std::vector<std::string_view> all = arguments_in(arguments);
  if (name == "dot") return product_of(all);
  if (const auto operation = operation_of(name, all)) return operation;
  return choice_of(name, all);
}

}  // namespace shadefit::lint
