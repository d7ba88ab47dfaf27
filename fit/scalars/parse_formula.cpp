#include "fit/scalars/parse_formula.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "fit/scalars/integral.hpp"
#include "fit/scalars/shader_calls.hpp"
#include "fit/support/nearest.hpp"
#include "fit/truths/truths.hpp"

namespace shadefit {
namespace {

/// Deeper nesting than any formula has; a bound on the recursion of the reader.
constexpr int deepest = 100;

/// The most operations of a formula with its definitions put in. Definitions that use each other double it
/// with each line.
constexpr std::size_t most_operations = 100'000;

/// The size of what stands for a name.
using SizeOfName = std::function<std::size_t(const std::string&)>;

/// How many operations, names and numbers a formula has; counted only as far as `most_operations`.
std::size_t size_of(
    const Symbolic& formula, const SizeOfName& size_of_name = [](const std::string&) { return 1; },
    std::size_t before = 0) {
  if (formula.kind() == Symbolic::Kind::variable) return before + size_of_name(formula.name());
  if (formula.kind() == Symbolic::Kind::integral) {
    const std::size_t body = size_of(formula.part(0), size_of_name);
    return size_of(formula.part(2), size_of_name,
                   size_of(formula.part(1), size_of_name, before + integral_nodes * body));
  }
  std::size_t size = before + 1;
  for (const Symbolic& part : formula.parts()) {
    if (size > most_operations) break;
    size = size_of(part, size_of_name, size);
  }
  return size;
}

/// A condition is known by what it chooses: its first argument where it holds, else its second.
using Condition = std::function<Symbolic(const Symbolic&, const Symbolic&)>;
using Operand = std::variant<Symbolic, Condition>;

Condition is_less(const Symbolic& a, const Symbolic& b) {
  return [=](const Symbolic& yes, const Symbolic& no) { return select(less(a, b), yes, no); };
}
Condition negated(const Condition& p) {
  return [=](const Symbolic& yes, const Symbolic& no) { return p(no, yes); };
}
Condition both(const Condition& p, const Condition& q) {
  return [=](const Symbolic& yes, const Symbolic& no) { return p(q(yes, no), no); };
}

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

bool begins_name(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}

std::string counted(const std::vector<std::size_t>& counts) {
  std::string text;
  for (const std::size_t n : counts) text += (text.empty() ? "" : " or ") + std::to_string(n);
  return text + (counts == std::vector<std::size_t>{1} ? " argument" : " arguments");
}

/// Recursive descent: one function for each rule of the grammar.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const FormulaNames& names) : text_(text), names_(names) {}

  ReadFormula whole() {
    const Symbolic result = limited(formula());
    if (peek(); place_ < text_.size()) fail("an operator or the end");
    require_size(size_of(result));
    return {result, parameters_};
  }

 private:
  Symbolic formula() {
    const std::size_t start = place_;
    return number_of(any_formula(), start);
  }

  Operand any_formula() {
    if (++depth_ > deepest) fail("no more than " + std::to_string(deepest) + " nested parentheses");
    const std::size_t start = place_;
    Operand result = disjunction();
    if (skip('?')) {
      const Condition condition = condition_of(result, start);
      const Symbolic yes = formula();
      expect(':');
      result = limited(condition(yes, formula()));
    }
    --depth_;
    return result;
  }

  Operand disjunction() {
    const std::size_t start = place_;
    Operand result = conjunction();
    while (skip("||")) {
      const Condition left = condition_of(result, start);
      const std::size_t next = place_;
      result = negated(both(negated(left), negated(condition_of(conjunction(), next))));
    }
    return result;
  }

  Operand conjunction() {
    const std::size_t start = place_;
    Operand result = comparison();
    while (skip("&&")) {
      const Condition left = condition_of(result, start);
      const std::size_t next = place_;
      result = both(left, condition_of(comparison(), next));
    }
    return result;
  }

  Operand comparison() {
    const std::size_t start = place_;
    if (peek() == '!' && at(place_ + 1) != '=') {
      if (++depth_ > deepest) fail("no more than " + std::to_string(deepest) + " signs of negation");
      skip('!');
      const std::size_t next = place_;
      const Condition inner = condition_of(comparison(), next);
      --depth_;
      return negated(inner);
    }
    Operand left = sum();
    for (const std::string_view sign : {"<=", ">=", "==", "!=", "<", ">"}) {
      if (!skip(sign)) continue;
      const std::size_t next = place_;
      const Symbolic a = number_of(left, start), b = number_of(sum(), next);
      if (sign == "<") return is_less(a, b);
      if (sign == ">") return is_less(b, a);
      if (sign == "<=") return negated(is_less(b, a));
      if (sign == ">=") return negated(is_less(a, b));
      const Condition equal = both(negated(is_less(a, b)), negated(is_less(b, a)));
      return sign == "==" ? equal : negated(equal);
    }
    return left;
  }

