#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bench/forms/float_errors.hpp"

namespace shadefit::bench {
namespace {

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

TEST(FloatSteps, CountsFloatsBetweenKnownPairs) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(float_steps(1, 1), 0U);
  EXPECT_EQ(float_steps(1, std::nextafter(1.0F, 2.0F)), 1U);
  EXPECT_EQ(float_steps(std::nextafter(1.0F, 0.0F), std::nextafter(1.0F, 2.0F)), 2U)
      << "across a power of two";
  EXPECT_EQ(float_steps(0.0F, -0.0F), 0U);
  EXPECT_EQ(float_steps(tiny, -tiny), 2U) << "across zero";
  EXPECT_EQ(float_steps(0, tiny), 1U);
  EXPECT_EQ(
      float_steps(std::numeric_limits<float>::min(), std::nextafter(std::numeric_limits<float>::min(), 0.0F)),
      1U)
      << "the largest subnormal is beside the least normal";
  EXPECT_EQ(float_steps(1, 2), 1U << 23);
  EXPECT_EQ(float_steps(0, 1), 0x3f800000U);
  EXPECT_EQ(float_steps(-1, 1), 2 * 0x3f800000U);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(float_steps(-infinity, infinity), 2 * 0x7f800000U);
}

TEST(Exhaustive, TheWholeHasEveryFloatOfTheUnitInterval) {
  EXPECT_EQ(unit_floats.size(), 1'065'353'217U);
}

/// (1-c)^5 in float by multiplications, with a few inputs that go wrong.
FloatSubject schlick_with_faults() {
  return {[](const float* in, float* out, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
              const float y = 1 - in[i], y2 = y * y;
              out[i] = y2 * y2 * y;
              if (bits(in[i]) % 1000 == 7) out[i] = std::numeric_limits<float>::quiet_NaN();
              if (bits(in[i]) % 1000 == 8) out[i] = 1.5F;
              if (bits(in[i]) % 1000 == 9) out[i] = -out[i];
            }
          },
          [](const float* in, double* out, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) out[i] = std::pow(1 - static_cast<double>(in[i]), 5);
          }};
}

/// The same by a simple loop over the floats.
FloatErrors by_hand(const FloatSubject& subject, const Stretch& stretch) {
  FloatErrors found;
  double largest = 0;
  std::int64_t most = 0;
  for (std::uint32_t at = stretch.from; at < stretch.to; ++at) {
    std::array<float, 64> in{}, out{};
    std::array<double, 64> truth{};
    in.fill(std::bit_cast<float>(at));
    subject.form(in.data(), out.data(), in.size());
    subject.truth(in.data(), truth.data(), in.size());
    if (std::isnan(out[0])) {
      ++found.nans;
      continue;
    }
    if (out[0] > 1) ++found.above_one;
    if (out[0] < 0) ++found.below_zero;
    const double error = static_cast<float>(std::abs(out[0] - truth[0]));
    if (error > largest) {
      largest = error;
      found.max_abs_error = static_cast<float>(error);
      found.max_abs_error_at = at;
    }
    // Steps counted by nextafter, if they are few.
    const float wanted = static_cast<float>(truth[0]);
    std::int64_t steps = 0;
    for (float x = out[0]; x != wanted && steps < 1000; ++steps) x = std::nextafter(x, wanted);
    if (steps >= 1000) steps = float_steps(out[0], wanted);
    if (steps > most) {
      most = steps;
      found.max_ulps = static_cast<std::uint32_t>(steps);
      found.max_ulps_at = at;
    }
    std::size_t bin = 0;
    while (steps >> bin != 0) ++bin;
    ++found.ulps.at(bin);
  }
  return found;
}

TEST(Exhaustive, FindsWhatALoopByHandFinds) {
  const FloatSubject subject = schlick_with_faults();
  // Before and after a block's end, one float alone, none, the end of the whole, several threads.
  for (const Stretch& stretch : {Stretch{bits(0.5F) - 1500, bits(0.5F) + 1700},
                                 {bits(0.25F), bits(0.25F) + 1},
                                 {bits(0.25F), bits(0.25F)},
                                 {bits(0.25F), bits(0.25F) + 1024},
                                 {unit_floats.to - 3000, unit_floats.to},
                                 {0, 2100},
                                 {bits(0.5F), bits(0.5F) + (1U << 19) + 5}}) {
    const FloatErrors wanted = by_hand(subject, stretch), found = errors_on(subject, stretch);
    EXPECT_EQ(found, wanted) << stretch.from;
    EXPECT_EQ(found.count(), stretch.size());
  }
}

// Results beyond a bound are counted, and the first of their places kept.
TEST(Exhaustive, NotesWhatIsBeyondItsBound) {
  FloatSubject subject = schlick_with_faults();
  subject.bound = [](const float* in, double* middle, double* radius, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      middle[i] = std::pow(1 - static_cast<double>(in[i]), 5);
      radius[i] = 1e-6;
    }
  };
  const Stretch stretch{0, 3'000'000};
  const FloatErrors found = errors_on(subject, stretch);
  EXPECT_EQ(found.nans, 3000U);
  EXPECT_EQ(found.beyond, 9000U) << "NaN, 1.5 and what is negative";
  EXPECT_EQ(found.beyond_at, (std::vector<std::uint32_t>{7, 8, 9, 1007, 1008, 1009, 2007, 2008}));
}

TEST(Exhaustive, WhatAThreadThrowsIsThrown) {
  FloatSubject subject = schlick_with_faults();
  subject.truth = [](const float* in, double*, std::size_t) {
    if (bits(in[0]) > 5000) throw std::runtime_error("no truth");
  };
  EXPECT_THROW(errors_on(subject, Stretch{0, 10000}), std::runtime_error);
}

}  // namespace
}  // namespace shadefit::bench
