#include "lint/expression/rewriter.hpp"

#include <algorithm>
#include <array>

#include "fit/formula/parse_formula.hpp"
#include "fit/formula/shader_calls.hpp"
#include "lint/expression/calls.hpp"
#include "lint/expression/usual_names.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/literals.hpp"

namespace shadefit::lint {
namespace {

/// Rewrites a program's expression in the notation of formulas.
class Rewriter {
 public:
  explicit Rewriter(std::string text) : text_(std::move(text)) {}

  /// Empty if it cannot be rewritten.
  std::optional<std::string> rewrite() {
    while (at_ < text_.size()) {
      if (out_.size() > longest_formula) return std::nullopt;
      const char c = text_[at_];
      if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        number();
      } else if (is_of_name(c)) {
        if (!word()) return std::nullopt;
      } else if (c == '*' && peek(1) == '*') {
        out_ += '^';
        at_ += 2;
        blanks();
        if (peek(0) == '-') sign();
      } else if (c == '.') {
        if (!method()) return std::nullopt;
      } else if (c == '-' && is_behind_operator()) {
        negation();
      } else if (c == '+' && is_unary_plus()) {
        ++at_;
      } else {
        if (std::string_view("+-*/(),?:<>=!&| \t\r\n").find(c) == std::string_view::npos) return std::nullopt;
        out_ += c;
        ++at_;
      }
    }
    return out_;
  }

  std::vector<std::string> names() const { return names_; }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void blanks() {
    while (is_blank(peek(0))) ++at_;
  }

  bool is_behind_operator() const {
    const std::size_t last = out_.find_last_not_of(" \t\r\n");
    return last != std::string::npos && std::string_view("+-*/").find(out_[last]) != std::string_view::npos;
  }

  /// A sign that changes nothing, as in "return + a * x"; not that of "++i".
  bool is_unary_plus() const {
    const std::size_t last = out_.find_last_not_of(" \t\r\n");
    return peek(1) != '+' && (last == std::string::npos ||
                              std::string_view("+-*/^(,?:<>=&|").find(out_[last]) != std::string_view::npos);
  }

  /// Programs write a + -2 * b and a / -b; formulas need a + (-2) * b and a / (-1) / b.
  void negation() {
    const char last = out_[out_.find_last_not_of(" \t\r\n")];
    ++at_;
    blanks();
    if (is_digit(peek(0)) || peek(0) == '.') {
      out_ += "(-";
      number();
      out_ += ')';
    } else {
      out_ += last == '/' ? "(-1) / " : "(-1) * ";
    }
  }

  /// The sign of an exponent is directly before it.
  void sign() {
    out_ += '-';
    ++at_;
    blanks();
  }

  /// A number without its suffix and separators.
  void number() {
    const std::size_t first = at_;
    const auto is_sign_of_exponent = [&] {
      const char last = at_ > first ? text_[at_ - 1] : ' ';
      return (peek(0) == '-' || peek(0) == '+') && (last == 'e' || last == 'E') && is_digit(peek(1));
    };
    const auto is_part = [&] {
      const bool has_member = is_letter(peek(1)) && peek(1) != 'f';
      return is_of_name(peek(0)) || (peek(0) == '.' && !has_member) || is_sign_of_exponent();
    };
    while (is_part()) ++at_;
    out_ += plain(digits_of(std::string_view(text_).substr(first, at_ - first)));
  }

  static std::string plain(const Digits& digits) {
    if (digits.text.empty()) return "0";
    constexpr int most_zeros = 20;
    const auto count = static_cast<int>(digits.text.size());
    if (digits.exponent < -most_zeros || digits.exponent > most_zeros)
      return "0." + digits.text + "e" + std::to_string(digits.exponent);
    if (digits.exponent <= 0)
      return "0." + std::string(static_cast<std::size_t>(-digits.exponent), '0') + digits.text;
    if (digits.exponent >= count)
      return digits.text + std::string(static_cast<std::size_t>(digits.exponent - count), '0');
    const auto whole = static_cast<std::size_t>(digits.exponent);
    return digits.text.substr(0, whole) + "." + digits.text.substr(whole);
  }

