#include "approx/dither.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "fit/ledger/march.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

constexpr const char* matrix_of_twos = "0 0.5 / 0.75 x";

TEST(Bayer, RanksArePermutationsAndTheKnownMatrix) {
  const int known[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) EXPECT_EQ(bayer_rank(r, c, 4), known[r][c]) << r << " " << c;
  }
  for (const int size : {1, 2, 8, 16}) {
    std::set<int> ranks;
    for (int r = 0; r < size; ++r) {
      for (int c = 0; c < size; ++c) ranks.insert(bayer_rank(r, c, size));
    }
    EXPECT_EQ(static_cast<int>(ranks.size()), size * size);
    EXPECT_EQ(*ranks.rbegin(), size * size - 1);
  }
}

TEST(DitherMatrix, IsReadWithItsLetter) {
  EXPECT_EQ(dither_matrix(matrix_of_twos, 0.25), (std::vector<double>{0, 0.5, 0.75, 0.25}));
  EXPECT_EQ(missing_from({0, 0.5, 0.75, 0.3}), std::vector<double>{0.25});
  EXPECT_TRUE(missing_from({0.5, 0}).empty());
}

/// The rms by brute force: the middles of a million edges.
double rms_by_looking(const std::vector<double>& places) {
  constexpr int edges = 1'000'000;
  double squares = 0;
  for (int i = 0; i < edges; ++i) {
    const double edge = (i + 0.5) / edges;
    const auto lit = std::count_if(places.begin(), places.end(), [&](double s) { return s < edge; });
    const double error = static_cast<double>(lit) / static_cast<double>(places.size()) - edge;
    squares += error * error;
  }
  return std::sqrt(squares / edges);
}

TEST(March, ErrorIsThatOfLookingAtManyEdges) {
  const std::vector<double> offsets{0, 0.5, 0.22, 0.75};
  for (const int steps : {1, 3}) {
    const auto places = march_places(steps, offsets);
    const MarchError error = march_error(places);
    EXPECT_NEAR(error.rms, rms_by_looking(places), 1e-6);
    EXPECT_NEAR(error.rms_by_warnock, error.rms, 1e-12);
  }
  // 3 lit of 4 from 0.5 on, and at 0.22 half of them: 0.5 - 0.22 is the largest
  EXPECT_NEAR(march_error(offsets).largest, 0.28, 1e-15);
}

TEST(March, ClosedFormsAreTheSums) {
  for (const int steps : {1, 10, 75}) {
    EXPECT_NEAR(march_error(march_places(steps, {0})).rms, march_rms(1.0 * steps), 1e-14);
    for (const double offset : {0.22, 0.5, 0.9375})
      EXPECT_NEAR(march_error(march_places(steps, {offset})).rms, march_rms_at_offset(1.0 * steps, offset),
                  1e-14);
  }
  // A complete set of sixteenths is a march of sixteen times the steps.
  std::vector<double> sixteenths;
  for (int i = 0; i < 16; ++i) sixteenths.push_back((i * 7 % 16) / 16.0);
  EXPECT_NEAR(march_error(march_places(10, sixteenths)).rms, march_rms(160.0), 1e-14);
  EXPECT_NEAR(march_error(march_places(10, sixteenths)).largest, 1 / 160.0, 1e-14);
}

TEST(March, MoreStepsCanBeWorseAtOneEdge) {
  EXPECT_EQ(share_made_worse(5, 10), 0) << "every old place is asked again";
  EXPECT_DOUBLE_EQ(share_made_worse(10, 15), 1.0 / 6);  // of each fifth of the ray the third of six parts
  EXPECT_DOUBLE_EQ(share_made_worse(75, 100), 0.25);    // of each 25th parts 4, 7 and 8 of twelve
}

}  // namespace
}  // namespace shadefit
