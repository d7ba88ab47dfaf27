#include "fit/claims/reflectance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fit/support/decimal.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

constexpr auto both_lobes = {ReflectedLobe::phong, ReflectedLobe::blinn_phong};
constexpr auto both_parts = {&LobeIntegrand<double>::plain, &LobeIntegrand<double>::with_cosine};

const std::vector<ReflectanceCurve>& all_curves() {
  static const auto curves = reflectance_curves([](std::string_view) { return true; });
  return curves;
}

const ReflectanceCurve& curve(std::string_view id, double exponent) {
  for (const auto& c : all_curves()) {
    if (c.record->id == id && c.exponent == exponent) return c;
  }
  throw std::out_of_range("no such curve");
}

// Written over l around n and integrated in 40 digits: see make_reflectance_references.py.
TEST(Reflectance, BothRulesAgreeWithTheReferences) {
  const auto table =
      parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/references/reflectance.csv"), "reflectance.csv");
  EXPECT_EQ(table.rows.size(), 36U);
  for (const auto& row : table.rows) {
    const auto lobe = row[0] == "phong" ? ReflectedLobe::phong : ReflectedLobe::blinn_phong;
    const auto part =
        row[3] == "no" ? &LobeIntegrand<Integral>::plain : &LobeIntegrand<Integral>::with_cosine;
    const double alpha = *parse_number(row[1]);
    const View view(*parse_number(row[2]));
    const Decimal50 truth(row[4]);
    const std::string where = row[0] + " " + row[1] + " " + row[2] + " " + row[3];
    const Integral circles = reflect_by_circles(lobe, alpha, view, 1e-12).*part;
    const Integral longitude = reflect_by_longitude(lobe, alpha, view, 1e-12).*part;
    // 89.9 degrees as a double are off by 6e-14 of the elevation; the sums round to a few 1e-15
    EXPECT_TRUE(is_close(where + " by circles", truth, circles.value, 5e-14));
    EXPECT_TRUE(is_close(where + " by longitude", truth, longitude.value, 5e-14));
    EXPECT_LE(abs(Decimal50(circles.value) - truth), circles.error + 1e-14 * truth) << where;
    EXPECT_LE(abs(Decimal50(longitude.value) - truth), longitude.error + 1e-14 * truth) << where;
  }
}

TEST(Reflectance, EveryRowKeepsItsPromise) {
  EXPECT_EQ(all_curves().size(), 20U);
  for (const auto& c : all_curves()) {
    ASSERT_EQ(c.points.size(), view_angles.size());
    for (const auto& p : c.points) {
      EXPECT_LE(p.estimated_error, reflectance_tolerance)
          << c.record->id << " " << c.exponent << " " << p.view_angle;
    }
  }
}

TEST(Reflectance, AtNormalViewIsWhatTheConstantsAreMadeFor) {
  for (const double a : reflectance_exponents) {
    const auto normal = [&](std::string_view id) { return curve(id, a).points.front(); };
    for (const char* id : {"norm-phong", "norm-phong-brdf", "norm-blinn-phong", "norm-blinn-phong-brdf"}) {
      EXPECT_NEAR(normal(id).reflectance, 1, 1e-13) << id << " " << a;
    }
    EXPECT_NEAR(normal("norm-phong").with_cosine, (a + 1) / (a + 2), 1e-13);
    EXPECT_NEAR(normal("norm-phong-brdf").with_cosine, 1, 1e-13);
    const double ratio = (a + 8) * (std::exp2(-a / 2) + a) / ((a + 2) * (a + 4));
    EXPECT_NEAR(normal("norm-blinn-phong-cheap").reflectance, ratio, 1e-13);
  }
}

// (1/pi) (pi/2) times the integral of cos over -e..pi/2 is (1 + cos(theta_v))/2.
TEST(Reflectance, OfPhongAtExponentOneIsElementary) {
  for (const auto& p : curve("norm-phong", 1).points) {
    EXPECT_NEAR(p.reflectance, (1 + View(p.view_angle).direction.cosine) / 2, 1e-14) << p.view_angle;
  }
}

// At the horizon half of the Phong lobe is left, and each radian of elevation uncovers 1/W more, W the
// integral of cos^a over -pi/2..pi/2, which is the beta function of 1/2 and (a+1)/2; the next term is e^3.
TEST(Reflectance, OfPhongTendsToOneHalfAtTheHorizon) {
  for (const double a : {1.0, 8.0, 64.0}) {
    const View view(89.9);
    const double width = std::beta(0.5, (a + 1) / 2);
    const double e = view.elevation;
    const double third = a * e * e * e / (6 * width);
    EXPECT_NEAR(curve("norm-phong", a).points.back().reflectance, 0.5 + e / width - third,
                1e-3 * third + 1e-13)
        << a;
  }
}

// A sharp lobe away from the horizon: cos(theta_v) for n.l, and for Blinn-Phong another 4 (v.h) d omega_h.
TEST(Reflectance, OfSharpLobesFollowsTheCosine) {
  for (const double degrees : {15.0, 45.0, 60.0}) {
    const double c = View(degrees).direction.cosine;
    const auto at = [&](std::string_view id) {
      for (const auto& p : curve(id, 2048).points) {
        if (p.view_angle == degrees) return p.reflectance;
      }
      return 0.0;
    };
    EXPECT_NEAR(at("norm-phong"), 1, 1e-12);
    EXPECT_NEAR(at("norm-phong-brdf"), c, 1e-12);
    EXPECT_NEAR(at("norm-blinn-phong"), c, 1e-12);
    EXPECT_NEAR(at("norm-blinn-phong-brdf"), c * c, 2.0 / 2048) << "its variance is of order 1/a";
  }
}

