#include "approx/environment_map.hpp"

#include "approx/lobe.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"
#include "tests/fit/ledger/vector.hpp"

namespace shadefit {
namespace {

using testing::dot;
using testing::is_close;
using testing::Vector;

TEST(EnvironmentMapClaims, ThePrintedLoopDividesIntegers) {
  Claim claim = *find_claim("mip-gloss-chain");
  EXPECT_NE(evaluate(claim).evidence.find("2048 2048 2048 2048 2048 2"), std::string::npos);
  // Over one step the quotient of integers is the quotient.
  claim.printed = {{"", "2048"}, {"", "2"}};
  EXPECT_EQ(verdict_of(with_input(claim, "width", "8")), "confirmed");
  EXPECT_THROW(evaluate(with_input(claim, "width", "4")), std::invalid_argument);
}

TEST(EnvironmentMapClaims, ThePowerOfThePrintedDigits) {
  const Claim& claim = *find_claim("mip-mean-power");
  EXPECT_EQ(evaluate(claim).computed, "power = 16386");  // 4/log(1 + 4/128^2)
  EXPECT_NE(evaluate(claim).evidence.find("printed digits are those of a lobe that has fallen to e^-2"),
            std::string::npos);
}

// The solid angle of a triangle of directions a, b, c: tan(omega/2) = det(a, b, c) over
// |a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|.
// Source: Van Oosterom, Strackee 1983, "The Solid Angle of a Plane Triangle", IEEE Transactions on Biomedical
// Engineering 30, pp. 125-126.
Decimal50 triangle_solid_angle(const Vector& a, const Vector& b, const Vector& c) {
  const Decimal50 determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                a[2] * (b[0] * c[1] - b[1] * c[0]);
  const Decimal50 la = sqrt(dot(a, a)), lb = sqrt(dot(b, b)), lc = sqrt(dot(c, c));
  const Decimal50 below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return 2 * boost::multiprecision::atan2(abs(determinant), below);
}

TEST(CubeMap, TexelsAreTwoTriangles) {
  for (const auto& [x, y, size] :
       {std::array{"0", "0", "0.015625"}, std::array{"0.984375", "0.984375", "0.015625"},
        std::array{"-0.5", "0.25", "0.125"}, std::array{"-1", "-1", "2"}}) {
    const Decimal50 X(x), Y(y), S(size), far_x = X + S, far_y = Y + S;
    const Vector a{X, Y, 1}, b{far_x, Y, 1}, c{far_x, far_y, 1}, d{X, far_y, 1};
    const Decimal50 truth = triangle_solid_angle(a, b, c) + triangle_solid_angle(a, c, d);
    EXPECT_TRUE(is_close(x, truth, texel_solid_angle(X, Y, S), 1e-44));
    // four values of size 1 leave a texel of 5e-5: 12 of 16 digits
    EXPECT_TRUE(is_close(
        x, truth,
        Decimal50(texel_solid_angle(X.convert_to<double>(), Y.convert_to<double>(), S.convert_to<double>())),
        1e-11));
  }
}

TEST(CubeMap, ATexelOverItsMeanHasALimit) {
  const Decimal50 limit = 6 / pi<Decimal50>();
  for (const int level : {10, 20}) {
    const Decimal50 width = exp2(Decimal50(level)), size = 2 / width;
    const Decimal50 mean = mean_texel_solid_angle(width, Decimal50(0));
    const Decimal50 centre = texel_solid_angle(Decimal50(0), Decimal50(0), size) / mean;
    const Decimal50 corner = texel_solid_angle(Decimal50(1 - size), Decimal50(1 - size), size) / mean;
    // The density falls by size^2 from the centre and rises by 2/3 size from a corner, to first order: half
    // way into the texel by size and less.
    EXPECT_TRUE(is_close("centre", limit, centre, (size * size).convert_to<double>()));
    EXPECT_TRUE(
        is_close("corner", limit / (3 * sqrt(Decimal50(3))), corner, (2 * size).convert_to<double>()));
    EXPECT_FALSE(
        is_close("corner", limit / (3 * sqrt(Decimal50(3))), corner, (size / 2).convert_to<double>()));
  }
}

TEST(CubeMap, AFaceIsASixthOfTheSphere) {
  Decimal50 sum = 0;
  const Decimal50 size("0.25");
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) sum += texel_solid_angle(-1 + i * size, -1 + j * size, size);
  }
  EXPECT_TRUE(is_close("8 x 8", 2 * pi<Decimal50>() / 3, sum, 1e-45));
  EXPECT_TRUE(is_close("mean", sum / 64, mean_texel_solid_angle(Decimal50(32), Decimal50(2)), 1e-45));
}

TEST(SolidAngle, Landmarks) {
  const Decimal50 right = pi<Decimal50>() / 2;
  EXPECT_TRUE(is_close("hemisphere", 2 * pi<Decimal50>(), cap_solid_angle(right), 1e-45));
  EXPECT_TRUE(is_close("power 0", cap_solid_angle(right), lobe_solid_angle(Decimal50(0)), 1e-45));
  EXPECT_TRUE(is_close("Lambert", pi<Decimal50>(), lobe_solid_angle(Decimal50(1)), 1e-45));
  for (const char* phi : {"0.001", "0.5", "3"}) {
    EXPECT_TRUE(
        is_close(phi, cap_solid_angle(Decimal50(phi)), cap_solid_angle_near_axis(Decimal50(phi)), 1e-40));
  }
}

TEST(SolidAngle, ALobeFallsAsFarAsItsPowerSays) {
  for (const char* tangent : {"0.015625", "2"}) {
    const Decimal50 t(tangent), n("1.5");
    const Decimal50 cos_theta = cos(Decimal50(boost::multiprecision::atan(t)));
    EXPECT_TRUE(is_close(tangent, exp(Decimal50(-n)), power_lobe(cos_theta, power_that_falls(n, t)), 1e-42));
  }
}

TEST(MipLevel, TexelAndLobeCoverTheSame) {
  for (const char* w : {"1", "128", "1000"}) {
    for (const char* s : {"0.1", "2", "2048", "1000000"}) {
      const Decimal50 width(w), power(s), level = mip_level_of_power(width, power);
      EXPECT_TRUE(is_close(s, lobe_solid_angle(power), mean_texel_solid_angle(width, level), 1e-45));
      EXPECT_TRUE(is_close(s, power, power_of_solid_angle(mean_texel_solid_angle(width, level)), 1e-42));
    }
  }
}

TEST(GlossChain, AShaderThatCountsTheStepsInvertsTheGenerator) {
  for (const char* g : {"0", "0.125", "0.5", "1"}) {
    const Decimal50 gloss(g), levels(6);
    EXPECT_TRUE(is_close(g, gloss + 1,
                         1 + gloss_of_level(level_of_gloss(gloss, levels - 1, levels - 1), levels), 1e-45));
  }
  EXPECT_EQ(level_of_gloss(0.0, 6.0, 5.0), 5) << "clamped";
  EXPECT_EQ(level_of_gloss(0.5, 6.0, 5.0), 3);
  // mpmath: mp.dps = 45; power(2, mpf(10)/255) - 1
  EXPECT_TRUE(is_close("step", Decimal50("0.0275550497734122645065368489798416806213"),
                       relative_gloss_step(Decimal50(10), Decimal50(255)), 1e-37));
}

}  // namespace
}  // namespace shadefit
