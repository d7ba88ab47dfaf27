#include "fit/proof/enclosure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fit/families/families.hpp"
#include "fit/family_visit.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

/// The error of a family in any scalar, at constants given by text.
template <class F>
auto error_of(const F& family, const std::array<const char*, F::parameters.size()>& texts) {
  return [=]<class T>(const Cosine<T>& c) {
    std::array<T, F::parameters.size()> p;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = constant<T>(texts[i]);
    return family.error(family.sample(c), p);
  };
}

const FresnelQuadratic quadratic{};
const std::array pair_texts{"-5.55473", "-6.98316"};

/// 50 digits of the published pair's largest error, as tests/fit/errors/extremum_test.cpp has it.
const Decimal50 pair_error("3.7664127395073188128e-3");

TEST(Enclosure, HoldsThePublishedPairAtEveryWidth) {
  std::size_t boxes = 0;
  for (const double width : {1e-3, 1e-9, 1e-12, least_width}) {
    const Enclosure found = enclose_largest(error_of(quadratic, pair_texts), {}, {.width = width});
    EXPECT_TRUE(found.is_reached) << width;
    EXPECT_LE(Decimal50(found.lower), pair_error);
    EXPECT_GE(Decimal50(found.upper), pair_error);
    EXPECT_LE(found.upper - found.lower, width * found.lower);
    ASSERT_EQ(found.places.size(), 1u);
    EXPECT_LE(found.places[0].lower, 0.05535716799228337);
    EXPECT_GE(found.places[0].upper, 0.05535716799228337);
    EXPECT_GT(found.boxes.size(), boxes) << "a narrower one needs more";
    boxes = found.boxes.size();
  }
  EXPECT_LT(boxes, 400u) << "the mean-value form converges with the square of a box";
}

/// Sampled at 50 digits, as often on either side of c = 1/2: no error exceeds the upper bound, none outside
/// of the places the lower one.
template <class F>
void expect_no_sample_above(const F& family, const std::array<const char*, F::parameters.size()>& texts,
                            int samples) {
  const auto error = error_of(family, texts);
  const Enclosure found = enclose_largest(error, {});
  ASSERT_TRUE(found.is_reached);
  Decimal50 largest = 0;
  for (const Origin side : {Origin::horizon, Origin::peak}) {
    for (int i = 0; i <= samples; ++i) {
      const double distance = 0.5 * i / samples;
      const Decimal50 magnitude = abs(error(cosine_at(side, Decimal50(distance))));
      ASSERT_LE(magnitude, Decimal50(found.upper)) << distance;
      if (!is_inside({side, distance}, found.places)) {
        ASSERT_LE(magnitude, Decimal50(found.lower)) << distance;
      }
      if (magnitude > largest) largest = magnitude;
    }
  }
  // A sample is within half a step of the largest error, which is flat there.
  EXPECT_GE(largest, Decimal50(found.lower) * Decimal50("0.999"));
}

TEST(Enclosure, ContainsSampledErrorsAtFiftyDigits) {
#ifdef SHADEFIT_SANITIZE
  constexpr int on_a_side = 2000;  // fifty digits take ten times as long there
#else
  constexpr int on_a_side = 500000;
#endif
  expect_no_sample_above(quadratic, pair_texts, on_a_side);
  expect_no_sample_above(FresnelOneTerm{}, {"8.35"}, 2000);
}

TEST(Enclosure, BoxesCoverTheDomainWithoutAGap) {
  for (const Domain domain :
       {Domain{0, 1}, Domain{0.25, 1}, Domain{0.7, 0.9}, Domain{0.1, 0.3}, Domain{0, 0.5}}) {
    const Enclosure found = enclose_largest(error_of(quadratic, pair_texts), domain);
    ASSERT_TRUE(found.is_reached) << to_text(domain);
    const auto start = [](const Box& box) { return box.side == Origin::horizon ? box.lower : 1 - box.upper; };
    const auto end = [](const Box& box) { return box.side == Origin::horizon ? box.upper : 1 - box.lower; };
    EXPECT_EQ(start(found.boxes.front()), domain.lower);
    EXPECT_EQ(end(found.boxes.back()), domain.upper);
    for (std::size_t i = 0; i + 1 < found.boxes.size(); ++i)
      EXPECT_EQ(end(found.boxes[i]), start(found.boxes[i + 1])) << to_text(domain);
    EXPECT_TRUE(is_inside(found.attained, found.boxes));
  }
}

TEST(Enclosure, SharpAndBluntLobes) {
  for (const double k : {0.1, 1.0, 37.5, 1e6}) {
    const SgOffset family{{k}};
    const auto error = error_of(family, {"0.775"});
    const Enclosure found = enclose_largest(error, {});
    EXPECT_TRUE(found.is_reached) << k;
    EXPECT_LT(found.boxes.size(), 150u) << k;
    const auto seen = largest_magnitude(error, Substitution::panels({}, family.shape().for_search()));
    EXPECT_GE(seen.magnitude, found.lower * (1 - 1e-9)) << k;
    EXPECT_LE(seen.magnitude, found.upper * (1 + 1e-13)) << k << ": the search in doubles rounds";
  }
}

TEST(Enclosure, AHintChangesNoBound) {
  const auto error = error_of(quadratic, pair_texts);
  const Enclosure wrong = enclose_largest(error, {}, {.hint = ExactPlace{Origin::peak, 0.25}});
  const Enclosure outside = enclose_largest(error, Domain{0, 0.5}, {.hint = ExactPlace{Origin::peak, 0.25}});
  const Enclosure none = enclose_largest(error, {});
  EXPECT_EQ(wrong.upper, none.upper);
  EXPECT_EQ(outside.attained.side, Origin::horizon);
}

TEST(Enclosure, WhatIsNotBoundedSaysSo) {
  const auto pole = []<class T>(const Cosine<T>& c) { return T(integer<T>(1) / c.cos_theta); };
  const Enclosure found = enclose_largest(pole, {}, {.boxes = 200});
  EXPECT_FALSE(found.is_reached);
  EXPECT_TRUE(std::isinf(found.upper));
  const auto nothing = []<class T>(const Cosine<T>&) { return integer<T>(0); };
  const Enclosure zero = enclose_largest(nothing, {});
  EXPECT_TRUE(zero.is_reached);
  EXPECT_EQ(zero.upper, 0);
}

TEST(Enclosure, AKinkIsNoObstacle) {
  // | |c - 1/3| - 1/8 |: largest at c = 1, smallest at two places, with a kink between them.
  const auto kink = []<class T>(const Cosine<T>& c) {
    const T x = c.cos_theta - integer<T>(1) / integer<T>(3);
    return T(max(x, T(-x)) - integer<T>(1) / integer<T>(8));
  };
  const Enclosure found = enclose_largest(kink, {});
  EXPECT_TRUE(found.is_reached);
  EXPECT_LE(found.lower, 13.0 / 24);
  EXPECT_GE(found.upper, 13.0 / 24);
}

}  // namespace
}  // namespace shadefit
