#include "fit/bounds/cut_boxes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shadefit {
namespace {

const std::vector<Domain> unit_square{{0, 1}, {0, 1}};

/// A box below the middles of the unit square, and how far a form falls there.
JudgedBox judged(double x0, double x1, double y0, double y1, double amount) {
  return {{{false, x0, x1}, {false, y0, y1}}, amount, 0};
}

std::vector<bool> cut_along_x(const std::vector<JudgedBox>& boxes) {
  return lines_above(1, 0, unit_square)(boxes);
}

TEST(CutBoxes, ALineAddsUpTheBoxesThatItCrosses) {
  const JudgedBox left = judged(0, 0.25, 0, 0.5, 0.6), right = judged(0.25, 0.5, 0, 0.5, 0.6);
  EXPECT_EQ(cut_along_x({left, right}), (std::vector{true, true}));
  EXPECT_EQ(cut_along_x({left}), (std::vector{false}));
  const JudgedBox low = judged(0, 0.5, 0, 0.25, 0.6), high = judged(0, 0.5, 0.25, 0.5, 0.6);
  EXPECT_EQ(cut_along_x({low, high}), (std::vector{false, false})) << "no line crosses both";
  EXPECT_EQ(lines_above(1, 1, unit_square)(std::vector{low, high}), (std::vector{true, true}))
      << "but along y";
}

/// A wide box lies on many lines. One that is too long is enough.
TEST(CutBoxes, BoxesOfDifferentWidthsMeetOnSomeLines) {
  const JudgedBox wide = judged(0, 0.25, 0, 0.5, 0.6);
  const JudgedBox narrow = judged(0.25, 0.5, 0.25, 0.375, 0.6), other = judged(0.25, 0.5, 0, 0.25, 0.3);
  EXPECT_EQ(cut_along_x({wide, narrow, other}), (std::vector{true, true, false}));
  EXPECT_EQ(cut_along_x({wide, other}), (std::vector{false, false}));
}

/// The two sides of the variable itself are one line, those of the other variable are not.
TEST(CutBoxes, ALineGoesFromEndToEnd) {
  JudgedBox near = judged(0, 0.5, 0, 0.5, 0.6), far = near;
  far.box[0] = {true, -0.5, 0};
  EXPECT_EQ(cut_along_x({near, far}), (std::vector{true, true}));
  far = near;
  far.box[1] = {true, -0.5, 0};
  EXPECT_EQ(cut_along_x({near, far}), (std::vector{false, false}));
}

TEST(CutBoxes, WhatHasNoBoundIsCut) {
  EXPECT_EQ(cut_along_x({judged(0, 0.5, 0, 0.5, HUGE_VAL)}), (std::vector{true}));
  EXPECT_EQ(cut_along_x({judged(0, 0.5, 0, 0.5, std::nan(""))}), (std::vector{true}));
  EXPECT_EQ(each_above(1)(std::vector{judged(0, 0.5, 0, 0.5, std::nan(""))}), (std::vector{true}));
  EXPECT_EQ(each_above(1)(std::vector{judged(0, 0.5, 0, 0.5, 1)}), (std::vector{false}));
}

}  // namespace
}  // namespace shadefit
