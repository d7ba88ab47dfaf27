#include "fit/symbolic.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdlib>
#include <map>

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

/// How tightly the text of an expression holds together: what is looser than its place asks for is put in
/// parentheses.
enum class Binding { sum, quotient, product, power, atom };

/// The words of one notation: each takes the texts of its operands, already in parentheses where they need
/// them.
struct Notation {
  std::string (*in_parentheses)(const std::string&);
  std::string (*variable)(const std::string& name);
  std::string (*quotient)(const std::string& a, const std::string& b);
  std::string (*power)(const std::string& base, const std::string& exponent);
  std::string (*select)(const std::string& a, const std::string& b, const std::string& yes,
                        const std::string& no);
  std::string times_number;  ///< between a factor and one that begins with a digit
  bool fraction_bar;         ///< a quotient needs no parentheses, inside or outside
  bool raised_exponent;      ///< nor does an exponent
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
  // A second product or quotient on the right would read as one with the left.
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

/// A Greek letter by its name, a letter with its index, any other word upright.
std::string latex_variable(const std::string& name) {
  constexpr std::array greek{"alpha", "beta", "eta", "theta", "kappa", "rho", "phi"};
  if (std::find(greek.begin(), greek.end(), name) != greek.end()) return "\\" + name;
  if (name.size() == 1) return name;
  const bool has_index =
      std::all_of(name.begin() + 1, name.end(), [](char c) { return '0' <= c && c <= '9'; });
  if (has_index) return name.substr(0, 1) + "_{" + name.substr(1) + "}";
  return "\\mathrm{" + name + "}";
}

std::pair<std::string, Binding> latex_function(const std::string& name, const std::vector<std::string>& x) {
  if (name == "pi") return {"\\pi", Binding::atom};
  if (name == "ln2") return {"\\ln 2", Binding::product};
  if (name == "exp") return {"e^{" + x[0] + "}", Binding::power};
  if (name == "exp2") return {"2^{" + x[0] + "}", Binding::power};
  if (name == "expm1") return {"e^{" + x[0] + "} - 1", Binding::sum};
  if (name == "sqrt") return {"\\sqrt{" + x[0] + "}", Binding::atom};
  if (name == "atan") return {"\\arctan" + latex_parentheses(x[0]), Binding::power};
  if (name == "log") return {"\\ln" + latex_parentheses(x[0]), Binding::power};
  if (name == "log2") return {"\\log_2" + latex_parentheses(x[0]), Binding::power};
  if (name == "log1p") return {"\\ln" + latex_parentheses("1 + " + x[0]), Binding::power};
  if (name == "erfc") return {"\\operatorname{erfc}" + latex_parentheses(x[0]), Binding::power};
  if (name == "log1p_remainder")
    return {"\\ln" + latex_parentheses("1 + " + x[0]) + " - " + latex_parentheses(x[0]), Binding::sum};
  return {"\\" + name + latex_parentheses(joined(x)), Binding::power};  // sin, cos, min, max
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
    .times_number = " \\cdot ",
    .fraction_bar = true,
    .raised_exponent = true,
    .function = latex_function,
};

/// The subexpressions, each once, by their text: what is equal is computed once.
using Subexpressions = std::map<std::string, Symbolic>;

/// A sign costs nothing: it is part of the instruction that reads its operand.
const Symbolic& unsigned_part(const Symbolic& e) {
  return e.kind() == Kind::negate ? unsigned_part(e.part(0)) : e;
}

bool is_known_before(const Symbolic& e) {
  return e.kind() != Kind::variable && std::all_of(e.parts().begin(), e.parts().end(), is_known_before);
}

void collect(const Symbolic& e, Subexpressions& found, std::map<std::string, int>& uses) {
  const Symbolic& value = unsigned_part(e);
  if (is_known_before(value)) return;
  const std::string key = to_text(value);
  ++uses[key];
  if (!found.emplace(key, value).second) return;
  for (const Symbolic& part : value.parts()) collect(part, found, uses);
}

bool is_product(const Symbolic& e) {
  return e.kind() == Kind::multiply && !is_known_before(e);
}

void count_function(const Symbolic& e, Operations& count) {
  const Symbolic& argument = unsigned_part(e.part(0));
  // A factor that is a number takes the conversion of the base with it.
  const bool has_factor = argument.kind() == Kind::multiply &&
                          (is_known_before(argument.part(0)) || is_known_before(argument.part(1)));
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
  } else {
    ++count.other;
  }
}

int multiplications(int exponent) {
  const auto n = static_cast<unsigned>(std::abs(exponent));
  return n == 0 ? 0 : static_cast<int>(std::bit_width(n)) + std::popcount(n) - 2;
}

}  // namespace

std::string to_text(const Symbolic& expression) {
  return write(expression, plain).first;
}

std::string to_latex(const Symbolic& expression) {
  return write(expression, latex).first;
}

Operations count_operations(const Symbolic& expression) {
  Subexpressions all;
  std::map<std::string, int> uses;
  collect(expression, all, uses);
  Operations count;
  for (const auto& [text, e] : all) {
    switch (e.kind()) {
      case Kind::add:
      case Kind::subtract: {
        const auto is_fused = [&](const Symbolic& part) {
          const Symbolic& value = unsigned_part(part);
          return is_product(value) && uses.at(to_text(value)) == 1;
        };
        if (is_fused(e.part(0)) || is_fused(e.part(1))) {
          ++count.multiply_add;
          --count.multiply;  // its own, counted where it stands
        } else {
          ++count.add;
        }
        break;
      }
      case Kind::multiply:
        ++count.multiply;
        break;
      case Kind::divide:
        ++(is_known_before(e.part(1)) ? count.multiply : count.divide);
        break;
      case Kind::real_power:
        ++count.log2;
        ++count.multiply;
        ++count.exp2;
        break;
      case Kind::integer_power:
        count.multiply += multiplications(e.exponent());
        count.divide += e.exponent() < 0 ? 1 : 0;
        break;
      case Kind::choice:
        count.other += 2;  // the comparison and the choice
        break;
      case Kind::function:
        count_function(e, count);
        break;
      case Kind::variable:
      case Kind::number:
      case Kind::constant:
      case Kind::negate:
        break;
    }
  }
  return count;
}

std::string to_text(const Operations& operations) {
  std::vector<std::string> words;
  const auto add = [&](int n, const char* name) {
    if (n > 0) words.push_back(n == 1 ? name : std::to_string(n) + " " + name);
  };
  add(operations.add, "ADD");
  add(operations.multiply_add, "MAD");
  add(operations.multiply, "MUL");
  add(operations.divide, "DIV");
  add(operations.log2, "LOG2");
  add(operations.exp2, "EXP2");
  add(operations.other, "other");
  return words.empty() ? "nothing" : joined(words);
}

}  // namespace shadefit
