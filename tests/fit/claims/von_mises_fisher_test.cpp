#include "approx/von_mises_fisher.hpp"

#include <boost/math/constants/constants.hpp>

#include "fit/scalars/multiprecision.hpp"
#include "fit/support/decimal.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

using testing::is_close;

// The robust form is the printed one, beyond where a double could hold e^k.
TEST(VonMisesFisher, BothFormsAreOne) {
  for (const char* k : {"0.001", "0.5", "2", "37", "700", "1000", "100000"}) {
    for (const char* y : {"0", "0.0001", "0.5", "1", "1.75", "2"}) {
      const Decimal50 concentration(k), distance(y);
      EXPECT_TRUE(is_close(std::string(k) + " " + y, von_mises_fisher(Decimal50(1 - distance), concentration),
                           von_mises_fisher_near_peak(distance, concentration), 1e-43));
    }
  }
}

TEST(VonMisesFisher, IsRightInDoubleForEveryConcentration) {
  for (const double k : {1e-300, 1e-6, 1e-3, 1.0, 709.0, 710.0, 1e5, 1e300}) {
    // k/sinh(k) -> 1, and the density goes to that of the whole sphere; for sharp lobes to k/(2 pi)
    const Decimal50 truth = Decimal50(k) / (2 * boost::math::constants::pi<Decimal50>() *
                                            -boost::multiprecision::expm1(Decimal50(Decimal50(k) * -2)));
    EXPECT_TRUE(is_close(std::to_string(k), truth, Decimal50(von_mises_fisher_near_peak(0.0, k)), 2e-15));
  }
}

// By its antiderivative e^(k c)/k, with the sinh of another library.
TEST(VonMisesFisher, IntegratesToOneOverTheSphere) {
  for (const char* text : {"0.001", "1", "2", "100", "100000"}) {
    const Decimal50 k(text), pi_ = boost::math::constants::pi<Decimal50>();
    const Decimal50 whole = 4 * pi_ * boost::multiprecision::sinh(k) / k;  // of e^(k c) over the sphere
    const Decimal50 density = von_mises_fisher(Decimal50(0), k);           // its factor, e^0 being 1
    EXPECT_TRUE(is_close(text, Decimal50(1), density * whole, 1e-43));
  }
}

TEST(VonMisesFisher, TheErrorOfTheSharpFormIsAtEveryAngleTheSame) {
  for (const char* text : {"0.5", "2", "10", "20"}) {
    const Decimal50 k(text);
    for (const char* y : {"0", "0.3", "2"}) {
      const Decimal50 ratio =
          von_mises_fisher_sharp(Decimal50(y), k) / von_mises_fisher(Decimal50(1 - Decimal50(y)), k);
      EXPECT_TRUE(is_close(std::string(text) + " " + y, Decimal50(ratio - 1), von_mises_fisher_sharp_error(k),
                           1e-30));
    }
  }
  EXPECT_EQ(decimal(von_mises_fisher_sharp_error(2.0), 4), "-0.01832");
}

}  // namespace
}  // namespace shadefit
