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
    if (set.constants.size() > most_constants || !set.times.empty()) continue;
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

// As in glTF viewers: vectors of several curves, in the units of the paper, and a matrix by columns.
TEST(LintMutation, AChangedDigitOfAThinFilmIsNoticed) {
  const std::string code = R"(
const mat3 toRgb = mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314, 0.0415560,
                        1.0572252);
vec3 sensitivity(float opd, vec3 shift) {
  float phase = 2.0 * PI * opd * 1.0e-9;
  vec3 v = vec3(5.4856e-13, 4.4201e-13, 5.2481e-13);
  vec3 p = vec3(1.6810e+06, 1.7953e+06, 2.2084e+06);
  vec3 s = vec3(4.3278e+09, 9.3046e+09, 6.6121e+09);
  vec3 xyz = v * sqrt(2.0 * PI * s) * cos(p * phase + shift) * exp(-phase * phase * s);
  xyz.x += 9.7470e-14 * sqrt(2.0 * PI * 4.5282e+09) * cos(2.2399e+06 * phase + shift.x) * exp(-4.5282e+09 * phase * phase);
  return toRgb * (xyz / 1.0685e-7);
}
)";
  EXPECT_EQ(lint_text(code).size(), 6U);
  const Noticed count = change_digits(code);
  EXPECT_GT(count.changes, 150U);
  // Zeros before other digits, in two numbers; and a last digit that becomes 0, which is a number of fewer
  // digits: once in the matrix, and once in each of three curves.
  EXPECT_LE(count.changes - count.noticed, 6U);
}

}  // namespace
}  // namespace shadefit::lint