  Operand sum() {
    const std::size_t start = place_;
    Operand first = skip_minus() ? Operand(-number_of(quotient(), start)) : quotient();
    for (;;) {
      const bool adds = peek() == '+';
      if (!adds && peek() != '-') return first;
      ++place_;
      const Symbolic left = number_of(first, start);
      const std::size_t next = place_;
      const bool is_signed = skip_minus();
      const Symbolic term = number_of(quotient(), next);
      const Symbolic right = is_signed ? -term : term;
      first = limited(adds ? left + right : left - right);
    }
  }

  /// A formula is not deeper than the limit, and a refused one not deeper than twice the limit.
  Symbolic limited(const Symbolic& result) const {
    if (result.depth() > deepest_formula)
      fail("no more than " + std::to_string(deepest_formula) + " operations inside one another");
    return result;
  }

  void require_size(std::size_t size) const {
    if (size > most_operations)
      fail("no more than " + std::to_string(most_operations) + " operations with all definitions put in");
  }

  Operand quotient() {
    const std::size_t start = place_;
    Operand result = product();
    while (peek() == '/' || peek() == '*') {
      const Symbolic left = number_of(result, start);
      const bool divides = peek() == '/';
      ++place_;
      if (!divides && at(place_) == '*') fail("'^' for a power, not '**'", place_ - 1);
      const Symbolic right = factor();
      if (divides && begins_atom()) fail("parentheses around the quotient or its denominator");
      result = limited(divides ? left / right : beside(left * right));
    }
    return result;
  }

  /// Powers side by side.
  Operand product() {
    const std::size_t start = place_;
    Operand first = raised_atom();
    return begins_atom() ? Operand(beside(number_of(first, start))) : first;
  }

  Symbolic beside(Symbolic result) {
    while (begins_atom()) {
      if (is_digit(peek()) || peek() == '.') fail("a '*' before the number");
      const std::size_t start = place_;
      result = limited(result * number_of(raised_atom(), start));
    }
    return result;
  }

  /// After an operator a sign may stand before a power.
  Symbolic factor() {
    const bool is_signed = skip_minus();
    const std::size_t start = place_;
    const Symbolic value = number_of(raised_atom(), start);
    return is_signed ? -value : value;
  }

  Operand raised_atom() {
    const std::size_t start = place_;
    const Operand atom_ = atom();
    if (!skip('^')) return atom_;
    const Symbolic base = number_of(atom_, start);
    const bool is_negative = skip('-');
    if (is_negative && !is_digit(peek())) fail("a number, or parentheses around the exponent");
    const std::size_t next = place_;
    const Symbolic exponent = number_of(atom(), next);
    if (peek() == '^') fail("parentheses around one of the powers");
    const bool is_whole = exponent.kind() == Symbolic::Kind::number &&
                          std::all_of(exponent.name().begin(), exponent.name().end(), is_digit);
    const Symbolic result = raised(base, is_negative ? -exponent : exponent);
    if (is_whole && result.kind() != Symbolic::Kind::integer_power) fail("a smaller whole exponent", next);
    return result;
  }

  Operand atom() {
    if (begins_number()) return number();
    if (begins_name(peek())) return named();
    if (!skip('(')) fail("a number, a name or '('");
    Operand inner = any_formula();
    expect(')');
    return inner;
  }

  /// The decimal text is kept, with a digit on both sides of its point. The suffix of a float or a half is
  /// left out.
  Symbolic number() {
    const std::size_t start = place_;
    const auto digits = [&] {
      const std::size_t first = place_;
      while (is_digit(at(place_))) ++place_;
      return text_.substr(first, place_ - first);
    };
    std::string decimal(digits());
    bool is_float = false;
    if (decimal.empty()) decimal = "0";
    if (at(place_) == '.') {
      ++place_;
      is_float = true;
      const std::string_view fraction = digits();
      if (!fraction.empty()) decimal += "." + std::string(fraction);
    }
    const std::size_t sign = at(place_ + 1) == '+' || at(place_ + 1) == '-' ? 1 : 0;
    if ((at(place_) == 'e' || at(place_) == 'E') && is_digit(at(place_ + 1 + sign))) {
      decimal += text_.substr(place_, 1 + sign);
      place_ += 1 + sign;
      decimal += digits();
      is_float = true;
    }
    if (at(place_) == '.') fail("a number with one point", start);
    double value = 0;
    if (std::from_chars(decimal.data(), decimal.data() + decimal.size(), value).ec != std::errc{})
      fail("a number within the range of a double", start);
    const char suffix = at(place_);
    const char next = at(place_ + 1);
    const bool has_suffix = (suffix == 'f' || suffix == 'F' || suffix == 'h' || suffix == 'H') &&
                            !begins_name(next) && !is_digit(next) && next != '(';
    if (has_suffix && !is_float)
      fail("a point before the suffix, " + decimal + ".0" + suffix + ", or a '*'", start);
    if (has_suffix) ++place_;
    return Symbolic::number(decimal);
  }

