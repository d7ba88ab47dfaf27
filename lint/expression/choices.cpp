#include "lint/expression/choices.hpp"

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

std::optional<std::string> choice_of(std::string_view function, std::string_view list) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> comparisons{{
      {"lessthan", " < "},
      {"lessthanequal", " <= "},
      {"greaterthan", " > "},
      {"greaterthanequal", " >= "},
  }};
  const std::string name = usual_name(function);
  const std::vector<std::string_view> all = arguments_in(list);
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

}  // namespace shadefit::lint
