#include "fit/scalars/symbolic.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

/// The binding of an expression's text. Looser text than its place needs gets parentheses.
enum class Binding { sum, quotient, product, power, atom };

/// The words of one notation. Operands come as texts, with the parentheses that they need.
struct Notation {
  std::string (*in_parentheses)(const std::string&);
  std::string (*variable)(const std::string& name);
  std::string (*quotient)(const std::string& a, const std::string& b);
  std::string (*power)(const std::string& base, const std::string& exponent);
  std::string (*select)(const std::string& a, const std::string& b, const std::string& yes,
                        const std::string& no);
  std::pair<std::string, Binding> (*integral)(const std::string& body, const std::string& variable,
                                              const std::string& lower, const std::string& upper);
  std::string times_number;  ///< between a factor and a factor that begins with a digit
  bool fraction_bar;         ///< a quotient needs no parentheses, inside or outside
  bool raised_exponent;      ///< an exponent needs none either
  std::pair<std::string, Binding> (*function)(const std::string& name,
                                              const std::vector<std::string>& arguments);
};

std::pair<std::string, Binding> write(const Symbolic& e, const Notation& notation);

/// A part of an expression, in parentheses unless it binds at least as tightly as `least`.
std::string operand(const Symbolic& e, Binding least, const Notation& notation) {
  const auto [text, binding] = write(e, notation);
  return binding < least ? notation.in_parentheses(text) : text;
}

std::string product(const Symbolic& e, const Notation& notation) {
  const std::string left = operand(e.part(0), Binding::product, notation);
  // Without parentheses, a product or quotient on the right would be read as part of the left.
  const std::string right = operand(e.part(1), Binding::power, notation);
  const bool is_digit = std::isdigit(static_cast<unsigned char>(right.front())) != 0;
  return left + (is_digit ? notation.times_number : " ") + right;
}