// Sampled every half degree: no integral rises with the view angle, so all are largest at v = n and the exact
// constants create energy nowhere. For Phong it can be shown: the derivatives are -cos^a(e) times a positive
// number, and cos(theta_v) sin^(a+1)(theta_v)/(a+1) - sin(theta_v) times the integral of cos^(a+1) over
// -e..pi/2.
TEST(Reflectance, NeverRisesWithTheViewAngle) {
  for (const auto lobe : both_lobes) {
    for (const auto part : both_parts) {
      for (const double a : reflectance_exponents) {
        double before = reflect_by_circles(lobe, a, View(0), part, 1e-11).value;
        for (double degrees = 0.5; degrees < 90; degrees += 0.5) {
          const double now = reflect_by_circles(lobe, a, View(degrees), part, 1e-11).value;
          EXPECT_LE(now, before * (1 + 1e-13)) << a << " " << degrees;
          EXPECT_GT(now, 0);
          before = now;
        }
      }
    }
  }
  for (const auto& c : all_curves()) {
    EXPECT_EQ(c.largest.view_angle, 0);
    EXPECT_EQ(c.largest_with_cosine.view_angle, 0);
    EXPECT_EQ(c.largest_with_cosine.value, c.points.front().with_cosine);
    EXPECT_EQ(c.largest.value, c.points.front().reflectance);
  }
}

TEST(Reflectance, OnlyTheCheapConstantCreatesEnergy) {
  for (const auto& c : all_curves()) {
    EXPECT_EQ(c.conserves_from.has_value(), c.record->id == "norm-blinn-phong-cheap") << c.record->id;
    if (!c.conserves_from) continue;
    const double factor = BlinnPhongCheapLobe::constant(c.exponent);
    const auto reflectance = [&](double degrees) {
      return factor * reflect_by_longitude(ReflectedLobe::blinn_phong, c.exponent, View(degrees), 1e-12)
                          .with_cosine.value;
    };
    EXPECT_NEAR(reflectance(*c.conserves_from), 1, 1e-11) << c.exponent;
    EXPECT_GT(reflectance(*c.conserves_from - 0.01), 1);
    EXPECT_LT(reflectance(*c.conserves_from + 0.01), 1);
  }
}

TEST(Reflectance, CheapAndExactShareTheirIntegral) {
  for (const double a : reflectance_exponents) {
    const double ratio = BlinnPhongCheapLobe::constant(a) / BlinnPhongBrdfLobe::constant(a);
    for (std::size_t i = 0; i < view_angles.size(); ++i) {
      const auto& cheap = curve("norm-blinn-phong-cheap", a).points[i];
      EXPECT_EQ(cheap.reflectance, cheap.with_cosine);
      EXPECT_NEAR(cheap.reflectance / curve("norm-blinn-phong-brdf", a).points[i].reflectance, ratio, 1e-15);
    }
  }
}

TEST(Reflectance, OnlyWhatIsWanted) {
  const auto curves = reflectance_curves([](std::string_view id) { return id == "norm-phong"; });
  ASSERT_EQ(curves.size(), reflectance_exponents.size());
  for (const auto& c : curves) EXPECT_EQ(c.record->id, "norm-phong");
  EXPECT_TRUE(reflectance_curves([](std::string_view) { return false; }).empty());
}

TEST(LargestOverView, FindsPeaksInsideAtTheEndsAndOnPlateaus) {
  const auto largest = [](const auto& f) {
    std::vector<ReflectancePeak> samples;
    for (const double angle : view_angles) samples.push_back({f(angle), angle});
    return largest_over_view(f, samples);
  };
  for (const double place : {4.2, 7.4, 37.5, 79.0, 89.5}) {
    const auto peak = largest([&](double x) { return 2 - (x - place) * (x - place) / 8100; });
    EXPECT_NEAR(peak.view_angle, place, 1e-4) << "half the digits of a double, of 90";
    EXPECT_NEAR(peak.value, 2, 1e-12);
  }
  EXPECT_EQ(largest([](double x) { return 2 - x / 90; }).view_angle, 0);
  EXPECT_EQ(largest([](double x) { return 1 + x / 90; }).view_angle, 89.9);
  EXPECT_EQ(largest([](double x) { return x < 50 ? 1.0 : 0.5; }).view_angle, 0) << "the smallest of equals";
  EXPECT_EQ(largest([](double x) { return 1 + 1e-12 * x; }).view_angle, 0)
      << "rounding does not choose the place";
}

TEST(View, KeepsItsElevation) {
  EXPECT_EQ(View(0).direction.sine, std::cos(pi<double>() / 2));
  EXPECT_EQ(View(0).direction.cosine, 1);
  EXPECT_NEAR(View(60).direction.cosine, 0.5, 1e-16);
  const double elevation = (90 - 89.9) / 180 * pi<double>();
  EXPECT_EQ(View(89.9).direction.cosine, std::sin(elevation));
}

}  // namespace
}  // namespace shadefit
