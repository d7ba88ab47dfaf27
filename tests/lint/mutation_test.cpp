#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "lint/lint_tree.hpp"
#include "lint/scan/characters.hpp"
#include "tests/lint/all_known.hpp"

/// Each digit of each published constant, changed once in generated code.
namespace shadefit::lint {
namespace {

/// A formula as a program has it; empty if it has more than operations and usual functions.
std::string code_of(const Symbolic& formula) {
  using Kind = Symbolic::Kind;
  std::vector<std::string> parts;
  for (const Symbolic& part : formula.parts()) {
    parts.push_back(code_of(part));
    if (parts.back().empty()) return "";
  }
  const auto joined = [&](const char* sign) { return "(" + parts[0] + sign + parts[1] + ")"; };
  switch (formula.kind()) {
    case Kind::variable:
      return formula.name();
    case Kind::number:
      return formula.name();
    case Kind::constant:
      return formula.name() == "pi" ? "PI" : "0.69314718055994531";
    case Kind::add:
      return joined(" + ");
    case Kind::subtract:
      return joined(" - ");
    case Kind::multiply:
      return joined(" * ");
    case Kind::divide:
      return joined(" / ");
    case Kind::negate:
      return "(-" + parts[0] + ")";
    case Kind::real_power:
      return "pow(" + parts[0] + ", " + parts[1] + ")";
    case Kind::integer_power:
      return "pow(" + parts[0] + ", " + formula.name() + ")";
    case Kind::choice:
      return "(" + parts[0] + " < " + parts[1] + " ? " + parts[2] + " : " + parts[3] + ")";
    case Kind::function:
      return fmt::format("{}({})", formula.name(), fmt::join(parts, ", "));
    case Kind::integral:
      return "";
  }
  return "";
}

/// A function with the form of a set and its constants as published.
std::string code_of(const KnownSet& set) {
  return "float f() {\n  return " +
         code_of(evaluate<Symbolic>(set.formula,
                                    [&](const std::string& name) {
                                      for (const KnownConstant& constant : set.constants)
                                        if (constant.name == name) return Symbolic::number(constant.printed);
                                      return Symbolic::variable(name);
                                    })) +
         ";\n}\n";
}

std::string name_of(const KnownSet& set) {
  return set.form.empty() ? set.id : set.id + " " + set.form;
}

/// How many changes were made, and how many of them lint noticed.
struct Noticed {
  std::size_t changes = 0, noticed = 0;
};

/// Changes each digit of each number of a code that lint knows, one at a time.
Noticed change_digits(const std::string& code, const KnownConstants& known) {
  const auto sites_in = [&](const std::string& text) {
    return lint_source("a.glsl", text, SourceLanguage::glsl, known, {});
  };
  Noticed count;
  for (const LintedSite& site : sites_in(code)) {
    for (const LintedNumber& number : site.numbers) {
      // Of fewer digits, too many numbers are near: they are found by the expression alone.
      if (digits_of(number.published).text.size() < least_digits_to_vary) continue;
      for (std::size_t i = 0; i < number.text.size(); ++i) {
        if (!is_digit(number.text[i])) continue;
        std::string other = code;
        char& digit = other[number.offset + i];
        digit = static_cast<char>('0' + (digit - '0' + 5) % 10);
        const std::vector<LintedSite> found = sites_in(other);
        ++count.changes;
        if (std::any_of(found.begin(), found.end(),
                        [](const LintedSite& one) { return one.grade >= Grade::typo; }))
          ++count.noticed;
      }
    }
  }
  return count;
}

TEST(LintMutation, AChangedDigitIsNoticed) {
  const KnownConstants known = all_known();
  constexpr std::size_t most_constants = 8;  // the others take most of the time and tell nothing new
  std::size_t sets = 0;
  std::vector<std::string> silent, unnoticed;
  Noticed all;
  for (const KnownSet& set : known.sets) {
    if (set.constants.size() > most_constants || !set.times.empty()) continue;
    const std::string code = code_of(set);
    ++sets;
    if (lint_source("a.glsl", code, SourceLanguage::glsl, known, {}).empty()) silent.push_back(name_of(set));
    const Noticed one = change_digits(code, known);
    if (one.noticed < one.changes)
      unnoticed.push_back(fmt::format("{} ({} of {})", name_of(set), one.changes - one.noticed, one.changes));
    all.changes += one.changes;
    all.noticed += one.noticed;
  }
  std::cout << fmt::format(
      "{} sets, {} of them not found: {}\n{} digits changed, {} noticed; not all in: {}\n", sets,
      silent.size(), fmt::join(silent, ", "), all.changes, all.noticed, fmt::join(unnoticed, ", "));
  // Not noticed: digits behind those of a float, and numbers that stand twice in a form.
  EXPECT_GT(static_cast<double>(all.noticed), 0.9 * static_cast<double>(all.changes));
  // Not found: sets of constants with one or two digits whose form is as simple as others.
  EXPECT_LE(silent.size(), 12u);
}

}  // namespace
}  // namespace shadefit::lint
