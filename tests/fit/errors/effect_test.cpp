#include "fit/errors/effect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"

namespace shadefit {
namespace {

TEST(HalfUlp, AtPowersOfTwoAndInTheSubnormals) {
  EXPECT_EQ(ulp_of_half(1), 0x1p-10);
  EXPECT_EQ(ulp_of_half(1.999), 0x1p-10);
  EXPECT_EQ(ulp_of_half(0.999), 0x1p-11);
  EXPECT_EQ(ulp_of_half(-1), 0x1p-10);
  EXPECT_EQ(ulp_of_half(0x1p-14), 0x1p-24);
  EXPECT_EQ(ulp_of_half(0x1p-15), 0x1p-24);
  EXPECT_EQ(ulp_of_half(0), 0x1p-24);
}

Effect effect(std::vector<double> from, std::vector<double> to) {
  return find_family("fresnel-quadratic")->effect(0, {}, from, to);
}

// The two mistyped copies in circulation, as measured on a dense grid: 3.7e-6 and 6.5e-7.
TEST(Effect, OfTheMistypedCopies) {
  const auto first = effect({-5.55473, -6.98316}, {-5.55437, -6.98316});
  EXPECT_NEAR(first.absolute.magnitude, 3.73e-6, 1e-8);
  EXPECT_LT(first.srgb_codes, 0.002);
  EXPECT_LT(first.half_ulps, 0.5);
  const auto second = effect({-5.55473, -6.98316}, {-5.55473, -6.983146});
  EXPECT_NEAR(second.absolute.magnitude, 6.49e-7, 1e-9);
}

TEST(Effect, NoneAndLarge) {
  EXPECT_EQ(effect({-5, -7}, {-5, -7}).absolute.magnitude, 0);
  EXPECT_EQ(effect({-5, -7}, {-5, -7}).srgb_codes, 0);
  // exp2(0) = 1 everywhere: the change is 1 - f, largest at c = 1, all 255 codes but the last
  const auto large = effect({-5, -7}, {0, 0});
  EXPECT_NEAR(large.absolute.magnitude, 1 - std::exp2(-12.0), 1e-15);
  EXPECT_EQ(words(large.absolute.at), "c = 1");
  EXPECT_GT(large.srgb_codes, 254);
  EXPECT_GT(large.relative.magnitude, 200) << "where the curve was one code";
}

Coordinates at(double x) {
  return {{"x = ", x}};
}

// By hand: 0.5 -> 0.6 is the largest step, 0.01 -> 0.02 the largest part, 2^-5 is worth 64 ulps of 2^-11.
TEST(Effect, KeepsEachLargestWithItsOwnPlace) {
  Effect effect;
  effect.show(0.5, 0.6, at(1));
  effect.show(0.01, 0.02, at(2));
  effect.show(1.0 / 255 - 1e-9, 0.01, at(3));  // not as large as `visible`
  EXPECT_NEAR(effect.absolute.magnitude, 0.1, 1e-15);
  EXPECT_EQ(words(effect.absolute.at), "x = 1");
  EXPECT_NEAR(effect.relative.magnitude, 1, 1e-15);
  EXPECT_EQ(words(effect.relative.at), "x = 2");
  Effect ulps;
  ulps.show(0.5, 0.5 + 0x1p-5, at(1));
  EXPECT_EQ(ulps.half_ulps, 64);
}

TEST(Effect, OfEqualChangesTheFirstIsKept) {
  Effect effect;
  effect.show(0.5, 0.6, at(1));
  effect.show(0.5, 0.6 + 1e-12, at(2));
  EXPECT_EQ(words(effect.absolute.at), "x = 1");
  effect.show(0.5, 0.6 + 1e-8, at(3));
  EXPECT_EQ(words(effect.absolute.at), "x = 3");
}

TEST(Effect, IncludesAnother) {
  Effect one, other;
  one.show(0.5, 0.6, at(1));
  other.show(0.5, 0.7, at(2));
  one.include(other, {"k = ", 4});
  EXPECT_EQ(words(one.absolute.at), "x = 2, k = 4");
  one.include(Effect{});
  EXPECT_EQ(words(one.absolute.at), "x = 2, k = 4");
  EXPECT_TRUE(one.reaches_visible);
}

TEST(Effect, SaysWhereInFewDigits) {
  EXPECT_EQ(words({{"c = ", 0.28449}}), "c = 0.284");
  EXPECT_EQ(words({{"code ", 255}}), "code 255");
  EXPECT_EQ(words({{"k = ", 65504}}), "k = 65504");
  EXPECT_EQ(words({{"light ", 82, " degrees from n"}, {"azimuth ", 176.25, " degrees"}}),
            "light 82 degrees from n, azimuth 176 degrees");
  EXPECT_EQ(words(at_cosine({0.9969, 0.0031})), "c = 1 - 0.0031");
  EXPECT_EQ(words(at_cosine({0.99, 0.01})), "c = 0.99");
  EXPECT_EQ(words(at_cosine({1, 0})), "c = 1");
}

// 255 codes from black to white; 1 is worth 1024 of the ulps of 1 and 2^24 of those of 0.
TEST(Effect, IsOneSentence) {
  Effect effect;
  EXPECT_EQ(sentence(effect), "none");
  effect.show(0.3, 0.3, at(1));
  EXPECT_EQ(sentence(effect), "none");
  effect.show(1, 0, at(2));
  EXPECT_EQ(
      sentence(effect, "white", "black paint"),
      "black paint moves white by up to 255 codes of 8-bit sRGB (absolute: 1 at x = 2; relative: 1 at x = 2; "
      "half float: 1e+03 ulps)");
  Effect dark;
  dark.show(0, 0x1p-24, at(3));
  EXPECT_EQ(
      sentence(dark),
      "moves the curve by up to 0.0002 codes of 8-bit sRGB (absolute: 6e-08 at x = 3; relative: none, as no "
      "value reaches 1/255; half float: 1 ulp)");
  dark.show(0.5, 0.5, at(4));
  EXPECT_NE(sentence(dark).find("relative: 0 for values from 1/255 on"), std::string::npos) << sentence(dark);
}

TEST(Effect, BeyondADouble) {
  Effect effect;
  effect.show(1, std::numeric_limits<double>::infinity(), at(5));
  effect.show(1, 0.5, at(6));
  EXPECT_EQ(sentence(effect), "moves the curve beyond the range of a double (at x = 5)");
  effect.show(std::nan(""), 1, at(7));
  EXPECT_EQ(sentence(effect), "moves the curve beyond the range of a double (at x = 7)");
}

TEST(Effect, SentencesLeaveOutNone) {
  EXPECT_EQ(sentences({"a", "none", "b"}), "a. b");
  EXPECT_EQ(sentences({"none", "none"}), "none");
  EXPECT_EQ(sentences({}), "none");
}

TEST(Effect, SentencesStartWithACapitalWhereTheyStartWithAWord) {
  EXPECT_EQ(sentences({"over k it is 1", "", "the rest is 2", "so, too", "exp(-1) is 3", "x = 4", "a2 is 5"}),
            "over k it is 1. The rest is 2. So, too. exp(-1) is 3. x = 4. a2 is 5");
}

}  // namespace
}  // namespace shadefit
