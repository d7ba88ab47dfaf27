#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
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
#include "tests/lint/program.hpp"

/// Published forms in random languages and notations, with one slip or with harmless changes. The number of
/// programs is that of the environment variable SHADEFIT_RANDOM_LINT, or 50.
namespace shadefit::lint {
namespace {

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
  return formula.kind() == Symbolic::Kind::number && formula.name() == "1";
}

/// The formula without factors that are 1.
Symbolic without_ones(const Symbolic& formula) {
  std::vector<Symbolic> parts;
  for (const Symbolic& part : formula.parts()) parts.push_back(without_ones(part));
  if (formula.kind() == Symbolic::Kind::multiply)
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      if (is_one(parts[side])) return parts[1 - side];
  return formula.with_parts(std::move(parts));
}

/// A power of a variable to a constant with digits.
std::optional<Symbolic> inner_power(const Symbolic& formula) {
  if (formula.kind() == Symbolic::Kind::real_power && formula.part(0).kind() == Symbolic::Kind::variable &&
      formula.part(1).kind() == Symbolic::Kind::number)
    return formula;
  for (const Symbolic& part : formula.parts())
    if (auto power = inner_power(part)) return power;
  return std::nullopt;
}

class RandomKinds : public ::testing::Test {
 protected:
  RandomKinds() {
    if (const char* asked = std::getenv("SHADEFIT_RANDOM_LINT")) programs_ = std::atoi(asked);
    for (const KnownSet& set : known_here().sets) {
      constexpr std::size_t most_constants = 8;
      if (set.constants.size() > most_constants || set.constants.size() < 2) continue;
      Random plain(1);
      const std::string text =
          Program(dialects().front(), &plain).text(with_numbers(set, printed_numbers(set)), "x");
      const auto sites = lint_text(text);
      if (sites.size() == 1 && sites.front().id == set.id && sites.front().grade == Grade::right)
        sets_.push_back(&set);
    }
  }

  /// The worst grade that lint gives a program; `right` without a finding.
  Grade grade_of_program(const Dialect& dialect, const std::string& text) const {
    Grade worst = Grade::right;
    for (const LintedSite& site : lint_text(text, dialect.language)) worst = std::max(worst, site.grade);
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
      const std::string text = Program(dialect, &random).text(formula, set.axes.front().variable);
      const bool is_found = grade_of_program(dialect, text) >= Grade::typo;
      found += is_found ? 1 : 0;
      if (!is_found) missed += set.id + " " + set.form + "\n" + text;
    }
    std::cout << fmt::format("{} of {} found\n", found, planted);
    // Not found: what is no curve any more, as a maximum with 0 that is 0 everywhere.
    EXPECT_GE(found, 0.9 * planted) << missed;
  }

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
    const std::string text = Program(dialect, &random).text(formula, axis.variable);
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
