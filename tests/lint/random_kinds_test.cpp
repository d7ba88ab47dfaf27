#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "lint/lint_tree.hpp"
#include "lint/scan/characters.hpp"
#include "tests/lint/all_known.hpp"

/// Published forms in random languages and notations, with one slip or with harmless changes. The number of
/// programs is that of the environment variable SHADEFIT_RANDOM_LINT, or 50.
namespace shadefit::lint {
namespace {

using Random = std::mt19937_64;

bool toss(Random& random) {
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

const std::vector<Dialect>& dialects() {
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
       "np.where({0} < {1}, {2}, {3})",
       "#",
       "def f(x):\n",
       "    {0} = {1}\n",
       "    return {0}\n"},
  };
  return all;
}

using Kind = Symbolic::Kind;

/// Writes a formula as a program of a dialect.
class Program {
 public:
  Program(const Dialect& dialect, Random& random) : dialect_(dialect), random_(random) {}

  /// Operands of sums and products in random order.
  std::string expression(const Symbolic& formula) {
    std::vector<std::string> parts;
    for (const Symbolic& part : formula.parts()) parts.push_back(expression(part));
    switch (formula.kind()) {
      case Kind::variable:
        return formula.name();
      case Kind::number:
        return number(formula.name());
      case Kind::constant:
        return number(formula.name() == "pi" ? "3.14159265358979" : "0.693147180559945");
      case Kind::add:
        return toss(random_) ? sum(parts[0], " + ", parts[1]) : sum(parts[1], " + ", parts[0]);
      case Kind::subtract:
        return sum(parts[0], " - ", parts[1]);
      case Kind::multiply:
        return toss(random_) ? parts[0] + " * " + parts[1] : parts[1] + " * " + parts[0];
      case Kind::divide:
        return parts[0] + " / (" + parts[1] + ")";
      case Kind::negate:
        return "(-1.0 * " + parts[0] + ")";
      case Kind::real_power:
        return fmt::format(fmt::runtime(any_of_them(dialect_.powers, random_)), parts[0], parts[1]);
      case Kind::integer_power:
        return power_of(parts[0], formula.exponent());
      case Kind::choice:
        return fmt::format(fmt::runtime(dialect_.choice), parts[0], parts[1], parts[2], parts[3]);
      case Kind::function:
        if (formula.name() == "exp2") return fmt::format(fmt::runtime(dialect_.exp2), parts[0]);
        return fmt::format("{}{}({})", dialect_.function, formula.name(), fmt::join(parts, ", "));
      case Kind::integral:
        break;
    }
    return "";
  }