std::pair<std::string, Binding> write(const Symbolic& e, const Notation& notation) {
  const auto at_least = [&](std::size_t i, Binding least) { return operand(e.part(i), least, notation); };
  const auto whole = [&](std::size_t i) { return at_least(i, Binding::sum); };
  switch (e.kind()) {
    case Kind::variable:
      return {notation.variable(e.name()), Binding::atom};
    case Kind::number:
      return {e.name(), e.name().front() == '-' ? Binding::sum : Binding::atom};
    case Kind::constant:
      return notation.function(e.name(), {});
    case Kind::add:
    case Kind::subtract: {
      const bool is_signed = e.part(1).kind() == Kind::negate;
      const std::string right =
          is_signed ? notation.in_parentheses(whole(1)) : at_least(1, Binding::quotient);
      return {whole(0) + (e.kind() == Kind::add ? " + " : " - ") + right, Binding::sum};
    }
    case Kind::negate:
      return {"-" + at_least(0, Binding::quotient), Binding::sum};
    case Kind::multiply:
      return {product(e, notation), Binding::product};
    case Kind::divide:
      if (notation.fraction_bar) return {notation.quotient(whole(0), whole(1)), Binding::power};
      return {notation.quotient(at_least(0, Binding::product), at_least(1, Binding::power)),
              Binding::quotient};
    case Kind::real_power:
      return {notation.power(at_least(0, Binding::atom),
                             at_least(1, notation.raised_exponent ? Binding::sum : Binding::atom)),
              Binding::power};
    case Kind::integer_power:
      return {notation.power(at_least(0, Binding::atom), e.name()), Binding::power};
    case Kind::choice:
      return {notation.select(whole(0), whole(1), whole(2), whole(3)), Binding::atom};
    case Kind::integral:
      return notation.integral(whole(0), notation.variable(e.name()), whole(1), whole(2));
    case Kind::function:
      break;
  }
  std::vector<std::string> arguments;
  for (std::size_t i = 0; i < e.parts().size(); ++i) arguments.push_back(whole(i));
  return notation.function(e.name(), arguments);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

const Notation plain{
    .in_parentheses = [](const std::string& s) { return "(" + s + ")"; },
    .variable = [](const std::string& name) { return name; },
    .quotient = [](const std::string& a, const std::string& b) { return a + "/" + b; },
    .power = [](const std::string& base, const std::string& exponent) { return base + "^" + exponent; },
    .select = [](const std::string& a, const std::string& b, const std::string& yes,
                 const std::string& no) { return "(" + a + " < " + b + " ? " + yes + " : " + no + ")"; },
    .integral =
        [](const std::string& body, const std::string& t, const std::string& a, const std::string& b) {
          const std::string text = "integral(" + joined({body, t, a, b}) + ")";
          return std::pair(text, Binding::atom);
        },
    .times_number = " * ",
    .fraction_bar = false,
    .raised_exponent = false,
    .function =
        [](const std::string& name, const std::vector<std::string>& arguments) {
          const std::string text = arguments.empty() ? name : name + "(" + joined(arguments) + ")";
          return std::pair(text, Binding::atom);
        },
};

std::string latex_parentheses(const std::string& s) {
  return "\\left(" + s + "\\right)";
}

bool is_greek(const std::string& name) {
  constexpr std::array greek{"alpha", "beta", "eta", "theta", "kappa", "rho", "phi", "Lambda"};
  return std::find(greek.begin(), greek.end(), name) != greek.end();
}

/// A Greek letter by its name, a letter with its index (n1, theta_v), any other word upright.
std::string latex_variable(const std::string& name) {
  if (is_greek(name)) return "\\" + name;
  if (name.size() == 1) return name;
  const bool has_number =
      std::all_of(name.begin() + 1, name.end(), [](char c) { return '0' <= c && c <= '9'; });
  if (has_number) return name.substr(0, 1) + "_{" + name.substr(1) + "}";
  const std::size_t bar = name.find('_', 1);
  const std::string letter = name.substr(0, bar);
  const bool has_index = bar < name.size() - 1 && (is_greek(letter) || (bar == 1 && letter != "_"));
  if (has_index) return latex_variable(letter) + "_{" + latex_variable(name.substr(bar + 1)) + "}";
  std::string word;
  for (const char c : name) word += c == '_' ? "\\_" : std::string(1, c);
  return "\\mathrm{" + word + "}";
}

std::pair<std::string, Binding> latex_function(const std::string& name, const std::vector<std::string>& x) {
  if (name == "pi") return {"\\pi", Binding::atom};
  if (name == "ln2") return {"\\ln 2", Binding::product};
  if (name == "exp") return {"e^{" + x[0] + "}", Binding::power};
  if (name == "exp2") return {"2^{" + x[0] + "}", Binding::power};
  if (name == "expm1") return {"e^{" + x[0] + "} - 1", Binding::sum};
  if (name == "sqrt") return {"\\sqrt{" + x[0] + "}", Binding::atom};
  if (name == "asin" || name == "acos" || name == "atan")
    return {"\\arc" + name.substr(1) + latex_parentheses(x[0]), Binding::power};
  if (name == "abs") return {"\\left|" + x[0] + "\\right|", Binding::atom};
  if (name == "floor") return {"\\left\\lfloor " + x[0] + " \\right\\rfloor", Binding::atom};
  if (name == "erf" || name == "sign" || name == "atan2")
    return {"\\operatorname{" + name + "}" + latex_parentheses(joined(x)), Binding::power};
  if (name == "log") return {"\\ln" + latex_parentheses(x[0]), Binding::power};
  if (name == "log2") return {"\\log_2" + latex_parentheses(x[0]), Binding::power};
  if (name == "log1p") return {"\\ln" + latex_parentheses("1 + " + x[0]), Binding::power};
  if (name == "erfc") return {"\\operatorname{erfc}" + latex_parentheses(x[0]), Binding::power};
  if (name == "log1p_remainder")
    return {"\\ln" + latex_parentheses("1 + " + x[0]) + " - " + latex_parentheses(x[0]), Binding::sum};
  return {"\\" + name + latex_parentheses(joined(x)), Binding::power};  // sin, tanh, min ..
}

const Notation latex{
    .in_parentheses = latex_parentheses,
    .variable = latex_variable,
    .quotient = [](const std::string& a, const std::string& b) { return "\\frac{" + a + "}{" + b + "}"; },
    .power = [](const std::string& base,
                const std::string& exponent) { return base + "^{" + exponent + "}"; },
    .select =
        [](const std::string& a, const std::string& b, const std::string& yes, const std::string& no) {
          return "\\begin{cases}" + yes + " & " + a + " < " + b + " \\\\ " + no +
                 " & \\text{otherwise}\\end{cases}";
        },
    .integral =
        [](const std::string& body, const std::string& t, const std::string& a, const std::string& b) {
          const std::string text = "\\int_{" + a + "}^{" + b + "} " + latex_parentheses(body) + " \\, d" + t;
          return std::pair(text, Binding::sum);
        },
    .times_number = " \\cdot ",
    .fraction_bar = true,
    .raised_exponent = true,
    .function = latex_function,
};

/// The different subexpressions, by their text: equal ones are computed once.
using Subexpressions = std::map<std::string, Symbolic>;

/// A sign costs nothing: it is part of the instruction that reads its operand.
const Symbolic& unsigned_part(const Symbolic& e) {
  return e.kind() == Kind::negate ? unsigned_part(e.part(0)) : e;
}

void collect(const Symbolic& e, Subexpressions& found, std::map<std::string, int>& uses) {
  const Symbolic& value = unsigned_part(e);
  if (value.is_of_numbers()) return;
  const std::string key = to_text(value);
  ++uses[key];
  if (!found.emplace(key, value).second) return;
  for (const Symbolic& part : value.parts()) collect(part, found, uses);
}

bool is_product(const Symbolic& e) {
  return e.kind() == Kind::multiply && !e.is_of_numbers();
}

void count_function(const Symbolic& e, Operations& count) {
  const Symbolic& argument = unsigned_part(e.part(0));
  // A numeric factor includes the conversion of the base.
  const bool has_factor = argument.kind() == Kind::multiply &&
                          (argument.part(0).is_of_numbers() || argument.part(1).is_of_numbers());
  if (e.name() == "exp2") {
    ++count.exp2;
  } else if (e.name() == "log2") {
    ++count.log2;
  } else if (e.name() == "exp") {
    ++count.exp2;
    count.multiply += has_factor ? 0 : 1;
  } else if (e.name() == "log") {
    ++count.log2;
    ++count.multiply;
  } else if (e.name() != "abs") {  // an operand's magnitude is free, like its sign
    ++count.other;
  }
}

int multiplications(int exponent) {
  const auto n = static_cast<unsigned>(std::abs(exponent));
  return n == 0 ? 0 : static_cast<int>(std::bit_width(n)) + std::popcount(n) - 2;
}

/// The factor of a product with a number, or of a quotient by one.
std::optional<double> known_factor(const Symbolic& e) {
  const auto value = [](const Symbolic& number) {
    return std::abs(evaluate<double>(number, [](const std::string&) { return 0.0; }));
  };
  if (e.kind() == Kind::divide && e.part(1).is_of_numbers()) return 1 / value(e.part(1));
  if (e.kind() != Kind::multiply) return std::nullopt;
  if (e.part(0).is_of_numbers()) return value(e.part(0));
  if (e.part(1).is_of_numbers()) return value(e.part(1));
  return std::nullopt;
}

/// Counts the instructions of expressions.
class Counter {
 public:
  Counter(std::span<const Symbolic> results, const InstructionSet& instructions)
      : instructions_(instructions) {
    for (const Symbolic& result : results) collect(result, all_, uses_);
    // The largest sums first: a sum of four products must not count as a sum of three and an addition.
    for (const std::size_t terms : {4u, 3u}) {
      for (const auto& [text, e] : all_) {
        if (instructions.dot_products && !inside_.contains(text)) fold_dot_product(e, terms);
      }
    }
  }

  Operations count() {
    for (const auto& [text, e] : all_) {
      if (!inside_.contains(text)) count(e);
    }
    return count_;
  }

 private:
  bool is_used_once(const Symbolic& value) const { return uses_.at(to_text(value)) == 1; }

  /// A product that is used only in one sum: one instruction together with the addition.
  bool is_fused(const Symbolic& part) const {
    const Symbolic& value = unsigned_part(part);
    return is_product(value) && is_used_once(value) && !is_scaled_result(value);
  }

  /// A product that only scales the result of one of its parts.
  bool is_scaled_result(const Symbolic& e) const {
    const auto factor = known_factor(e);
    if (!factor ||
        std::count(instructions_.free_scales.begin(), instructions_.free_scales.end(), *factor) == 0)
      return false;
    const Symbolic& result = unsigned_part(e.part(0).is_of_numbers() ? e.part(1) : e.part(0));
    return !result.parts().empty() && is_used_once(result);
  }

  /// The terms of a sum, and of inner sums that are used nowhere else.
  void add_terms(const Symbolic& sum, std::vector<Symbolic>& terms, std::vector<Symbolic>& inner) const {
    for (const Symbolic& part : sum.parts()) {
      const Symbolic& term = unsigned_part(part);
      const bool is_sum = term.kind() == Kind::add || term.kind() == Kind::subtract;
      if (is_sum && !term.is_of_numbers() && is_used_once(term)) {
        inner.push_back(term);
        add_terms(term, terms, inner);
      } else {
        terms.push_back(term);
      }
    }
  }

  /// If `e` is a dot product of that many terms, counts it as one instruction, with its products and inner
  /// sums.
  void fold_dot_product(const Symbolic& e, std::size_t size) {
    if (e.kind() != Kind::add && e.kind() != Kind::subtract) return;
    std::vector<Symbolic> terms, parts{e};
    add_terms(e, terms, parts);
    const auto products =
        std::partition(terms.begin(), terms.end(), [&](const auto& t) { return is_fused(t); });
    if (terms.size() != size || products - terms.begin() < 3) return;
    ++(size == 4 ? count_.dot4 : count_.dot3);
    parts.insert(parts.end(), terms.begin(), products);
    for (const Symbolic& part : parts) inside_.insert(to_text(part));
  }

  void count(const Symbolic& e) {
    switch (e.kind()) {
      case Kind::integral:
        ++count_.other;
        break;
      case Kind::add:
      case Kind::subtract:
        if (is_fused(e.part(0)) || is_fused(e.part(1))) {
          ++count_.multiply_add;
          --count_.multiply;  // counted where the product itself stands
        } else {
          ++count_.add;
        }
        break;
      case Kind::multiply:
        count_.multiply += is_scaled_result(e) ? 0 : 1;
        break;
      case Kind::divide:
        if (!is_scaled_result(e)) ++(e.part(1).is_of_numbers() ? count_.multiply : count_.divide);
        break;
      case Kind::real_power:
        ++count_.log2;
        ++count_.multiply;
        ++count_.exp2;
        break;
      case Kind::integer_power:
        count_.multiply += multiplications(e.exponent());
        count_.divide += e.exponent() < 0 ? 1 : 0;
        break;
      case Kind::choice:
        count_.other += 2;  // the comparison and the choice
        break;
      case Kind::function:
        count_function(e, count_);
        break;
      case Kind::variable:
      case Kind::number:
      case Kind::constant:
      case Kind::negate:
        break;
    }
  }

  const InstructionSet& instructions_;
  Subexpressions all_;
  std::map<std::string, int> uses_;
  std::set<std::string> inside_;  ///< of a dot product
  Operations count_;
};

}  // namespace

