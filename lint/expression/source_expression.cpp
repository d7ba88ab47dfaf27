#include "lint/expression/source_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "fit/formula/parse_formula.hpp"
#include "fit/formula/shader_calls.hpp"
#include "lint/expression/calls.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// " * " for mul; empty for words other than add, sub, mul and div.
std::string_view operator_of(std::string_view word) {
  if (word == "mul") return " * ";
  if (word == "add") return " + ";
  if (word == "sub") return " - ";
  return word == "div" ? " / " : "";
}

/// Rewrites a program's expression in the notation of formulas.
class Rewriter {
 public:
  explicit Rewriter(std::string text) : text_(std::move(text)) {}

  /// The expression, which has no comments, as a formula of v0, v1 and so on. Empty if it has operations
  /// other than those of scalars.
  std::optional<std::string> rewrite() {
    while (at_ < text_.size()) {
      if (out_.size() > longest_formula) return std::nullopt;
      const char c = text_[at_];
      if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        if (!number()) return std::nullopt;
      } else if (is_of_name(c)) {
        if (!word()) return std::nullopt;
      } else if (c == '.') {
        if (!method()) return std::nullopt;
      } else if (c == '+' && is_unary_plus()) {
        ++at_;
      } else {
        if (!is_one_of(c, "+-*/(),?:<>=!&| \t\r\n")) return std::nullopt;
        out_ += c;
        ++at_;
      }
    }
    return out_;
  }

  /// What v0, v1 and so on stand for in the program.
  const std::vector<std::string>& names() const { return names_; }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void blanks() { at_ = end_of_run(text_, at_, is_blank); }

  /// The last character of the output that is no blank; '(' if there is none.
  char last() const {
    const std::size_t end = begin_of_run(out_, out_.size(), is_blank);
    return end == 0 ? '(' : out_[end - 1];
  }

  /// A sign that changes nothing, as in "return + a * x"; not that of "++i".
  bool is_unary_plus() const { return peek(1) != '+' && is_one_of(last(), "+-*/^(,?:<>=&|"); }

  /// A decimal number without its suffix and separators.
  bool number() {
    const Notation number = parts_of_number(std::string_view(text_).substr(at_));
    if (number.suffix.starts_with('x') || number.suffix.starts_with('X')) return false;
    const std::size_t end = at_ + number.length - number.suffix.size();
    for (std::size_t i = at_; i < end; ++i)
      if (!is_one_of(text_[i], "_'")) out_ += text_[i];
    at_ += number.length;
    return true;
  }

  std::string take_word() {
    const std::size_t first = at_;
    at_ = end_of_run(text_, at_, is_of_name);
    return text_.substr(first, at_ - first);
  }

  /// After an opening parenthesis: the text up to the closing one. Empty without one.
  std::optional<std::string> group(char open, char close) {
    std::size_t depth = 0;
    const std::size_t first = at_;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == open) ++depth;
      if (text_[at_] == close && --depth == 0) {
        ++at_;
        return text_.substr(first + 1, at_ - first - 2);
      }
    }
    return std::nullopt;
  }

  /// The components of a vector, if they are all the same: vec3(0.055, 0.055, 0.055).
  static std::optional<std::string> only_component(std::string_view group) {
    const std::vector<std::string_view> components = arguments_in(group);
    const bool is_one =
        std::ranges::all_of(components, [&](std::string_view one) { return one == components.front(); });
    return is_one ? std::optional(std::string(components.front())) : std::nullopt;
  }

  void name(const std::string& text) {
    const auto found = std::ranges::find(names_, text);
    out_ += "v" + std::to_string(found - names_.begin());
    if (found == names_.end()) names_.push_back(text);
  }

  /// A name with its members, elements and qualifiers; a function; or a constructor.
  bool word() {
    std::string path = take_word();
    while (true) {
      if (peek(0) == ':' && peek(1) == ':' && is_of_name(peek(2))) {
        at_ += 2;
        path = take_word();  // a namespace has no meaning here
      } else if (peek(0) == '-' && peek(1) == '>' && is_of_name(peek(2))) {
        at_ += 2;
        path += "." + take_word();
      } else if (peek(0) == '.' && is_of_name(peek(1)) && (is_module(path) || !is_method())) {
        ++at_;
        const std::string member = take_word();
        path = is_module(path) ? member : path + "." + member;
      } else if (peek(0) == '[') {
        const auto inside = group('[', ']');
        if (!inside) return false;
        path += "[" + *inside + "]";
      } else {
        break;
      }
    }
    if (is_number_type(path) && peek(0) == '<') at_ = std::min(text_.find('>', at_), text_.size() - 1) + 1;
    const std::size_t behind = at_;
    blanks();
    if (peek(0) == '(') return call(path);
    at_ = behind;
    if (const auto multiple = pi_in(path))
      out_ += *multiple;
    else
      name(path);
    return true;
  }

  /// Prefixes of functions that have no meaning here: Math.pow, np.exp, System.MathF.Pow.
  static bool is_module(std::string_view path) {
    constexpr std::array<std::string_view, 11> modules{"Math",  "MathF", "Mathf", "StrictMath", "math", "np",
                                                       "numpy", "jnp",   "torch", "tf",         "dr"};
    const std::string_view last = path.substr(path.rfind('.') + 1);
    return std::ranges::find(modules, last) != modules.end();
  }

  bool call(const std::string& path) {
    const std::size_t open = at_;
    if (is_number_type(path)) {
      const auto inside = group('(', ')');
      if (!inside) return false;
      const auto component = only_component(*inside);
      if (!component) return false;
      text_.replace(open + 1, inside->size(), *component);
      at_ = open;  // the parentheses stay
      return true;
    }
    const std::string function = usual_name(path);
    if (!argument_counts(function).empty()) {
      out_ += function;
      return true;
    }
    const auto inside = group('(', ')');
    if (!inside) return false;
    if (const auto formula = function == "dot" ? dot_product(*inside) : std::nullopt) {
      text_.replace(open + 1, inside->size(), *formula);
      at_ = open;  // the parentheses stay
    } else {
      name(path + "(" + *inside + ")");
    }
    return true;
  }

  /// Whether a member that begins here is a method of the number before it: x.powf(2.4).
  bool is_method() const {
    const std::string_view rest = std::string_view(text_).substr(at_ + 1);
    constexpr std::array<std::string_view, 14> methods{"powf(",  "powi(",  "pow(", "sqrt()", "exp()",
                                                       "exp2()", "log2()", "ln()", "abs()",  "mul_add(",
                                                       "mul(",   "add(",   "sub(", "div("};
    return std::ranges::any_of(methods, [&](std::string_view method) { return rest.starts_with(method); });
  }

  /// x.powf(2.4) and (..).powf(2.4) become pow(x, 2.4).
  bool method() {
    if (!is_method()) return swizzle();
    ++at_;
    std::string function = take_word();
    if (function == "ln") function = "log";
    if (function == "powi" || function == "powf") function = "pow";
    if (function == "mul_add") function = "fma";
    const std::size_t begin = receiver(), open = at_;
    const auto inside = group('(', ')');
    if (!inside || begin == out_.size()) return false;
    const std::string number = out_.substr(begin);
    out_.resize(begin);
    // x.mul(2) of three.js and of matrix libraries is x * (2).
    if (const std::string_view sign = operator_of(function); !sign.empty()) {
      out_ += "(" + number + std::string(sign);
      text_.insert(at_, ")");
      at_ = open;  // the parentheses stay
    } else {
      out_ += function + "(" + number + (inside->empty() ? "" : ", ");
      at_ = open + 1;  // the arguments follow, with the closing parenthesis
    }
    return true;
  }

  /// Where the operand at the end of the output begins.
  std::size_t receiver() const {
    std::size_t begin = begin_of_run(out_, out_.size(), [](char c) { return c == ' '; });
    if (begin > 0 && out_[begin - 1] == ')') {
      int depth = 0;
      while (begin > 0) {
        --begin;
        if (out_[begin] == ')') ++depth;
        if (out_[begin] == '(' && --depth == 0) break;
      }
    }
    return begin_of_run(out_, begin, [](char c) { return is_of_name(c) || c == '.'; });
  }

  /// Drops the components of a group: (..).xyz.
  bool swizzle() {
    ++at_;
    const std::string components = take_word();
    return !components.empty() && components.size() <= 4 &&
           components.find_first_not_of("xyzwrgba") == std::string::npos;
  }

  std::string text_, out_;
  std::size_t at_ = 0;
  std::vector<std::string> names_;
};

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
  Rewriter source(std::move(plain));
  const auto rewritten = source.rewrite();
  if (!rewritten || deepest_parentheses_in(*rewritten) > deepest_parentheses) return std::nullopt;
  FormulaNames names;
  for (std::size_t i = 0; i < source.names().size(); ++i) names.variables.push_back("v" + std::to_string(i));
  try {
    const Symbolic formula = read_formula(*rewritten, names).formula;
    if (formula.depth() > deepest_expression) return std::nullopt;
    return evaluate<Symbolic>(formula, [&](const std::string& name) {
      return Symbolic::variable(source.names()[std::stoul(name.substr(1))]);
    });
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace shadefit::lint