  /// A function with this value, perhaps with a part as a statement of its own and with old code as a
  /// comment.
  std::string text(const Symbolic& formula, const std::string& variable) {
    std::string body;
    Symbolic value = formula;
    if (toss(random_)) body += fmt::format("  {0} {1} = {1} / scale;\n", dialect_.comment, variable);
    if (const auto inner = inner_part(formula); inner && toss(random_)) {
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
    if (all.empty() || formula.kind() == Kind::choice) return std::nullopt;
    return any_of_them(all, random_);
  }
  static void append_inner(const Symbolic& part, std::vector<Symbolic>& all) {
    if (part.kind() == Kind::function || part.kind() == Kind::real_power || part.kind() == Kind::divide)
      all.push_back(part);
    for (const Symbolic& one : part.parts()) append_inner(one, all);
  }

  const Dialect& dialect_;
  Random& random_;
  bool has_vectors_ = toss(random_);
};

/// The formula of a set with these numbers.
Symbolic with_numbers(const KnownSet& set, const std::vector<std::string>& numbers) {
  return evaluate<Symbolic>(set.formula, [&](const std::string& name) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (set.constants[i].name == name) return Symbolic::number(numbers[i]);
    return Symbolic::variable(name);
  });
}

std::vector<std::string> printed_numbers(const KnownSet& set) {
  std::vector<std::string> numbers;
  for (const KnownConstant& constant : set.constants) numbers.push_back(constant.printed);
  return numbers;
}

/// The largest difference of two formulas of the variables of a set, relative to the largest value, for the
/// best order of the variables.
double difference_of(const KnownSet& set, const Symbolic& a, const Symbolic& b) {
  std::vector<std::size_t> order(set.axes.size());
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    Random random(7);
    std::uniform_real_distribution<double> shares(0, 1);
    double most = 0, difference = 0;
    for (int i = 0; i < 50; ++i) {
      std::vector<double> place;
      for (const KnownAxis& axis : set.axes)
        place.push_back(axis.lower + (axis.upper - axis.lower) * shares(random));
      const auto value_of = [&](const Symbolic& formula, bool is_moved) {
        return evaluate<double>(formula, [&](const std::string& name) {
          const auto axis = std::ranges::find(set.axes, name, &KnownAxis::variable);
          const auto at = static_cast<std::size_t>(axis - set.axes.begin());
          return place[is_moved ? order[at] : at];
        });
      };
      const double before = value_of(a, false), after = value_of(b, true);
      if (!std::isfinite(before)) continue;
      most = std::max(most, std::abs(before));
      difference = std::max(difference, std::isfinite(after) ? std::abs(after - before) : 1e300);
    }
    least = std::min(least, difference / most);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

bool is_one(const Symbolic& formula) {
  return formula.kind() == Kind::number && formula.name() == "1";
}

/// The formula without factors that are 1.
Symbolic without_ones(const Symbolic& formula) {
  std::vector<Symbolic> parts;
  for (const Symbolic& part : formula.parts()) parts.push_back(without_ones(part));
  if (formula.kind() == Kind::multiply)
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      if (is_one(parts[side])) return parts[1 - side];
  return formula.with_parts(std::move(parts));
}

/// A power of a variable to a constant with digits.
std::optional<Symbolic> inner_power(const Symbolic& formula) {
  if (formula.kind() == Kind::real_power && formula.part(0).kind() == Kind::variable &&
      formula.part(1).kind() == Kind::number)
    return formula;
  for (const Symbolic& part : formula.parts())
    if (auto power = inner_power(part)) return power;
  return std::nullopt;
}

class RandomKinds : public ::testing::Test {
 protected:
  RandomKinds() {
    if (const char* asked = std::getenv("SHADEFIT_RANDOM_LINT")) programs_ = std::atoi(asked);
    for (const KnownSet& set : known_.sets) {
      constexpr std::size_t most_constants = 8;
      if (!set.times.empty() || set.constants.size() > most_constants || set.constants.size() < 2) continue;
      Random plain(1);
      const std::string text =
          Program(dialects().front(), plain).text(with_numbers(set, printed_numbers(set)), "x");
      const auto sites = lint_source("a", text, SourceLanguage::glsl, known_, {});
      if (sites.size() == 1 && sites.front().id == set.id && sites.front().grade == Grade::right)
        sets_.push_back(&set);
    }
  }

  /// The worst grade that lint gives a program; `right` without a finding.
  Grade grade_of_program(const Dialect& dialect, const std::string& text) const {
    Grade worst = Grade::right;
    for (const LintedSite& site : lint_source("a", text, dialect.language, known_, {}))
      worst = std::max(worst, site.grade);
    return worst;
  }

  /// Plants changes that move the curve by more than 0.2 percent: most of them have to be found.
  template <class Change>
  void expect_found(unsigned seed, const Change& change) const {
    constexpr double least_difference = 2e-3;
    Random random(seed);
    int planted = 0, found = 0;
    std::string missed;
    while (planted < programs_) {
      const KnownSet& set = *any_of_them(sets_, random);
      const Dialect& dialect = any_of_them(dialects(), random);
      std::vector<std::string> numbers = printed_numbers(set);
      change(numbers, random);
      const Symbolic formula = with_numbers(set, numbers);
      if (difference_of(set, with_numbers(set, printed_numbers(set)), formula) < least_difference) continue;
      ++planted;
      const std::string text = Program(dialect, random).text(formula, set.axes.front().variable);
      const bool is_found = grade_of_program(dialect, text) >= Grade::typo;
      found += is_found ? 1 : 0;
      if (!is_found) missed += set.id + " " + set.form + "\n" + text;
    }
    std::cout << fmt::format("{} of {} found\n", found, planted);
    // Not found: what is no curve any more, as a maximum with 0 that is 0 everywhere.
    EXPECT_GE(found, 0.9 * planted) << missed;
  }

  KnownConstants known_ = all_known();
  std::vector<const KnownSet*> sets_;
  int programs_ = 50;
};

TEST_F(RandomKinds, AHarmlessChangeIsRight) {
  ASSERT_GT(sets_.size(), 40u);
  Random random(20260);
  for (int i = 0; i < programs_; ++i) {
    const KnownSet& set = *any_of_them(sets_, random);
    const Dialect& dialect = any_of_them(dialects(), random);
    Symbolic formula = with_numbers(set, printed_numbers(set));
    const KnownAxis& axis = any_of_them(set.axes, random);
    // One variable is 1 and folded away.
    if (set.axes.size() > 1 && axis.lower <= 1 && 1 <= axis.upper && toss(random))
      formula =
          without_ones(Program::with_part(formula, Symbolic::variable(axis.variable), Symbolic::number("1")));
    // An inner power is computed elsewhere.
    if (const auto power = inner_power(formula); power && toss(random))
      formula = Program::with_part(formula, *power, Symbolic::variable("elsewhere"));
    const std::string text = Program(dialect, random).text(formula, axis.variable);
    EXPECT_LE(grade_of_program(dialect, text), Grade::right) << set.id << " " << set.form << "\n" << text;
  }
}

TEST_F(RandomKinds, TwoExchangedConstantsAreFound) {
  expect_found(20261, [](std::vector<std::string>& numbers, Random& random) {
    std::swap(numbers[random() % numbers.size()], numbers[random() % numbers.size()]);
  });
}

TEST_F(RandomKinds, AWrongDigitIsFound) {
  expect_found(20262, [](std::vector<std::string>& numbers, Random& random) {
    std::string& number = numbers[random() % numbers.size()];
    char& digit = number[random() % number.size()];
    if (is_digit(digit))
      digit = static_cast<char>('0' + (digit - '0' + 1 + static_cast<int>(random() % 9)) % 10);
  });
}

}  // namespace
}  // namespace shadefit::lint