  std::string take_word() {
    const std::size_t first = at_;
    while (is_of_name(peek(0))) ++at_;
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
    const bool is_one = std::all_of(components.begin(), components.end(),
                                    [&](std::string_view one) { return one == components.front(); });
    return is_one ? std::optional(std::string(components.front())) : std::nullopt;
  }

  void name(const std::string& text) {
    const auto found = std::find(names_.begin(), names_.end(), text);
    if (found == names_.end()) {
      names_.push_back(text);
      out_ += "v" + std::to_string(names_.size() - 1);
    } else {
      out_ += "v" + std::to_string(found - names_.begin());
    }
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
    return constant(path);
  }

  /// Prefixes of functions that have no meaning here: Math.pow, np.exp, System.MathF.Pow.
  static bool is_module(std::string_view path) {
    constexpr std::array<std::string_view, 11> modules{"Math",  "MathF", "Mathf", "StrictMath", "math", "np",
                                                       "numpy", "jnp",   "torch", "tf",         "dr"};
    const std::string_view last = path.substr(path.rfind('.') + 1);
    return std::find(modules.begin(), modules.end(), last) != modules.end();
  }

  /// Whether a member that begins here is a method of the number before it: x.powf(2.4).
  bool is_method() const {
    const std::string_view rest = std::string_view(text_).substr(at_ + 1);
    constexpr std::array<std::string_view, 14> methods{"powf(",  "powi(",  "pow(", "sqrt()", "exp()",
                                                       "exp2()", "log2()", "ln()", "abs()",  "mul_add(",
                                                       "mul(",   "add(",   "sub(", "div("};
    return std::any_of(methods.begin(), methods.end(),
                       [&](std::string_view method) { return rest.starts_with(method); });
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
    if (const auto formula = call_as_formula(path, *inside)) {
      text_.replace(open + 1, inside->size(), *formula);
      at_ = open;  // the parentheses stay
    } else {
      name(path + "(" + *inside + ")");
    }
    return true;
  }

  bool constant(const std::string& path) {
    if (const auto multiple = pi_in(path))
      out_ += *multiple;
    else
      name(path);
    return true;
  }

  /// x.powf(2.4) and (..).powf(2.4) become pow(x, 2.4).
  bool method() {
    if (!is_method()) return swizzle();
    ++at_;
    std::string function = take_word();
    if (function == "ln") function = "log";
    if (function == "powi" || function == "powf") function = "pow";
    if (function == "mul_add") function = "fma";
    const auto inside = group('(', ')');
    if (!inside) return false;
    const std::size_t begin = receiver();
    if (begin == out_.size()) return false;
    Rewriter arguments(*inside);
    arguments.names_ = names_;
    const auto rest = arguments.rewrite();
    if (!rest) return false;
    names_ = arguments.names_;
    const std::string number = out_.substr(begin);
    const std::string sign = operator_of(function);
    const std::string call = sign.empty()
                                 ? function + "(" + number + (rest->empty() ? "" : ", " + *rest) + ")"
                                 : "(" + number + sign + "(" + *rest + "))";
    out_.replace(begin, std::string::npos, call);
    return true;
  }

  /// x.mul(2) of three.js and of matrix libraries is x * (2).
  static std::string operator_of(std::string_view function) {
    if (function == "mul") return " * ";
    if (function == "add") return " + ";
    if (function == "sub") return " - ";
    return function == "div" ? " / " : "";
  }

  /// Where the operand at the end of the output begins.
  std::size_t receiver() const {
    std::size_t begin = out_.size();
    while (begin > 0 && out_[begin - 1] == ' ') --begin;
    if (begin > 0 && out_[begin - 1] == ')') {
      int depth = 0;
      while (begin > 0) {
        --begin;
        if (out_[begin] == ')') ++depth;
        if (out_[begin] == '(' && --depth == 0) break;
      }
    }
    while (begin > 0 && (is_of_name(out_[begin - 1]) || out_[begin - 1] == '.')) --begin;
    return begin;
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

}  // namespace

std::optional<Rewritten> in_formula_notation(std::string_view text) {
  Rewriter rewriter{std::string(text)};
  const auto formula = rewriter.rewrite();
  if (!formula) return std::nullopt;
  return Rewritten{*formula, rewriter.names()};
}

}  // namespace shadefit::lint
