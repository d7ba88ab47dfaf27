#include "lint/expression/calls.hpp"

#include <array>
#include <utility>

#include "lint/expression/usual_names.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// Visits the characters outside of inner parentheses.
template <class Visit>
void visit_outer(std::string_view text, const Visit& visit) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ')' || text[i] == ']') --depth;
    if (depth == 0) visit(i);
    if (text[i] == '(' || text[i] == '[') ++depth;
  }
}

bool is_comparison(std::string_view text) {
  bool has_sign = false;
  visit_outer(text, [&](std::size_t i) { has_sign = has_sign || text[i] == '<' || text[i] == '>'; });
  return has_sign;
}

std::string in_parentheses(std::string_view text) {
  return "(" + std::string(text) + ")";
}

std::optional<std::string> choice_of(std::string_view name, const std::vector<std::string_view>& all) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> comparisons{{
      {"lessthan", " < "},
      {"lessthanequal", " <= "},
      {"greaterthan", " > "},
      {"greaterthanequal", " >= "},
  }};
  const auto argument = [&](std::size_t i) { return in_parentheses(all[i]); };
  for (const auto& [word, sign] : comparisons)
    if (name == word && all.size() == 2) return argument(0) + std::string(sign) + argument(1) + " ? 1 : 0";
  if ((name != "select" && name != "where") || all.size() != 3) return std::nullopt;
  const auto choice = [&](std::size_t condition, std::size_t yes, std::size_t no) {
    return std::string(all[condition]) + " ? " + argument(yes) + " : " + argument(no);
  };
  if (is_comparison(all[0])) return choice(0, 1, 2);
  if (is_comparison(all[2])) return choice(2, 1, 0);
  return std::nullopt;
}

/// __fmul_rn(a, b) of CUDA, without its prefix and rounding, as a * b.
std::optional<std::string> operation_of(std::string_view name, const std::vector<std::string_view>& both) {
  constexpr std::array<std::pair<std::string_view, const char*>, 4> operations{
      {{"add", " + "}, {"sub", " - "}, {"mul", " * "}, {"div", " / "}}};
  if (both.size() != 2 || (!name.starts_with('f') && !name.starts_with('d'))) return std::nullopt;
  for (const auto& [word, sign] : operations)
    if (name.substr(1) == word) return in_parentheses(both[0]) + sign + in_parentheses(both[1]);
  return std::nullopt;
}

/// The three components of vec3(a, b, c) or [a, b, c]; empty for any other text.
std::vector<std::string_view> components_of(std::string_view vector) {
  std::size_t open = 0;
  while (open < vector.size() && is_of_name(vector[open])) ++open;
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
    const auto term = [&](std::size_t component, const char* name) {
      return in_parentheses(factors[component]) + "*" + name + in_parentheses(vectors[1 - i]);
    };
    return term(0, "first_of") + " + " + term(1, "second_of") + " + " + term(2, "third_of");
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string_view> arguments_in(std::string_view list) {
  std::vector<std::string_view> arguments;
  const auto append = [&](std::string_view part) {
    while (!part.empty() && is_blank(part.front())) part.remove_prefix(1);
    while (!part.empty() && is_blank(part.back())) part.remove_suffix(1);
    arguments.push_back(part);
  };
  std::size_t begin = 0;
  visit_outer(list, [&](std::size_t i) {
    if (list[i] != ',') return;
    append(list.substr(begin, i - begin));
    begin = i + 1;
  });
  append(list.substr(begin));
  return arguments;
}

std::optional<std::string> call_as_formula(std::string_view function, std::string_view arguments) {
  const std::string name = usual_name(function);
  const std::vector<std::string_view> all = arguments_in(arguments);
  if (name == "dot") return product_of(all);
  if (const auto operation = operation_of(name, all)) return operation;
  return choice_of(name, all);
}

}  // namespace shadefit::lint
