#include "approx/von_mises_fisher.hpp"

#include <boost/math/constants/constants.hpp>

#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

using testing::is_close;

// By its antiderivative e^(k c)/k, with the sinh of another library.
TEST(VonMisesFisher, IntegratesToOneOverTheSphere) {
  for (const char* text : {"0.001", "1", "2", "100", "100000"}) {
    const Decimal50 k(text), pi_ = boost::math::constants::pi<Decimal50>();
    const Decimal50 whole = 4 * pi_ * boost::multiprecision::sinh(k) / k;  // of e^(k c) over the sphere
    const Decimal50 density = von_mises_fisher(Decimal50(0), k);           // its factor, e^0 being 1
    EXPECT_TRUE(is_close(text, Decimal50(1), density * whole, 1e-43));
  }
}

}  // namespace
}  // namespace shadefit
