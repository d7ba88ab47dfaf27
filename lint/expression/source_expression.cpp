#include "lint/expression/source_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "fit/formula/formula_text.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/formula/shader_calls.hpp"
#include "lint/expression/calls.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

Symbolic read_program(std::string_view text);

/// The text in the parentheses or brackets that open at the place. Moves behind them.
std::string_view group_at(FormulaText& text, char open, char close) {
  const std::string_view rest = text.rest();
  std::size_t depth = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] == open) ++depth;
    if (rest[i] != close || --depth > 0) continue;
    text.go_to(text.place() + i + 1);
    return rest.substr(1, i - 1);
  }
  text.fail(std::string(1, close));
}

/// A decimal number without its suffix and separators.
Symbolic number_at(FormulaText& text) {
  const Notation number = parts_of_number(text.rest());
  if (number.suffix.starts_with('x') || number.suffix.starts_with('X')) text.fail("a decimal number");
  std::string digits(text.rest().substr(0, number.length - number.suffix.size()));
  std::erase_if(digits, [](char c) { return is_one_of(c, "_'"); });
  text.go_to(text.place() + number.length);
  return Symbolic::number(FormulaText(digits).number());
}

std::string word_at(FormulaText& text) {
  const std::string_view rest = text.rest(), word = rest.substr(0, end_of_run(rest, 0, is_of_name));
  text.go_to(text.place() + word.size());
  return std::string(word);
}

/// Prefixes of functions that have no meaning here: Math.pow, np.exp, System.MathF.Pow.
bool is_module(std::string_view path) {
  constexpr std::array<std::string_view, 11> modules{"Math",  "MathF", "Mathf", "StrictMath", "math", "np",
                                                     "numpy", "jnp",   "torch", "tf",         "dr"};
  const std::string_view last = path.substr(path.rfind('.') + 1);
  return std::ranges::find(modules, last) != modules.end();
}

/// Whether a text begins with a method of the number before it: .powf(2.4).
bool begins_method(std::string_view text) {
  constexpr std::array<std::string_view, 14> methods{".powf(",  ".powi(",  ".pow(", ".sqrt()", ".exp()",
                                                     ".exp2()", ".log2()", ".ln()", ".abs()",  ".mul_add(",
                                                     ".mul(",   ".add(",   ".sub(", ".div("};
  return std::ranges::any_of(methods, [&](std::string_view method) { return text.starts_with(method); });
}

/// A name with its members, elements and qualifiers.
std::string path_at(FormulaText& text) {
  std::string path = word_at(text);
  const auto skip = [&](std::string_view sign) {
    return is_of_name(text.next(sign.size())) && text.rest().starts_with(sign) && text.skip(sign);
  };
  while (true) {
    if (skip("::")) {
      path = word_at(text);  // a namespace has no meaning here
    } else if (skip("->")) {
      path += "." + word_at(text);
    } else if ((is_module(path) || !begins_method(text.rest())) && skip(".")) {
      const std::string member = word_at(text);
      path = is_module(path) ? member : path + "." + member;
    } else if (text.next() == '[') {
      path += "[" + std::string(group_at(text, '[', ']')) + "]";
    } else {
      return path;
    }
  }
}

/// A function of the values, and of the arguments in a list behind them.
Symbolic call_of(std::string_view function, std::vector<Symbolic> values, std::string_view list) {
  if (values.empty() || !list.empty())
    for (const std::string_view argument : arguments_in(list)) values.push_back(read_program(argument));
  const std::vector<std::size_t> counts = argument_counts(function);
  if (std::ranges::find(counts, values.size()) == counts.end())
    throw std::invalid_argument(fmt::format("{} arguments of {}", values.size(), function));
  return call(function, values);
}

/// A name that ends at the place. Directly behind it stands no other, as in "(2k)th" of a sentence.
Symbolic name_before(const FormulaText& text, const std::string& name) {
  if (is_of_name(text.next())) text.fail("an operator");
  return Symbolic::variable(name);
}

/// What stands before a list in parentheses and the list: a constructor, a function, or else a name.
Symbolic call_at(const std::string& path, FormulaText& text) {
  const std::string_view list = group_at(text, '(', ')');
  if (is_number_type(path)) {
    // The components of a vector may all be the same: vec3(0.055, 0.055, 0.055).
    const std::vector<std::string_view> components = arguments_in(list);
    if (std::ranges::count(components, components.front()) < std::ssize(components))
      text.fail("a vector of one number");
    return read_program(components.front());
  }
  const std::string function = usual_name(path);
  if (!argument_counts(function).empty()) return call_of(function, {}, list);
  if (const auto sum = function == "dot" ? dot_product(list) : std::nullopt) return read_program(*sum);
  return name_before(text, path + "(" + std::string(list) + ")");
}

