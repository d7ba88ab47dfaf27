#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "fit/scalars/integral.hpp"
#include "tests/device/on_device.hpp"
#include "tests/forms_of_studies.hpp"

/// The forms of studies on a device.
namespace shadefit::device {
namespace {

/// In boxes of 2^-13 of the range of each variable.
DrawnInputs drawn_over(const std::vector<StudyAxis>& axes) {
  return drawn_in(
      [&](Sequence& sequence) {
        std::vector<Domain> box;
        for (const StudyAxis& axis : axes) {
          const double width = (axis.upper - axis.lower) * 0x1p-13;
          box.push_back(narrow_side(sequence.between(axis.lower, axis.upper - width), width));
        }
        return box;
      },
      1U << 14, 1U << 10);
}

/// A form with what its results must be.
struct Expected {
  explicit Expected(const testing::FormOfStudy& form)
      : inputs(drawn_over(form.read.axes)),
        values(values_at(inputs, form.function)),
        bounds(bounds_of(inputs, form.function, usual_gpu)) {}
  DrawnInputs inputs;
  std::vector<double> values, bounds;
};

/// The boxes whose bound says little: one with a choice between two formulas has none.
std::size_t count_vague(const Expected& expected) {
  double largest = 0;
  for (const double value : expected.values) largest = std::max(largest, std::abs(value));
  // sin and cos have a bound of 2^-11, a sum or a quotient of them more.
  const double vague = 0x1p-9 * largest;
  return static_cast<std::size_t>(std::count_if(expected.bounds.begin(), expected.bounds.end(),
                                                [&](double bound) { return bound > vague; }));
}

std::vector<testing::FormOfStudy> forms_with_code() {
  std::vector<testing::FormOfStudy> forms = testing::forms_of_studies();
  std::erase_if(forms, [](const auto& form) { return integral_depth(form.function.result) > 0; });
  return forms;
}

TEST_F(Device, RunsEveryStudyWithinTheBoundInBothLanguages) {
  for (const testing::FormOfStudy& form : forms_with_code()) {
    const Expected expected(form);
    // Near the horizon the air mass divides by a small sine.
    EXPECT_LE(count_vague(expected), expected.bounds.size() / 20) << form.function.name;
    for (const Language language : languages) {
      EXPECT_EQ(beyond(form.function, language, expected.inputs, expected.values, expected.bounds), "")
          << form.function.name << " in " << name(language);
    }
  }
}

/// The places of the digits of a number, from its first digit that is not 0. Of a zero: the last digit.
std::vector<std::size_t> digits_of(const std::string& printed) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const bool is_digit = printed[i] >= '0' && printed[i] <= '9';
    if (is_digit && !(places.empty() && printed[i] == '0')) places.push_back(i);
  }
  if (places.empty()) places.push_back(printed.find_last_of('0'));
  return places;
}

/// The second digit of a number, or the last of a shorter one, 5 more or less. The bounds hide later ones.
std::string with_wrong_second_digit(std::string printed) {
  constexpr std::size_t second = 1;
  const std::vector<std::size_t> digits = digits_of(printed);
  char& digit = printed[digits.at(std::min(second, digits.size() - 1))];
  digit = static_cast<char>(digit < '5' ? digit + 5 : digit - 5);
  return printed;
}

// In the first and in the last constant of each set; tests/gpu changes the others.
TEST_F(Device, FindsAWrongDigitInEveryStudy) {
  std::size_t count = 0;
  for (const testing::FormOfStudy& form : forms_with_code()) {
    if (!form.is_published) continue;
    const Expected expected(form);
    for (const std::size_t i : std::set<std::size_t>{0, form.constants.size() - 1}) {
      PrintedValues wrong = form.constants;
      wrong[i].second = with_wrong_second_digit(wrong[i].second);
      const testing::FormOfStudy other = testing::form_of_study(form.function.name, form.read, wrong);
      for (const Language language : languages) {
        EXPECT_NE(beyond(other.function, language, expected.inputs, expected.values, expected.bounds), "")
            << form.function.name << " with " << wrong[i].first << " = " << wrong[i].second << " in "
            << name(language);
      }
      ++count;
    }
  }
  EXPECT_GT(count, 100U);
}

}  // namespace
}  // namespace shadefit::device
