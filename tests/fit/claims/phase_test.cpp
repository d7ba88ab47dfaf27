#include "approx/phase.hpp"

#include "fit/quadrature/integrate.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(HenyeyGreenstein, RobustFormIsThePlainOne) {
  for (const char* g : {"-0.999", "-0.5", "0", "0.2", "0.9", "0.9999"}) {
    for (const char* y : {"0", "1e-9", "0.001", "0.5", "1", "1.9", "2"}) {
      const Decimal100 G(g), Y(y);
      const Decimal100 plain = henyey_greenstein(Decimal100(1 - Y), G);
      EXPECT_LT(abs(henyey_greenstein_near_peak(Y, G) / plain - 1), Decimal100("1e-80")) << g << " " << y;
    }
  }
}

TEST(HenyeyGreenstein, ShareIsItsIntegral) {
  using Jet = ceres::Jet<double, 1>;
  for (const double g : {-0.9, 0.0, 0.5, 0.99}) {
    EXPECT_EQ(henyey_greenstein_within(0.0, g), 0);
    // at g = -0.9 the root of (1-g)^2 + 4g = 0.01 has lost three digits of sixteen
    EXPECT_NEAR(henyey_greenstein_within(2.0, g), 1, g < 0 ? 1e-13 : 1e-15) << g;
    for (const double y : {0.01, 0.3, 1.0, 1.7}) {
      const Jet share = henyey_greenstein_within(Jet(y, 0), Jet(g));
      const double density = 2 * pi<double>() * henyey_greenstein_near_peak(y, g);
      EXPECT_NEAR(share.v[0] / density, 1, 1e-12) << g << " " << y;
    }
  }
  // without g, the cap of height y has y/2 of the sphere
  EXPECT_NEAR(henyey_greenstein_within(0.5, 0.0), 0.25, 1e-16);
}

TEST(HenyeyGreenstein, MeanCosineIsG) {
  // What g is: the first moment, which no part of the normalisation says.
  for (const double g : {-0.5, 0.0, 0.3, 0.9}) {
    const auto moment = [g](double c) { return 2 * pi<double>() * c * henyey_greenstein(c, g); };
    EXPECT_NEAR(gauss_kronrod(moment, -1, 1, 1e-13).value, g, 1e-12) << g;
  }
}

TEST(HenyeyGreenstein, IsEvenWhenBothSignsTurn) {
  EXPECT_EQ(henyey_greenstein(0.25, 0.5), henyey_greenstein(-0.25, -0.5));
  EXPECT_NEAR(henyey_greenstein(0.7, 0.0), 1 / (4 * pi<double>()), 1e-17);
}

}  // namespace
}  // namespace shadefit
