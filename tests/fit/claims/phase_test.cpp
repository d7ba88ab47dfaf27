#include "approx/phase.hpp"

#include "fit/quadrature/integrate.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

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
