#include "bench/device/probe.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace shadefit::device {
namespace {

/// A device that is just as exact as assumed.
Probe usual() {
  Probe found;
  found.exp2.error = usual_gpu.exp2_ulps;
  found.log2.error = usual_gpu.log2_ulps;
  found.log2_near_one.error = usual_gpu.log2_near_one;
  return found;
}

TEST(ProbeAgainstUsual, NamesWhatIsCoarserThanAssumed) {
  const std::string exact =
      "exp2 is as exact as shadefit assumes of a GPU (4 ulp), log2 as exact as it assumes (3 ulp; 4.768e-07 "
      "for 1/2 .. 2)\n";
  EXPECT_EQ(against_usual(usual()), exact);

  for (const double error : {4.01, std::numeric_limits<double>::infinity()}) {
    Probe coarse = usual();
    coarse.exp2.error = error;
    EXPECT_EQ(against_usual(coarse),
              "exp2 is coarser than shadefit assumes of a GPU (4 ulp), log2 as exact as it assumes (3 ulp; "
              "4.768e-07 for 1/2 .. 2)\n");
  }
  for (LargestError Probe::*of_log2 : {&Probe::log2, &Probe::log2_near_one}) {
    Probe coarse = usual();
    (coarse.*of_log2).error *= 1.01;
    EXPECT_EQ(against_usual(coarse),
              "exp2 is as exact as shadefit assumes of a GPU (4 ulp), log2 coarser than it assumes (3 ulp; "
              "4.768e-07 for 1/2 .. 2)\n");
  }
}

}  // namespace
}  // namespace shadefit::device
