#include "fit/scalars/parse_formula.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace shadefit {
namespace {

constexpr std::array functions_of_one{"exp",  "exp2", "log", "log2", "expm1", "log1p", "log1p_remainder",
                                      "erfc", "sqrt", "sin", "cos",  "atan"};
constexpr std::array functions_of_two{"min", "max"};

/// Deeper nesting than any formula has; a bound on the recursion of the reader.
constexpr int deepest = 100;

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

bool begins_name(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}

bool begins_atom(char c) {
  return is_digit(c) || begins_name(c) || c == '(';
}

template <std::size_t N>
bool is_among(const std::array<const char*, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Recursive descent: one function for each rule of the grammar.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, std::span<const std::string_view> variables)
      : text_(text), variables_(variables) {}

  Symbolic whole() {
    const Symbolic result = limited(sum());
    if (peek(); place_ < text_.size()) fail("an operator or the end");
    return result;
  }

 private:
  Symbolic sum() {
    if (++depth_ > deepest) fail("no more than " + std::to_string(deepest) + " nested parentheses");
    Symbolic result = skip('-') ? -quotient() : quotient();
    for (;;) {
      if (skip('+')) {
        result = limited(result + quotient());
      } else if (skip('-')) {
        result = limited(result - quotient());
      } else {
        --depth_;
        return result;
      }
    }
  }

  /// A formula is not deeper than the limit, and a refused one not deeper than twice the limit.
  Symbolic limited(const Symbolic& result) const {
    if (result.depth() > deepest_formula)
      fail("no more than " + std::to_string(deepest_formula) + " operations inside one another");
    return result;
  }

  Symbolic quotient() {
    const Symbolic numerator = product();
    if (!skip('/')) return numerator;
    const Symbolic denominator = raised();
    if (peek() == '*' || peek() == '/' || begins_atom(peek()))
      fail("parentheses around the quotient or its denominator");
    return numerator / denominator;
  }

  Symbolic product() {
    Symbolic result = raised();
    for (;;) {
      if (skip('*')) {
        result = limited(result * raised());
      } else if (is_digit(peek())) {
        fail("a '*' before the number");
      } else if (begins_atom(peek())) {
        result = limited(result * raised());
      } else {
        return result;
      }
    }
  }

  Symbolic raised() {
    const Symbolic base = atom();
    if (!skip('^')) return base;
    const bool is_negative = skip('-');
    if (is_negative && !is_digit(peek())) fail("a number, or parentheses around the exponent");
    const std::size_t start = place_;
    const Symbolic exponent = atom();
    if (peek() == '^') fail("parentheses around one of the powers");
    if (exponent.kind() == Symbolic::Kind::number) {
      if (const auto n = whole_number(exponent.name(), start)) return power(base, is_negative ? -*n : *n);
    }
    return power(base, is_negative ? -exponent : exponent);
  }

  Symbolic atom() {
    if (is_digit(peek())) return number();
    if (begins_name(peek())) return named();
    if (!skip('(')) fail("a number, a name or '('");
    const Symbolic inner = sum();
    if (!skip('<')) {
      expect(')');
      return inner;
    }
    const Symbolic limit = sum();
    expect('?');
    const Symbolic yes = sum();
    expect(':');
    const Symbolic no = sum();
    expect(')');
    return select(less(inner, limit), yes, no);
  }

  Symbolic number() {
    const std::size_t start = place_;
    const auto digits = [&] {
      while (place_ < text_.size() && is_digit(text_[place_])) ++place_;
    };
    digits();
    if (at(place_) == '.') {
      ++place_;
      if (!is_digit(at(place_))) fail("a digit");
      digits();
    }
    const std::size_t sign = at(place_ + 1) == '+' || at(place_ + 1) == '-' ? 1 : 0;
    if ((at(place_) == 'e' || at(place_) == 'E') && is_digit(at(place_ + 1 + sign))) {
      place_ += 1 + sign;
      digits();
    }
    const std::string_view decimal = text_.substr(start, place_ - start);
    double value = 0;
    if (std::from_chars(decimal.data(), decimal.data() + decimal.size(), value).ec != std::errc{})
      fail("a number within the range of a double", start);
    return Symbolic::number(decimal);
  }

  Symbolic named() {
    const std::size_t start = place_;
    while (begins_name(at(place_)) || is_digit(at(place_))) ++place_;
    const std::string_view name = text_.substr(start, place_ - start);
    if (std::find(variables_.begin(), variables_.end(), name) != variables_.end())
      return Symbolic::variable(name);
    if (name == "pi" || name == "ln2") return Symbolic::constant(name);
    const std::size_t count = is_among(functions_of_one, name) ? 1 : is_among(functions_of_two, name) ? 2 : 0;
    if (count == 0) fail("one of " + known_names() + ", not '" + std::string(name) + "'", start);
    expect('(');
    std::vector<Symbolic> arguments{sum()};
    while (arguments.size() < count) {
      expect(',');
      arguments.push_back(sum());
    }
    expect(')');
    return Symbolic::function(name, std::move(arguments));
  }

  /// The number as an int, if it is written as one.
  std::optional<int> whole_number(std::string_view decimal, std::size_t start) {
    if (!std::all_of(decimal.begin(), decimal.end(), is_digit)) return std::nullopt;
    int n = 0;
    if (std::from_chars(decimal.data(), decimal.data() + decimal.size(), n).ec != std::errc{})
      fail("a smaller whole exponent", start);
    return n;
  }

  std::string known_names() const {
    std::string names;
    for (const std::string_view name : variables_) names += std::string(name) + ", ";
    return names + "pi, ln2 and the functions";
  }

  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  /// Moves `place_` to the next letter that is not a space, and returns it; '\0' at the end.
  char peek() {
    while (at(place_) == ' ') ++place_;
    return at(place_);
  }

  bool skip(char c) {
    if (peek() != c) return false;
    ++place_;
    return true;
  }

  void expect(char c) {
    if (!skip(c)) fail(std::string("'") + c + "'");
  }

  [[noreturn]] void fail(const std::string& expected, std::optional<std::size_t> where = {}) const {
    throw std::invalid_argument("formula '" + std::string(text_) + "': expected " + expected + " at place " +
                                std::to_string(where.value_or(place_) + 1));
  }

  std::string_view text_;
  std::span<const std::string_view> variables_;
  std::size_t place_ = 0;
  int depth_ = 0;
};

}  // namespace

Symbolic parse_formula(std::string_view text, std::span<const std::string_view> variables) {
  if (text.size() > longest_formula)
    throw std::invalid_argument("the formula is " + std::to_string(text.size()) +
                                " characters long: at most " + std::to_string(longest_formula));
  return FormulaReader(text, variables).whole();
}

}  // namespace shadefit
