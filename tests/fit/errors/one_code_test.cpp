#include "fit/errors/effect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "approx/encoding.hpp"

namespace shadefit {
namespace {

// White becomes 254: 1.055 x^(1/2.4) - 0.055 = 254/255 solved for x by hand.
TEST(OneCode, IsWhatMovesWhite) {
  const double white_to_254 = std::pow((254.0 / 255 + 0.055) / 1.055, 2.4);
  EXPECT_NEAR(change_of_one_code(), 1 - white_to_254, 1e-12);
}

TEST(OneCode, MovesNoGreyFurther) {
  const double change = change_of_one_code();
  double most = 0;
  for (int i = 1; i <= 4096; ++i) {
    const double grey = i / 4096.0;
    most = std::max(most, srgb_code(grey) - srgb_code(grey * (1 - change)));
  }
  EXPECT_NEAR(most, 1, 1e-9);
}

}  // namespace
}  // namespace shadefit
