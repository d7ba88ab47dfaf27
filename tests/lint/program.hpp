#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "lint/scan/known_set.hpp"
#include "lint/tree/source_language.hpp"

/// Published forms as programs.
namespace shadefit::lint {

using Random = std::mt19937_64;

inline bool toss(Random& random) {
  return random() % 2 == 0;
}

template <class Values>
const auto& any_of_them(const Values& values, Random& random) {
  return values[random() % values.size()];
}

/// How a program writes numbers, powers and functions.
struct Dialect {
  SourceLanguage language;
  std::string function;             ///< before the name of a function
  std::string suffix;               ///< of a number
  std::string vector;               ///< the type of a vector; empty: there is none
  std::vector<std::string> powers;  ///< of {0} to {1}
  std::string exp2;                 ///< of {0}
  std::string choice = "({0} < {1} ? {2} : {3})";
  std::string comment = "//";
  std::string before = "float f(float x) {\n", statement = "  float {0} = {1};\n",
              result = "  return {0};\n}}\n";
};

inline const std::vector<Dialect>& dialects() {
  static const std::string shader_power = "exp2(log2({0}) * {1})";
  static const std::vector<Dialect> all{
      {SourceLanguage::glsl, "", "", "vec3", {"pow({0}, {1})", shader_power}, "exp2({0})"},
      {SourceLanguage::hlsl,
       "",
       "f",
       "float3",
       {"pow({0}, {1})", shader_power, "exp2({1} * log2({0}))"},
       "exp2({0})"},
      {SourceLanguage::c_family, "std::", "f", "", {"std::pow({0}, {1})", "powf({0}, {1})"}, "exp2f({0})"},
      {SourceLanguage::javascript,
       "Math.",
       "",
       "",
       {"Math.pow({0}, {1})", "({0}) ** ({1})"},
       "Math.pow(2, {0})",
       "({0} < {1} ? {2} : {3})",
       "//",
       "function f(x) {\n",
       "  const {0} = {1};\n",
       "  return {0};\n}}\n"},
      {SourceLanguage::python,
       "np.",
       "",
       "",
       {"np.power({0}, {1})", "({0}) ** ({1})"},
       "np.exp2({0})",
       "({2} if {0} < {1} else {3})",
       "#",
       "def f(x):\n",
       "    {0} = {1}\n",
       "    return {0}\n"},
  };
  return all;
}

/// Writes a formula as a program of a dialect; without random numbers in the plainest way.
class Program {
 public:
  explicit Program(const Dialect& dialect, Random* random = nullptr) : dialect_(dialect), random_(random) {}

  /// Operands of sums and products in random order.
  std::string expression(const Symbolic& formula) {
    std::vector<std::string> parts;
    for (const Symbolic& part : formula.parts()) parts.push_back(expression(part));
    switch (formula.kind()) {
      case Symbolic::Kind::variable:
        return formula.name();
      case Symbolic::Kind::number:
        return number(formula.name());
      case Symbolic::Kind::constant:
        return number(formula.name() == "pi" ? "3.14159265358979" : "0.693147180559945");
      case Symbolic::Kind::add:
        return toss_or(true) ? sum(parts[0], " + ", parts[1]) : sum(parts[1], " + ", parts[0]);
      case Symbolic::Kind::subtract:
        return sum(parts[0], " - ", parts[1]);
      case Symbolic::Kind::multiply:
        return toss_or(true) ? parts[0] + " * " + parts[1] : parts[1] + " * " + parts[0];
      case Symbolic::Kind::divide:
        return parts[0] + " / (" + parts[1] + ")";
      case Symbolic::Kind::negate:
        return "(-1.0 * " + parts[0] + ")";
      case Symbolic::Kind::real_power:
        return fmt::format(fmt::runtime(random_ == nullptr ? dialect_.powers.front()
                                                           : any_of_them(dialect_.powers, *random_)),
                           parts[0], parts[1]);
      case Symbolic::Kind::integer_power:
        return power_of(parts[0], formula.exponent());
      case Symbolic::Kind::choice:
        return fmt::format(fmt::runtime(dialect_.choice), parts[0], parts[1], parts[2], parts[3]);
      case Symbolic::Kind::function:
        if (formula.name() == "exp2") return fmt::format(fmt::runtime(dialect_.exp2), parts[0]);
        return fmt::format("{}{}({})", dialect_.function, formula.name(), fmt::join(parts, ", "));
      case Symbolic::Kind::integral:
        break;
    }
    return "";
  }

