#include <algorithm>
#include <cmath>

#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

/// Bayer's matrix by its construction: each quarter is 4 times the smaller one plus an entry of (0 2; 3 1).
int rank_of(int row, int column, int size) {
  constexpr int of_two[2][2] = {{0, 2}, {3, 1}};
  const int half = size / 2;
  return size == 1 ? 0 : 4 * rank_of(row % half, column % half, half) + of_two[row / half][column / half];
}

TEST(Bayer, EveryEntryOfItsOwnMatricesIsInPlace) {
  const int known[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  for (const int size : {2, 4, 8}) {
    std::string matrix;
    for (int r = 0; r < size; ++r) {
      matrix += r == 0 ? "" : " /";
      for (int c = 0; c < size; ++c) {
        const int rank = rank_of(r, c, size);
        if (size == 4) {
          EXPECT_EQ(rank, known[r][c]);
        }
        matrix += (matrix.empty() ? "" : " ") + std::to_string(1.0 * rank / (size * size));
      }
    }
    EXPECT_EQ(computed_number(with_input(*find_claim("bayer-4x4"), "matrix", matrix), "of_bayer"),
              size * size);
  }
}

TEST(Bayer, WhatIsMissingIsLeftOver) {
  const Claim claim = with_input(*find_claim("bayer-4x4"), "matrix", "0 0.5 / 0.75 x");
  EXPECT_EQ(computed_number(claim, "left"), 0.25);
  EXPECT_EQ(computed_number(claim, "present"), 3);
  EXPECT_EQ(computed_number(claim, "row(place_of_x) + 10 column(place_of_x)"), 11);
}

/// The rms by brute force, for a march of so many steps from each offset: the middles of a million edges.
double rms_by_looking(int steps, const std::vector<double>& offsets) {
  constexpr int edges = 1'000'000;
  double squares = 0;
  for (int i = 0; i < edges; ++i) {
    const double edge = (i + 0.5) / edges;
    double lit = 0;
    for (const double offset : offsets) lit += std::clamp(std::ceil(edge * steps - offset), 0.0, 1.0 * steps);
    squares += std::pow(lit / (steps * static_cast<double>(offsets.size())) - edge, 2);
  }
  return std::sqrt(squares / edges);
}

TEST(March, ErrorsAreThoseOfLookingAtManyEdges) {
  const Claim of_twos = with_input(*find_claim("march-steps"), "matrix", "0 0.5 / 0.75 x");
  const std::vector<double> offsets{0, 0.5, 0.75, 0.22};
  for (const char* steps : {"1", "3"}) {
    const Claim claim = with_printed(with_printed(of_twos, 1, steps), 2, steps);
    const int n = std::stoi(steps);
    double squares = 0;  // before the blur: each pixel for itself
    for (const double offset : offsets) squares += std::pow(rms_by_looking(n, {offset}), 2) / 4;
    EXPECT_NEAR(computed_number(claim, "rms"), rms_by_looking(n, offsets), 1e-6);
    EXPECT_NEAR(computed_number(claim, "before"), std::sqrt(squares), 1e-6);
    EXPECT_NEAR(computed_number(claim, "plain_rms"), rms_by_looking(n, {0}), 1e-6);
    EXPECT_LT(computed_number(claim, "max(doubt, plain_doubt)"), 1e-12);
    // 3 lit of 4 from 0.5 on, and at 0.22 half of them: 0.5 - 0.22 is the largest
    EXPECT_NEAR(computed_number(claim, "largest"), 0.28 / n, 1e-15);
  }
  // A complete set of sixteenths is a march of sixteen times the steps.
  const Claim& printed = *find_claim("march-steps");
  EXPECT_NEAR(computed_number(printed, "right_rms"), 1 / (160 * std::sqrt(3)), 1e-14);
  EXPECT_NEAR(computed_number(printed, "right_largest"), 1 / 160.0, 1e-14);
}

TEST(March, MoreStepsCanBeWorseAtOneEdge) {
  const auto share = [](const char* steps) {
    return computed_number(with_printed(*find_claim("march-steps"), 0, steps), "worst_share");
  };
  EXPECT_EQ(share("5 10"), 0) << "every old place is asked again";
  EXPECT_DOUBLE_EQ(share("10 15"), 1.0 / 6);  // of each fifth of the ray the third of six parts
  EXPECT_DOUBLE_EQ(share("75 100"), 0.25);    // of each 25th parts 4, 7 and 8 of twelve
}

}  // namespace
}  // namespace shadefit
