#include "approx/fresnel.hpp"

#include "fit/ledger/where.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(Fresnel, ReflectanceOfGlossIsAMeanOfItsEnds) {
  for (const char* f0 : {"0", "0.04", "0.5", "1"}) {
    for (const char* gloss : {"0", "0.04", "0.7", "1"}) {
      for (const char* weight : {"0", "0.25", "1"}) {
        const Decimal50 f(f0), g(gloss), w(weight), top = f < g ? g : f;
        EXPECT_TRUE(testing::is_close(std::string(f0) + " " + gloss + " " + weight, f * (1 - w) + top * w,
                                      schlick_reflectance_of_gloss(f, g, w), 1e-48));
      }
    }
  }
}

TEST(Where, APartIsACondition) {
  EXPECT_EQ(verdict_of_cases(3, 3), Verdict::confirmed);
  EXPECT_EQ(verdict_of_cases(1, 3), Verdict::conditional);
  EXPECT_EQ(verdict_of_cases(0, 3), Verdict::refuted);
}

TEST(Where, FindsTheRangesAndTheirEnds) {
  std::vector<double> places;
  for (int i = 0; i <= 30; ++i) places.push_back(i / 30.0);
  const auto inside = where_positive([](double s) { return (s - 0.25) * (0.5 - s); }, places, 50);
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_NEAR(inside[0].from, 0.25, 1e-15);
  EXPECT_NEAR(inside[0].to, 0.5, 1e-15);
  const auto outside = where_positive([](double s) { return (s - 0.25) * (s - 0.5); }, places, 50);
  ASSERT_EQ(outside.size(), 2U);
  EXPECT_EQ(outside[0].from, 0);
  EXPECT_NEAR(outside[0].to, 0.25, 1e-15);
  EXPECT_NEAR(outside[1].from, 0.5, 1e-15);
  EXPECT_EQ(outside[1].to, 1);
  EXPECT_EQ(ranges_in_words(outside, 3), "from c = 0 to 0.25 and from c = 0.5 to 1");
  EXPECT_EQ(ranges_in_words(where_positive([](double) { return 0.0; }, places, 50), 3), "nowhere");
}

}  // namespace
}  // namespace shadefit