  /// A function with this value, perhaps with a part as a statement of its own and with old code as a
  /// comment.
  std::string text(const Symbolic& formula, const std::string& variable) {
    std::string body;
    Symbolic value = formula;
    if (toss_or(false)) body += fmt::format("  {0} {1} = {1} / scale;\n", dialect_.comment, variable);
    if (const auto inner = inner_part(formula); inner && toss_or(false)) {
      body += fmt::format(fmt::runtime(dialect_.statement), "t0", expression(*inner));
      value = with_part(formula, *inner, Symbolic::variable("t0"));
    }
    return dialect_.before + body + fmt::format(fmt::runtime(dialect_.result), expression(value));
  }

  static Symbolic with_part(const Symbolic& formula, const Symbolic& part, const Symbolic& other) {
    if (to_text(formula) == to_text(part)) return other;
    std::vector<Symbolic> parts = formula.parts();
    for (Symbolic& one : parts) one = with_part(one, part, other);
    return formula.with_parts(std::move(parts));
  }

 private:
  bool toss_or(bool plain) { return random_ == nullptr ? plain : toss(*random_); }

  static std::string sum(const std::string& a, const char* sign, const std::string& b) {
    return "(" + a + sign + b + ")";
  }

  std::string number(const std::string& printed) {
    const bool is_negative = printed.starts_with('-');
    std::string digits = printed.substr(is_negative ? 1 : 0);
    if (digits.find('.') == std::string::npos && digits.find('e') == std::string::npos) digits += ".0";
    digits += dialect_.suffix;
    if (!dialect_.vector.empty() && has_vectors_)
      digits = dialect_.vector == "vec3" ? "vec3(" + digits + ")"
                                         : fmt::format("{0}({1}, {1}, {1})", dialect_.vector, digits);
    return is_negative ? "(-" + digits + ")" : digits;
  }

  std::string power_of(const std::string& base, int exponent) const {
    if (exponent < 1) return fmt::format(fmt::runtime(dialect_.powers.front()), base, exponent);
    std::string product = "(" + base;
    for (int i = 1; i < exponent; ++i) product += " * " + base;
    return product + ")";
  }

  /// A function, a power or a quotient inside the formula.
  std::optional<Symbolic> inner_part(const Symbolic& formula) {
    std::vector<Symbolic> all;
    for (const Symbolic& part : formula.parts()) append_inner(part, all);
    if (all.empty() || formula.kind() == Symbolic::Kind::choice) return std::nullopt;
    return random_ == nullptr ? all.front() : any_of_them(all, *random_);
  }
  static void append_inner(const Symbolic& part, std::vector<Symbolic>& all) {
    if (part.kind() == Symbolic::Kind::function || part.kind() == Symbolic::Kind::real_power ||
        part.kind() == Symbolic::Kind::divide)
      all.push_back(part);
    for (const Symbolic& one : part.parts()) append_inner(one, all);
  }

  const Dialect& dialect_;
  Random* random_;
  bool has_vectors_ = toss_or(false);
};

/// The formula of a set with these numbers.
inline Symbolic with_numbers(const KnownSet& set, const std::vector<std::string>& numbers) {
  return evaluate<Symbolic>(set.formula, [&](const std::string& name) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (set.constants[i].name == name) return Symbolic::number(numbers[i]);
    return Symbolic::variable(name);
  });
}

inline std::vector<std::string> printed_numbers(const KnownSet& set) {
  std::vector<std::string> numbers;
  for (const KnownConstant& constant : set.constants) numbers.push_back(constant.printed);
  return numbers;
}

}  // namespace shadefit::lint
