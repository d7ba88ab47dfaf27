#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lint/scan/digit_index.hpp"
#include "lint/scan/digit_match.hpp"
#include "tests/lint/all_known.hpp"

/// How a number agrees with a published one, and that the index finds each that does.
namespace shadefit::lint {
namespace {

std::optional<DigitMatch> match(std::string_view found, std::string_view published) {
  return match_digits(digits_of(found), digits_of(published));
}

TEST(DigitMatch, EachKindHasTwoSides) {
  EXPECT_EQ(match("0.5550", "0.555"), DigitMatch::same);
  EXPECT_EQ(match("5.554728", "5.55473"), DigitMatch::longer);
  EXPECT_EQ(match("5.554812", "5.55473"), std::nullopt);
  // A last zero is a digit.
  EXPECT_EQ(match("1.68104", "1.6810"), DigitMatch::longer);
  EXPECT_EQ(match("1.6811", "1.6810"), DigitMatch::edited);
  EXPECT_EQ(match("1.6810", "1.6810"), DigitMatch::same);
  EXPECT_EQ(match("1.681", "1.6810"), DigitMatch::same);
  EXPECT_EQ(match("5.5547", "5.55473"), DigitMatch::rounded);
  EXPECT_EQ(match("6.9832", "6.98316"), DigitMatch::rounded);  // rounded up
  EXPECT_EQ(match("6.9831", "6.98316"), DigitMatch::rounded);  // cut off
  EXPECT_EQ(match("6.9833", "6.98316"), std::nullopt);
  EXPECT_EQ(match("0.4045", "0.04045"), DigitMatch::shifted);
  EXPECT_EQ(match("0.722", "0.0722"), DigitMatch::shifted);
  EXPECT_EQ(match("0.55", "0.055"), std::nullopt);  // two digits are everywhere
}

TEST(DigitMatch, AUsualSlipIsASwapOrTheOtherDigitDoubled) {
  const auto is_slip = [](std::string_view found, std::string_view published) {
    return is_usual_slip(digits_of(found), digits_of(published));
  };
  EXPECT_TRUE(is_slip("0.578", "0.587"));
  EXPECT_TRUE(is_slip("0.857", "0.587"));
  EXPECT_TRUE(is_slip("0.229", "0.299"));
  EXPECT_TRUE(is_slip("0.144", "0.114"));
  EXPECT_TRUE(is_slip("0.1224", "0.1124"));
  EXPECT_FALSE(is_slip("0.587", "0.587"));
  EXPECT_FALSE(is_slip("5.78", "0.587"));
  EXPECT_FALSE(is_slip("0.557", "0.587"));  // no digit was double
  EXPECT_FALSE(is_slip("0.289", "0.299"));  // none is
  EXPECT_FALSE(is_slip("0.999", "0.299"));  // three
  EXPECT_FALSE(is_slip("0.110", "0.114"));
  EXPECT_FALSE(is_slip("0.1114", "0.114"));  // longer
}

TEST(DigitMatch, AnEditIsOneDigit) {
  EXPECT_EQ(match("6.98216", "6.98316"), DigitMatch::edited);   // replaced
  EXPECT_EQ(match("6.8316", "6.98316"), DigitMatch::edited);    // lost
  EXPECT_EQ(match("6.988316", "6.98316"), DigitMatch::edited);  // twice
  EXPECT_EQ(match("0.7125", "0.7152"), DigitMatch::edited);     // swapped
  EXPECT_EQ(match("6.97216", "6.98316"), std::nullopt);
  EXPECT_EQ(match("0.123", "0.124"), std::nullopt);  // three digits have too many neighbours
}

TEST(DigitMatch, TheSameFloatIsRightIfSomebodyPrintsIt) {
  EXPECT_EQ(match("0.30530601739883423", "0.305306011"), DigitMatch::float32);  // all its digits
  EXPECT_EQ(match("0.159301758", "0.1593017578125"), DigitMatch::float32);      // nine of them
  EXPECT_EQ(match("0.416666667", "0.41666666666666667"), DigitMatch::float32);  // fewer published digits
  // The same float, but a 7 was lost.
  EXPECT_EQ(static_cast<float>(0.159301758125), static_cast<float>(0.1593017578125));
  EXPECT_EQ(match("0.159301758125", "0.1593017578125"), DigitMatch::edited);
  EXPECT_EQ(match("0.15930175", "0.1593017578125"), DigitMatch::rounded);  // another float
}

TEST(DigitMatch, ShortenedHasBothSides) {
  EXPECT_TRUE(is_shortened(digits_of("0.0023"), digits_of("0.00232")));
  EXPECT_FALSE(is_shortened(digits_of("0.0024"), digits_of("0.00232")));
  EXPECT_FALSE(is_shortened(digits_of("0.00232"), digits_of("0.00232")));
}

/// All texts at one edit, but those with a leading zero: that moves the decimal point.
std::vector<Digits> neighbours_of(const Digits& digits) {
  std::vector<std::string> texts;
  const std::string& text = digits.text;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    for (char c = '0'; c <= '9'; ++c) {
      texts.push_back(text.substr(0, i) + c + text.substr(i));
      if (i < text.size() && text[i] != c) texts.push_back(text.substr(0, i) + c + text.substr(i + 1));
    }
    if (i < text.size()) texts.push_back(text.substr(0, i) + text.substr(i + 1));
    if (i + 1 < text.size()) texts.push_back(text.substr(0, i) + text[i + 1] + text[i] + text.substr(i + 2));
  }
  std::vector<Digits> neighbours;
  for (const std::string& edited : texts)
    if (edited.front() != '0')
      neighbours.push_back(digits_of(fmt::format("0.{}e{}", edited, digits.exponent)));
  std::erase_if(neighbours, [](const Digits& one) { return one.text.size() < 3; });
  return neighbours;
}

TEST(DigitIndex, FindsEachNeighbourOfEachPublishedNumber) {
  const KnownConstants& known = known_here();
  std::size_t looked = 0, missed = 0;
  for (std::size_t s = 0; s < known.sets.size(); ++s) {
    for (std::size_t c = 0; c < known.sets[s].constants.size(); ++c) {
      const KnownConstant& constant = known.sets[s].constants[c];
      const Digits digits = digits_of(constant.printed);
      if (constant.is_common || digits.text.size() < least_digits_to_vary) continue;
      for (const Digits& neighbour : neighbours_of(digits)) {
        const std::vector<NumberMatch> matches = known.index.find(neighbour);
        ++looked;
        const bool is_found = std::any_of(matches.begin(), matches.end(), [&](const NumberMatch& one) {
          return one.place == ConstantPlace{s, c};
        });
        if (is_found) continue;
        ++missed;
        ADD_FAILURE() << known.sets[s].id << " " << constant.printed << " as 0." << neighbour.text;
      }
    }
  }
  EXPECT_GT(looked, 10'000u);
  EXPECT_EQ(missed, 0u);
}

TEST(DigitIndex, ACommonNumberHasNoNeighbours) {
  const KnownConstants& known = known_here();  // 1.5707963 is pi/2
  EXPECT_FALSE(known.index.find(digits_of("1.5707963")).empty());
  EXPECT_TRUE(known.index.find(digits_of("1.5707863")).empty());
}

}  // namespace
}  // namespace shadefit::lint