  Symbolic named() {
    const std::size_t start = place_;
    while (begins_name(at(place_)) || is_digit(at(place_))) ++place_;
    const std::string_view name = text_.substr(start, place_ - start);
    const bool is_before_parenthesis = at(place_) == '(';
    if (std::find(names_.variables.begin(), names_.variables.end(), name) != names_.variables.end())
      return Symbolic::variable(name);
    if (const auto found = names_.definitions.find(name); found != names_.definitions.end())
      return use(found->first, found->second);
    if (name == "pi" || name == "ln2") return Symbolic::constant(name);
    if (name == "PI" || name == "M_PI") return Symbolic::constant("pi");
    if (const auto counts = argument_counts(name); !counts.empty()) {
      const std::vector<Symbolic> given = arguments();
      if (std::find(counts.begin(), counts.end(), given.size()) == counts.end())
        fail(counted(counts) + " of '" + std::string(name) + "'", start);
      return call(name, given);
    }
    if (name == "integral" && is_before_parenthesis && names_.takes_integrals) return integral_of(start);
    if (const Truth* truth = find_truth(name); truth && is_before_parenthesis && names_.takes_integrals)
      return use(std::string(name), definition_of(*truth));
    if (std::find(bound_.begin(), bound_.end(), name) != bound_.end()) return Symbolic::variable(name);
    if (std::find(past_.begin(), past_.end(), name) != past_.end())
      fail("'" + std::string(name) + "' inside its integral alone", start);
    if (names_.takes_parameters && !(is_before_parenthesis && name.size() > 1)) {
      if (std::find(parameters_.begin(), parameters_.end(), name) == parameters_.end())
        parameters_.emplace_back(name);
      return Symbolic::variable(name);
    }
    refuse(name, start);
  }

  /// integral(body, t, lower, upper). The variable is read first, since the body uses it.
  Symbolic integral_of(std::size_t start) {
    constexpr std::size_t most_inside = 2;
    expect('(');
    const std::size_t body_start = place_;
    place_ = end_of_argument();
    expect(',');
    const std::string variable = new_name();
    const std::size_t rest = place_;
    if (bound_.size() == most_inside) fail("no more than two integrals inside one another", start);
    place_ = body_start;
    bound_.push_back(variable);
    const Symbolic body = formula();
    bound_.pop_back();
    past_.push_back(variable);
    expect(',');
    place_ = rest;
    expect(',');
    const Symbolic lower = formula();
    expect(',');
    const Symbolic upper = formula();
    expect(')');
    return limited(integral(body, variable, lower, upper));
  }

  /// The place of the comma or parenthesis that ends an argument.
  std::size_t end_of_argument() const {
    std::size_t end = place_;
    for (int open = 0; end < text_.size(); ++end) {
      if (text_[end] == '(') ++open;
      if (text_[end] == ')' && --open < 0) break;
      if (text_[end] == ',' && open == 0) break;
    }
    return end;
  }

  /// A name that nothing else has.
  std::string new_name() {
    peek();
    const std::size_t start = place_;
    while (begins_name(at(place_)) || (place_ > start && is_digit(at(place_)))) ++place_;
    const std::string name(text_.substr(start, place_ - start));
    const auto has = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    const bool is_taken = has(names_.variables) || has(parameters_) || has(bound_) ||
                          names_.definitions.contains(name) || !argument_counts(name).empty() ||
                          has({"pi", "ln2", "PI", "M_PI", "integral"});
    if (name.empty() || is_taken) fail("a new name for the variable of the integral", start);
    return name;
  }

  static Definition definition_of(const Truth& truth) {
    if (truth.formula.empty()) {
      std::vector<Symbolic> arguments;
      for (const std::string& argument : truth.arguments) arguments.push_back(Symbolic::variable(argument));
      return {truth.arguments, Symbolic::function(truth.name, arguments)};
    }
    const FormulaNames names{.variables = truth.arguments, .takes_integrals = true};
    return {truth.arguments, FormulaReader(truth.formula, names).whole().formula};
  }