std::string to_text(const Symbolic& expression) {
  return write(expression, plain).first;
}

std::string to_latex(const Symbolic& expression) {
  return write(expression, latex).first;
}

Operations operator-(const Operations& a, const Operations& b) {
  return {.add = a.add - b.add,
          .multiply = a.multiply - b.multiply,
          .multiply_add = a.multiply_add - b.multiply_add,
          .divide = a.divide - b.divide,
          .exp2 = a.exp2 - b.exp2,
          .log2 = a.log2 - b.log2,
          .other = a.other - b.other,
          .dot3 = a.dot3 - b.dot3,
          .dot4 = a.dot4 - b.dot4};
}

Operations count_operations(std::span<const Symbolic> results, const InstructionSet& instructions) {
  return Counter(results, instructions).count();
}

Operations count_operations(const Symbolic& expression, const InstructionSet& instructions) {
  return count_operations(std::span(&expression, 1), instructions);
}

std::string to_text(const Operations& operations) {
  std::vector<std::string> words;
  const auto add = [&](int n, const char* name) {
    if (n > 0) words.push_back(n == 1 ? name : std::to_string(n) + " " + name);
  };
  add(operations.dot3, "DOT3");
  add(operations.dot4, "DOT4");
  add(operations.add, "ADD");
  add(operations.multiply_add, "MAD");
  add(operations.multiply, "MUL");
  add(operations.divide, "DIV");
  add(operations.log2, "LOG2");
  add(operations.exp2, "EXP2");
  add(operations.other, "other");
  return words.empty() ? "nothing" : joined(words);
}

Symbolic substituted(const Symbolic& expression,
                     const std::function<Symbolic(const std::string&)>& value_of) {
  return evaluated<Symbolic>(expression, value_of);
}

}  // namespace shadefit
