#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "lint/fixes.hpp"
#include "lint/lint_tree.hpp"
#include "lint/scan/characters.hpp"
#include "tests/lint/all_known.hpp"
#include "tests/lint/program.hpp"

/// Each digit of each published constant, changed once in generated code.
namespace shadefit::lint {
namespace {

/// A function with the form of a set and its constants as published.
std::string code_of(const KnownSet& set) {
  return Program(dialects().front()).text(with_numbers(set, printed_numbers(set)), "x");
}

std::string name_of(const KnownSet& set) {
  return set.form.empty() ? set.id : set.id + " " + set.form;
}

/// How many changes were made, how many of them lint noticed, and how many of those it undoes.
struct Noticed {
  std::size_t changes = 0, noticed = 0, undone = 0;
};

/// Whether fixes undo the change of one number. No fix may do anything else.
bool undoes(const std::vector<Fix>& fixes, const LintedNumber& number) {
  if (fixes.empty()) return false;
  EXPECT_EQ(fixes.size(), 1U);
  EXPECT_EQ(fixes.front().offset, number.offset);
  EXPECT_EQ(digits_of(fixes.front().after), digits_of(number.text)) << fixes.front().before;
  return true;
}

/// Changes each digit of each number of a code that lint knows, one at a time.
Noticed change_digits(const std::string& code) {
  Noticed count;
  for (const LintedSite& site : lint_text(code)) {
    for (const LintedNumber& number : site.numbers) {
      // Of fewer digits, too many numbers are near: they are found by the expression alone.
      if (digits_of(number.published).text.size() < least_digits_to_vary) continue;
      for (std::size_t i = 0; i < number.text.size(); ++i) {
        if (!is_digit(number.text[i])) continue;
        std::string other = code;
        char& digit = other[number.offset + i];
        digit = static_cast<char>('0' + (digit - '0' + 5) % 10);
        const std::vector<LintedSite> found = lint_text(other);
        ++count.changes;
        if (std::none_of(found.begin(), found.end(),
                         [](const LintedSite& one) { return one.grade >= Grade::typo; }))
          continue;
        ++count.noticed;
        if (undoes(fixes_of(found, other, FixScope::typo), number)) ++count.undone;
      }
    }
  }
  return count;
}

TEST(LintMutation, AChangedDigitIsNoticed) {
  constexpr std::size_t most_constants = 8;  // the others take most of the time and tell nothing new
  std::size_t sets = 0;
  std::vector<std::string> silent, unnoticed;
  Noticed all;
  for (const KnownSet& set : known_here().sets) {
    if (set.constants.size() > most_constants) continue;
    const std::string code = code_of(set);
    ++sets;
    if (lint_text(code).empty()) silent.push_back(name_of(set));
    const Noticed one = change_digits(code);
    if (one.noticed < one.changes)
      unnoticed.push_back(fmt::format("{} ({} of {})", name_of(set), one.changes - one.noticed, one.changes));
    all.changes += one.changes;
    all.noticed += one.noticed;
    all.undone += one.undone;
  }
  std::cout << fmt::format(
      "{} sets, {} of them not found: {}\n{} digits changed, {} noticed, {} undone; not all noticed in: {}\n",
      sets, silent.size(), fmt::join(silent, ", "), all.changes, all.noticed, all.undone,
      fmt::join(unnoticed, ", "));
  // Not noticed: digits behind those of a float, and numbers that stand twice in a form.
  EXPECT_GT(static_cast<double>(all.noticed), 0.9 * static_cast<double>(all.changes));
  // Not undone: a number that may be of two sources, and what is noticed as a wrong operation.
  EXPECT_GT(static_cast<double>(all.undone), 0.98 * static_cast<double>(all.noticed));
  // Not found: sets of constants with one or two digits whose form is as simple as others.
  EXPECT_LE(silent.size(), 12u);
}

}  // namespace
}  // namespace shadefit::lint