/// A number; or a name with what belongs to it.
Symbolic atom_at(FormulaText& text) {
  if (text.begins_number()) return number_at(text);
  const std::string path = path_at(text);
  if (is_number_type(path) && text.next() == '<')
    text.go_to(text.place() + std::min(text.rest().find('>'), text.rest().size() - 1) + 1);
  const std::size_t behind = text.place();
  if (text.peek() == '(') return call_at(path, text);
  text.go_to(behind);
  const auto multiple = pi_in(path);
  return multiple ? parse_formula(*multiple, {}) : name_before(text, path);
}

/// The value of a method: x.powf(2.4) is pow(x, 2.4). x.mul(2) of three.js and of matrix
/// libraries is x * 2.
Symbolic method_at(const Symbolic& value, FormulaText& text) {
  std::string function = word_at(text);
  const std::string_view list = group_at(text, '(', ')');
  if (function == "mul") return value * read_program(list);
  if (function == "add") return value + read_program(list);
  if (function == "sub") return value - read_program(list);
  if (function == "div") return value / read_program(list);
  if (function == "ln") function = "log";
  if (function == "powi" || function == "powf") function = "pow";
  if (function == "mul_add") function = "fma";
  return call_of(function, {value}, list);
}

/// A value with the methods behind it in its line. Its components change nothing: (..).xyz.
Symbolic with_methods(Symbolic value, FormulaText& text) {
  while (true) {
    const std::string_view rest = text.rest();
    const bool is_method = begins_method(rest.substr(std::min(rest.find_first_not_of(' '), rest.size())));
    if (text.peek() == '^') text.fail("an operation of scalars");
    if (!text.skip('.')) return value;
    if (is_method) {
      value = method_at(value, text);
      continue;
    }
    const std::string components = word_at(text);
    if (components.empty() || components.size() > 4 ||
        components.find_first_not_of("xyzwrgba") != std::string::npos)
      text.fail("components");
  }
}

/// Signs that change nothing, as in "return + a * x", are blanks; not those of "++i".
void drop_unary_plus(std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '+' || text.substr(i + 1, 1) == "+") continue;
    const std::size_t end = begin_of_run(text, i, is_blank);
    if (end == 0 || is_one_of(text[end - 1], "+-*/^(,?:<>=&|")) text[i] = ' ';
  }
}

/// Throws std::invalid_argument if the text is not an expression of scalars.
Symbolic read_program(std::string_view text) {
  static constexpr ProgramNotation notation{atom_at, with_methods};
  return read_formula(text, {.variables = {}, .program = &notation}).formula;
}

/// Python's "a if x < t else b" as x < t ? a : b.
std::string with_sign_of_choice(std::string text) {
  constexpr std::string_view condition = " if ", other = " else ";
  const std::size_t first = place_outside(text, condition), second = place_outside(text, other);
  if (second == text.size() || second < first) return text;
  const std::size_t begin = first + condition.size();
  return fmt::format("({}) ? ({}) : ({})", text.substr(begin, second - begin), text.substr(0, first),
                     with_sign_of_choice(text.substr(second + other.size())));
}

/// A person does not write deeper expressions, and a stack of 256 kB does not hold them.
constexpr std::size_t deepest_expression = 60;
constexpr long deepest_parentheses = 40;

long deepest_parentheses_in(std::string_view text) {
  long depth = 0, deepest = 0;
  for (const char c : text) {
    if (c == '(') deepest = std::max(deepest, ++depth);
    if (c == ')') --depth;
  }
  return deepest;
}

}  // namespace

std::optional<Symbolic> read_expression(std::string_view text, CommentStyle style) {
  std::string plain(text);
  if (style == CommentStyle::hash) plain = with_sign_of_choice(std::move(plain));
  if (deepest_parentheses_in(plain) > deepest_parentheses) return std::nullopt;
  drop_unary_plus(plain);
  try {
    const Symbolic formula = read_program(plain);
    return formula.depth() > deepest_expression ? std::nullopt : std::optional(formula);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace shadefit::lint
