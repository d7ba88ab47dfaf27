#include "approx/phong_blinn.hpp"

#include "fit/scalars/multiprecision.hpp"
#include "fit/support/decimal.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"
#include "tests/fit/ledger/vector.hpp"

namespace shadefit {
namespace {

using testing::dot;
using testing::Vector;

// The best x falls from its value at blunt lobes to 4 at sharp ones: 4.2 came without its exponent, so that
// any number that x takes is right for some. What a changed digit changes is for which: no two overlap, each
// begins where the next larger one ends.
TEST(PhongBlinnClaims, EachDigitHasItsOwnExponents) {
  const Claim& claim = *find_claim("phong-blinn-factor");
  const auto range_of = [&](std::string_view printed) {
    const Finding finding = evaluate(with_printed(claim, 1, printed));
    EXPECT_EQ(finding.verdict, Verdict::conditional) << printed;
    const std::string& text = finding.computed;
    const std::string before = "the best number, rounded, for k from ";
    const auto at = text.find(before);
    if (at == std::string::npos) ADD_FAILURE() << text;
    return text.substr(at + before.size());
  };
  std::string end;
  for (const std::string_view printed : {"4.4", "4.3", "4.2", "4.1"}) {
    const std::string range = range_of(printed);
    const auto to = range.find(" to ");
    if (!end.empty()) {
      EXPECT_EQ(range.substr(0, to), end) << printed;
    }
    end = range.substr(to + 4);
  }
  for (const char* never : {"3.9", "3.2", "9.2"}) {
    const Finding finding = evaluate(with_printed(claim, 1, never));
    EXPECT_EQ(finding.verdict, Verdict::refuted) << never << ": " << finding.computed;
    EXPECT_NE(finding.computed.find("the best at no k"), std::string::npos);
  }
}

Vector direction(double from_normal, double azimuth) {
  const Decimal50 polar(from_normal), around(azimuth);
  return {sin(polar) * cos(around), sin(polar) * sin(around), cos(polar)};
}

/// Pairs of light and view over the hemisphere.
template <class Check>
void for_lights_and_views(const Check& check) {
  for (const double view : {0.1, 0.6, 1.2, 1.5}) {
    for (const double light : {0.0, 0.4, 1.0, 1.57}) {
      for (const double azimuth : {0.0, 0.7, 2.0, 3.1}) check(direction(light, azimuth), direction(view, 0));
    }
  }
}

TEST(PhongBlinnAngles, DifferByNoMoreThanTheirLaw) {
  double closest = 10;
  for_lights_and_views([&](const Vector& l, const Vector& v) {
    const Vector reflected{-l[0], -l[1], l[2]}, half{l[0] + v[0], l[1] + v[1], l[2] + v[2]};
    const Decimal50 phong = acos(dot(reflected, v)), blinn = acos(Decimal50(half[2] / sqrt(dot(half, half))));
    const Decimal50 excess = 2 * blinn - phong, most = 2 * asin(Decimal50(1 - v[2]));
    EXPECT_GE(excess, Decimal50(-1e-24));
    EXPECT_LE(excess, most);
    closest = std::min(closest, static_cast<double>(most - excess));
  });
  EXPECT_LT(closest, 0.1) << "no light came near it";
}

}  // namespace
}  // namespace shadefit
