#include "fit/formula/parse_formula.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <variant>

#include "fit/formula/formula_text.hpp"
#include "fit/formula/named_formulas.hpp"
#include "fit/formula/shader_calls.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/nearest.hpp"
#include "fit/truths/truths.hpp"

namespace shadefit {
namespace {

/// Deeper nesting than any formula has; a bound on the recursion of the reader.
constexpr int deepest = 100;

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

std::string counted(const std::vector<std::size_t>& counts) {
  std::string text;
  for (const std::size_t n : counts) text += (text.empty() ? "" : " or ") + std::to_string(n);
  return text + (counts == std::vector<std::size_t>{1} ? " argument" : " arguments");
}

bool has(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::string did_you_mean(const std::optional<std::string>& name) {
  return name ? " (did you mean '" + *name + "'?)" : "";
}

/// Recursive descent: one function for each rule of the grammar.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const FormulaNames& names) : text_(text), names_(names) {}

  ReadFormula whole() {
    if (const auto place = names_.program != nullptr ? std::nullopt : text_.statement())
      text_.fail("one expression, not statements (a definition, as of --let, can name a part)", place);
    const Symbolic result = limited(formula());
    if (names_.program == nullptr) text_.skip(';');
    if (!text_.is_at_end()) text_.fail("an operator or the end");
    require_size(size_of(result));
    return {result, parameters_};
  }

 private:
  Symbolic formula() {
    const std::size_t start = text_.place();
    return number_of(any_formula(), start);
  }

  Operand any_formula() {
    if (++depth_ > deepest) text_.fail("no more than " + std::to_string(deepest) + " nested parentheses");
    const std::size_t start = text_.place();
    Operand result = disjunction();
    if (text_.skip('?')) {
      const Condition condition = condition_of(result, start);
      const Symbolic yes = formula();
      text_.expect(':');
      result = limited(condition(yes, formula()));
    }
    --depth_;
    return result;
  }

  Operand disjunction() {
    const std::size_t start = text_.place();
    Operand result = conjunction();
    while (text_.skip("||")) {
      const Condition left = condition_of(result, start);
      const std::size_t next = text_.place();
      result = negated(both(negated(left), negated(condition_of(conjunction(), next))));
    }
    return result;
  }

  Operand conjunction() {
    const std::size_t start = text_.place();
    Operand result = comparison();
    while (text_.skip("&&")) {
      const Condition left = condition_of(result, start);
      const std::size_t next = text_.place();
      result = both(left, condition_of(comparison(), next));
    }
    return result;
  }

  Operand comparison() {
    const std::size_t start = text_.place();
    if (text_.peek() == '!' && text_.next(1) != '=') {
      if (++depth_ > deepest) text_.fail("no more than " + std::to_string(deepest) + " signs of negation");
      text_.skip('!');
      const std::size_t next = text_.place();
      const Condition inner = condition_of(comparison(), next);
      --depth_;
      return negated(inner);
    }
    Operand left = sum();
    for (const std::string_view sign : {"<=", ">=", "==", "!=", "<", ">"}) {
      if (!text_.skip(sign)) continue;
      const std::size_t next = text_.place();
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
    const std::size_t start = text_.place();
    Operand first = text_.skip_minus() ? Operand(-number_of(quotient(), start)) : quotient();
    for (;;) {
      const bool adds = text_.peek() == '+';
      if (!adds && text_.peek() != '-') return first;
      text_.go_to(text_.place() + 1);
      const Symbolic left = number_of(first, start);
      const std::size_t next = text_.place();
      const bool is_signed = text_.skip_minus();
      const Symbolic term = number_of(quotient(), next);
      const Symbolic right = is_signed ? -term : term;
      first = limited(adds ? left + right : left - right);
    }
  }

  /// A formula is not deeper than the limit, and a refused one not deeper than twice the limit.
  Symbolic limited(const Symbolic& result) const {
    if (result.depth() > deepest_formula)
      text_.fail("no more than " + std::to_string(deepest_formula) + " operations inside one another");
    return result;
  }

  void require_size(std::size_t size) const {
    if (size > most_operations)
      text_.fail("no more than " + std::to_string(most_operations) +
                 " operations with all definitions put in");
  }

  Operand quotient() {
    const std::size_t start = text_.place();
    Operand result = product();
    while (text_.peek() == '/' || text_.peek() == '*') {
      const Symbolic left = number_of(result, start);
      const bool divides = text_.peek() == '/';
      text_.go_to(text_.place() + 1);
      const Symbolic right = factor();
      if (divides && text_.begins_atom()) text_.fail("parentheses around the quotient or its denominator");
      result = limited(divides ? left / right : beside(left * right));
    }
    return result;
  }

  /// Powers side by side.
  Operand product() {
    const std::size_t start = text_.place();
    Operand first = raised_atom();
    return text_.begins_atom() ? Operand(beside(number_of(first, start))) : first;
  }

  Symbolic beside(Symbolic result) {
    while (text_.begins_atom()) {
      if (is_digit(text_.peek()) || text_.peek() == '.') text_.fail("a '*' before the number");
      const std::size_t start = text_.place();
      result = limited(result * number_of(raised_atom(), start));
    }
    return result;
  }

  /// After an operator a sign may stand before a power.
  Symbolic factor() {
    const bool is_signed = text_.skip_minus();
    const std::size_t start = text_.place();
    const Symbolic value = number_of(raised_atom(), start);
    return is_signed ? -value : value;
  }

  Operand raised_atom() {
    const std::size_t start = text_.place();
    const Operand atom_ = atom();
    if (!text_.skip_power()) return atom_;
    const Symbolic base = number_of(atom_, start);
    const bool is_negative = text_.skip('-');
    if (is_negative && !is_digit(text_.peek())) text_.fail("a number, or parentheses around the exponent");
    const std::size_t next = text_.place();
    const Symbolic exponent = number_of(atom(), next);
    if (begins_power()) text_.fail("parentheses around one of the powers");
    const bool is_whole = exponent.kind() == Symbolic::Kind::number &&
                          std::all_of(exponent.name().begin(), exponent.name().end(), is_digit);
    const Symbolic result = raised(base, is_negative ? -exponent : exponent);
    if (is_whole && result.kind() != Symbolic::Kind::integer_power)
      text_.fail("a smaller whole exponent", next);
    return result;
  }

  bool begins_power() { return text_.peek() == '^' || (text_.peek() == '*' && text_.next(1) == '*'); }

  Operand atom() {
    Operand result = bare_atom();
    const auto* value = std::get_if<Symbolic>(&result);
    if (value != nullptr && names_.program != nullptr) result = names_.program->behind(*value, text_);
    refuse_what_follows();
    return result;
  }

  Operand bare_atom() {
    if (names_.program != nullptr && text_.begins_atom() && text_.peek() != '(')
      return names_.program->atom(text_);
    if (text_.begins_number()) return number();
    if (begins_name(text_.peek())) return named();
    if (names_.program == nullptr && skip_cast()) return cast();
    refuse_bars();
    if (!text_.skip('(')) text_.fail("a number, a name or '('");
    Operand inner = any_formula();
    text_.expect(')');
    return inner;
  }

  /// A number without the suffix of an unsigned integer.
  Symbolic number() {
    const std::size_t start = text_.place();
    const std::string decimal = text_.number();
    const char suffix = text_.next();
    const bool has_suffix = (suffix == 'u' || suffix == 'U') && is_digit(text_.at(text_.place() - 1)) &&
                            std::all_of(decimal.begin(), decimal.end(), is_digit) &&
                            !begins_name(text_.next(1)) && !is_digit(text_.next(1)) && text_.next(1) != '(';
    if (has_suffix && !is_declared(std::string_view(&suffix, 1))) {
      if (names_.takes_parameters)
        text_.fail("no suffix, or a '*': in a form " + decimal + suffix + " may be " + decimal + "*" + suffix,
                   start);
      text_.go_to(text_.place() + 1);
    }
    return Symbolic::number(decimal);
  }

  bool is_declared(std::string_view name) const {
    return has(names_.variables, name) || names_.definitions.contains(name) || has(bound_, name);
  }

  /// Moves behind `(float)` and the like. Refuses a cast to anything but a real number.
  bool skip_cast() {
    if (text_.peek() != '(') return false;
    const std::size_t start = text_.place();
    text_.skip('(');
    const std::size_t inside = text_.place();
    const std::string_view type = text_.name();
    const bool is_in_parentheses = !type.empty() && text_.skip(')');
    if (is_in_parentheses && !is_declared(type)) {
      if (is_real_type(type)) return true;
      if (is_of_vectors(type)) refuse_vector(type, inside);
      if (type == "int" || type == "uint")
        text_.fail("a cast to a real number, not to '" + std::string(type) + "' (trunc drops the fraction)",
                   inside);
    }
    text_.go_to(start);
    return false;
  }

  /// What is cast, as in C: the next atom, with a sign or another cast before it.
  Symbolic cast() {
    if (++depth_ > deepest) text_.fail("no more than " + std::to_string(deepest) + " casts");
    const bool is_signed = text_.skip_minus();
    const std::size_t start = text_.place();
    const Symbolic value = number_of(atom(), start);
    if (is_signed && begins_power()) text_.fail("parentheses around the base of the power");
    --depth_;
    return is_signed ? -value : value;
  }

  /// Says by name what shaders write behind a value and formulas do not have.
  void refuse_what_follows() {
    refuse_bars();
    if (text_.peek() == '%')
      text_.fail("an operator or the end, not '%' (it is not part of the language: mod and fmod are)");
    if (text_.peek() != '.' || !begins_name(text_.next(1))) return;
    const std::size_t start = text_.place();
    text_.go_to(start + 1);
    text_.fail("an operator or the end, not '." + std::string(text_.name()) +
                   "' (swizzles and members are not part of the language)",
               start);
  }

  /// A magnitude as mathematicians write it.
  void refuse_bars() {
    if (text_.peek() == '|' && text_.next(1) != '|') text_.fail("abs(x) for |x|, not '|'");
  }

  /// Names of mathematics that formulas do not have. In a form they would silently be parameters.
  void refuse_name_of_mathematics(std::string_view name, std::size_t start) {
    if (has(names_.parameters, name)) return;
    if (name == "ln") text_.fail("log for the natural logarithm, not 'ln'", start);
    if (name == "e" && (!names_.takes_parameters || begins_exponential()))
      text_.fail("exp(x) for e^x, not 'e'", start);
  }

  /// Whether a power follows whose exponent is not a number. A parameter e may have a square.
  bool begins_exponential() {
    const std::size_t start = text_.place();
    const bool is_power = text_.skip_power();
    text_.skip('-');
    const bool has_number = text_.begins_number();
    text_.go_to(start);
    return is_power && !has_number;
  }

  [[noreturn]] void refuse_vector(std::string_view name, std::size_t start) const {
    text_.fail("a real number, not '" + std::string(name) + "' (vectors are not part of the language)",
               start);
  }

  Symbolic named() {
    const std::size_t start = text_.place();
    const std::string_view name = text_.name();
    const bool is_before_parenthesis = text_.next() == '(';
    if (has(names_.variables, name)) return Symbolic::variable(name);
    if (const auto found = names_.definitions.find(name); found != names_.definitions.end())
      return use(found->first, found->second);
    if (const auto constant = named_constant(name)) return *constant;
    if (name == "std" && text_.skip("::")) return behind("std::");
    if (is_python_module(name) && text_.next() == '.' && begins_name(text_.next(1))) {
      text_.skip('.');
      return behind(std::string(name) + ".");
    }
    if (!argument_counts(name).empty()) return call_of(name, start);
    if (name == "integral" && is_before_parenthesis && names_.takes_integrals) return integral_of(start);
    if (const Truth* truth = find_truth(name); truth && is_before_parenthesis && names_.takes_integrals)
      return use(std::string(name), definition_of(*truth));
    if (const NamedFormula* named =
            is_before_parenthesis && names_.takes_integrals ? find_formula(name) : nullptr)
      return use(std::string(name), named->definition);
    if (has(bound_, name)) return Symbolic::variable(name);
    if (has(past_, name)) text_.fail("'" + std::string(name) + "' inside its integral alone", start);
    if (is_before_parenthesis && is_of_vectors(name)) refuse_vector(name, start);
    refuse_name_of_mathematics(name, start);
    if (may_be_parameter(name) && !(is_before_parenthesis && name.size() > 1)) {
      if (!has(parameters_, name)) parameters_.emplace_back(name);
      return Symbolic::variable(name);
    }
    refuse(name, start);
  }

  bool may_be_parameter(std::string_view name) const {
    return names_.takes_parameters && (names_.parameters.empty() || has(names_.parameters, name));
  }

  Symbolic call_of(std::string_view function, std::size_t start) {
    const std::vector<std::size_t> counts = argument_counts(function);
    const std::vector<Symbolic> given = arguments();
    if (std::find(counts.begin(), counts.end(), given.size()) == counts.end())
      text_.fail(counted(counts) + " of '" + std::string(function) + "'", start);
    return call(function, given);
  }

  /// The function or the number behind `std::`, `np.` and the like.
  Symbolic behind(const std::string& prefix) {
    text_.peek();
    const std::size_t start = text_.place();
    std::string_view name = text_.name();
    if (prefix != "std::") {
      name = name_for_numpy(name);
      if (const auto constant = named_constant(name)) return *constant;
    }
    if (argument_counts(name).empty())
      text_.fail("a function after '" + prefix + "', not '" + std::string(name) + "'" +
                     did_you_mean(nearest_name(name, function_names())),
                 start);
    return call_of(name, start);
  }

  /// integral(body, t, lower, upper). The variable is read first, since the body uses it.
  Symbolic integral_of(std::size_t start) {
    constexpr std::size_t most_inside = 2;
    text_.expect('(');
    const std::size_t body_start = text_.place();
    text_.go_to(text_.end_of_argument());
    text_.expect(',');
    const std::string variable = new_name();
    const std::size_t rest = text_.place();
    if (bound_.size() == most_inside) text_.fail("no more than two integrals inside one another", start);
    text_.go_to(body_start);
    bound_.push_back(variable);
    const Symbolic body = formula();
    bound_.pop_back();
    past_.push_back(variable);
    text_.expect(',');
    text_.go_to(rest);
    text_.expect(',');
    const Symbolic lower = formula();
    text_.expect(',');
    const Symbolic upper = formula();
    text_.expect(')');
    return limited(Symbolic::integral(variable, {body, lower, upper}));
  }

  /// A name that nothing else has.
  std::string new_name() {
    text_.peek();
    const std::size_t start = text_.place();
    const std::string name(text_.name());
    const bool is_taken = is_declared(name) || has(parameters_, name) || !argument_counts(name).empty() ||
                          named_constant(name) || name == "integral";
    if (name.empty() || is_taken) text_.fail("a new name for the variable of the integral", start);
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
    const std::size_t start = text_.place();
    if (definition.arguments.empty()) return definition.formula;
    const std::vector<Symbolic> given = arguments();
    if (given.size() != definition.arguments.size())
      text_.fail(counted({definition.arguments.size()}) + " of '" + name + "'", start);
    require_size(size_of(definition, given));
    return limited(put_in(definition, given));
  }

  std::vector<Symbolic> arguments() {
    text_.expect('(');
    std::vector<Symbolic> result{formula()};
    while (text_.skip(',')) result.push_back(formula());
    text_.expect(')');
    return result;
  }

  /// An unknown name: a function where others are parameters, else any.
  [[noreturn]] void refuse(std::string_view name, std::size_t start) const {
    std::vector<std::string> known = function_names();
    for (const auto& [defined, _] : names_.definitions) known.push_back(defined);
    if (names_.takes_integrals) {
      for (const Truth& truth : truths()) known.emplace_back(truth.name);
      for (const NamedFormula& named : named_formulas()) known.emplace_back(named.name);
    }
    const bool is_call = text_.at(start + name.size()) == '(';
    if (names_.takes_parameters && (names_.parameters.empty() || may_be_parameter(name))) {
      const auto nearest = nearest_name(name, known);
      text_.fail("a function before '(', not '" + std::string(name) + "'" +
                     (nearest ? did_you_mean(nearest) : "; a product needs a '*' or a space"),
                 start);
    }
    std::vector<std::string> declared = names_.variables;
    declared.insert(declared.end(), names_.parameters.begin(), names_.parameters.end());
    for (const auto& [defined, _] : names_.definitions) declared.push_back(defined);
    std::string names;
    for (const std::string& one : declared) names += one + ", ";
    text_.fail("one of " + names + "pi, ln2 and the functions, not '" + std::string(name) + "'" +
                   did_you_mean(nearest_name(name, is_call ? known : declared)),
               start);
  }

  Symbolic number_of(const Operand& operand, std::size_t start) const {
    if (std::holds_alternative<Condition>(operand)) text_.fail("a number, not a condition", start);
    return std::get<Symbolic>(operand);
  }

  Condition condition_of(const Operand& operand, std::size_t start) const {
    if (std::holds_alternative<Symbolic>(operand)) text_.fail("a condition (such as a < b)", start);
    return std::get<Condition>(operand);
  }

  FormulaText text_;
  const FormulaNames& names_;
  std::vector<std::string> parameters_;
  std::vector<std::string> bound_;  ///< variables of the integrals around the place
  std::vector<std::string> past_;   ///< and of those before it
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