  /// A definition with its arguments put in.
  Symbolic use(const std::string& name, const Definition& definition) {
    const std::size_t start = place_;
    if (definition.arguments.empty()) return definition.formula;
    const std::vector<Symbolic> given = arguments();
    if (given.size() != definition.arguments.size())
      fail(counted({definition.arguments.size()}) + " of '" + name + "'", start);
    const auto argument = [&](const std::string& variable) -> const Symbolic* {
      const auto& all = definition.arguments;
      const auto found = std::find(all.begin(), all.end(), variable);
      return found == all.end() ? nullptr : &given[static_cast<std::size_t>(found - all.begin())];
    };
    std::map<std::string, std::size_t> sizes;
    for (std::size_t i = 0; i < given.size(); ++i) sizes[definition.arguments[i]] = size_of(given[i]);
    require_size(size_of(definition.formula, [&](const std::string& variable) {
      const auto found = sizes.find(variable);
      return found == sizes.end() ? std::size_t{1} : found->second;
    }));
    return limited(evaluate<Symbolic>(definition.formula, [&](const std::string& variable) {
      const Symbolic* given_as = argument(variable);
      return given_as == nullptr ? Symbolic::variable(variable) : *given_as;
    }));
  }

  std::vector<Symbolic> arguments() {
    expect('(');
    std::vector<Symbolic> result{formula()};
    while (skip(',')) result.push_back(formula());
    expect(')');
    return result;
  }

  /// An unknown name: a function where others are parameters, else any.
  [[noreturn]] void refuse(std::string_view name, std::size_t start) const {
    std::vector<std::string> known = function_names();
    for (const auto& [defined, _] : names_.definitions) known.push_back(defined);
    for (const Truth& truth : truths()) {
      if (names_.takes_integrals) known.emplace_back(truth.name);
    }
    if (names_.takes_parameters) {
      const auto nearest = nearest_name(name, known);
      fail("a function before '(', not '" + std::string(name) + "'" +
               (nearest ? " (did you mean '" + *nearest + "'?)" : "; a product needs a '*' or a space"),
           start);
    }
    std::string names;
    for (const std::string& variable : names_.variables) names += variable + ", ";
    for (const auto& [defined, _] : names_.definitions) names += defined + ", ";
    const bool is_call = at(start + name.size()) == '(';
    const auto nearest = is_call ? nearest_name(name, known) : std::nullopt;
    fail("one of " + names + "pi, ln2 and the functions, not '" + std::string(name) + "'" +
             (nearest ? " (did you mean '" + *nearest + "'?)" : ""),
         start);
  }

  Symbolic number_of(const Operand& operand, std::size_t start) const {
    if (std::holds_alternative<Condition>(operand)) fail("a number, not a condition", start);
    return std::get<Symbolic>(operand);
  }

  Condition condition_of(const Operand& operand, std::size_t start) const {
    if (std::holds_alternative<Symbolic>(operand)) fail("a condition (such as a < b)", start);
    return std::get<Condition>(operand);
  }

  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  /// Moves `place_` to the next letter that is not a space, and returns it; '\0' at the end.
  char peek() {
    while (is_space(at(place_))) ++place_;
    return at(place_);
  }

  bool begins_number() { return is_digit(peek()) || (peek() == '.' && is_digit(at(place_ + 1))); }
  bool begins_atom() { return begins_number() || begins_name(peek()) || peek() == '('; }

  bool skip(char c) {
    if (peek() != c) return false;
    ++place_;
    return true;
  }

  bool skip(std::string_view word) {
    peek();
    if (text_.substr(place_, word.size()) != word) return false;
    place_ += word.size();
    return true;
  }

  /// A sign before a factor. In C two of them would be a decrement.
  bool skip_minus() {
    if (!skip('-')) return false;
    if (peek() == '-') fail("one sign only");
    return true;
  }

  void expect(char c) {
    if (!skip(c)) fail(std::string("'") + c + "'");
  }

  [[noreturn]] void fail(const std::string& expected, std::optional<std::size_t> where = {}) const {
    std::size_t place = where.value_or(place_);
    while (where && is_space(at(place))) ++place;
    throw std::invalid_argument("formula '" + std::string(text_) + "': expected " + expected + " at place " +
                                std::to_string(place + 1));
  }

  std::string_view text_;
  const FormulaNames& names_;
  std::vector<std::string> parameters_;
  std::vector<std::string> bound_;  ///< variables of the integrals around the place
  std::vector<std::string> past_;   ///< and of those before it
  std::size_t place_ = 0;
  int depth_ = 0;
};

}  // namespace

ReadFormula read_formula(std::string_view text, const FormulaNames& names) {
  if (text.size() > longest_formula)
    throw std::invalid_argument("the formula is " + std::to_string(text.size()) +
                                " characters long: at most " + std::to_string(longest_formula));
  return FormulaReader(text, names).whole();
}

Symbolic parse_formula(std::string_view text, std::span<const std::string_view> variables) {
  return read_formula(text, {.variables = {variables.begin(), variables.end()}}).formula;
}

}  // namespace shadefit
