#include "approx/reflectance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "tests/accuracy.hpp"
#include "tests/fit/ledger/vector.hpp"

namespace shadefit {
namespace {

using testing::dot;
using testing::is_close;
using testing::Vector;

Vector along(const Decimal50& p, const Vector& a, const Decimal50& q, const Vector& b) {
  return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

/// Normal, view and mirrored view in the plane y = 0, as vectors.
struct Scene {
  explicit Scene(const Decimal50& angle)
      : view_angle(angle),
        v{shadefit::sin(angle), 0, shadefit::cos(angle)},
        r{-shadefit::sin(angle), 0, shadefit::cos(angle)} {}
  Decimal50 view_angle;
  Vector n{0, 0, 1}, v, r;
};

/// The integral over [0, to]; the rule is given [0, 1].
template <class F>
Decimal50 integral(const F& f, const Decimal50& to) {
  static boost::math::quadrature::tanh_sinh<Decimal50> rule(10);
  return to * rule.integrate([&](const Decimal50& t) { return f(to * t); }, Decimal50(0), Decimal50(1),
                             Decimal50("1e-45"));
}

Arc<Decimal50> arc_to(const Decimal50& angle) {
  return {angle, shadefit::sin(angle), shadefit::cos(angle)};
}

TEST(Arc, ClosedFormsAreTheIntegrals) {
  for (const char* p : {"0.7", "-0.2"}) {
    for (const char* q : {"0", "0.5", "-1.5"}) {
      for (const char* end : {"0.01", "1.5", "3.1"}) {
        const Decimal50 P(p), Q(q), E(end);
        const auto line = [&](const Decimal50& phi) { return Decimal50(P + Q * shadefit::cos(phi)); };
        const auto square = [&](const Decimal50& phi) { return Decimal50(line(phi) * line(phi)); };
        const std::string where = std::string(p) + " " + q + " " + end;
        EXPECT_TRUE(is_close(where, 2 * integral(line, E), arc_of_line(P, Q, arc_to(E)), 1e-44));
        EXPECT_TRUE(is_close(where, 2 * integral(square, E), arc_of_square(P, Q, arc_to(E)), 1e-44));
      }
    }
  }
}

/// The azimuth where n.l = 0 on the circle at the angle psi.
Decimal50 horizon(const Decimal50& view_angle, const Decimal50& psi) {
  return acos(Decimal50(-shadefit::cos(view_angle) * shadefit::cos(psi) /
                        (shadefit::sin(view_angle) * shadefit::sin(psi))));
}

// Around r, with vectors: l = cos(w) r + sin(w) (cos(phi) t + sin(phi) y), t towards n.
TEST(Circle, OfPhongIsTheIntegralOverVectors) {
  const Scene scene(Decimal50("0.9"));
  const Vector t{shadefit::cos(scene.view_angle), 0, shadefit::sin(scene.view_angle)}, y{0, 1, 0};
  for (const char* angle :
       {"0.3", "0.8", "1.5"}) {  // the whole circle; one that the horizon cuts; nearly pi/2
    const Decimal50 w(angle), a(5);
    const bool is_whole = w < pi<Decimal50>() / 2 - scene.view_angle;
    const Decimal50 end = is_whole ? pi<Decimal50>() : horizon(scene.view_angle, w);
    const auto light = [&](const Decimal50& phi) {
      const Vector side = along(shadefit::cos(phi), t, shadefit::sin(phi), y);
      return along(shadefit::cos(w), scene.r, shadefit::sin(w), side);
    };
    if (!is_whole) {
      EXPECT_LT(abs(dot(scene.n, light(end))), 1e-45) << angle;
    }
    const auto plain = integral([&](const Decimal50& phi) { return pow(dot(scene.r, light(phi)), 5); }, end);
    const auto with_cosine = integral(
        [&](const Decimal50& phi) {
          return Decimal50(pow(dot(scene.r, light(phi)), 5) * dot(scene.n, light(phi)));
        },
        end);
    const Direction<Decimal50> view{dot(scene.n, scene.v), shadefit::sin(scene.view_angle)};
    const auto circle = phong_circle(Decimal50(1 - shadefit::cos(w)), a, view, arc_to(end));
    EXPECT_TRUE(is_close(angle, 2 * plain, circle.plain, 1e-43));
    EXPECT_TRUE(is_close(angle, 2 * with_cosine, circle.with_cosine, 1e-43));
  }
}

// Around n, with vectors: h, and l = 2 (v.h) h - v. d omega_l = 4 (v.h) sin(w) dw dphi and dy = 2 sin(2w) dw.
TEST(Circle, OfBlinnPhongIsTheIntegralOverVectors) {
  const Scene scene(Decimal50("0.9"));
  const Vector x{1, 0, 0}, y{0, 1, 0};
  for (const char* angle : {"0.2", "0.5", "1.2"}) {
    const Decimal50 w(angle), a(5), limit = pi<Decimal50>() / 2 - scene.view_angle;
    const bool is_whole = 2 * w < limit;
    const Decimal50 end = is_whole ? pi<Decimal50>() : horizon(scene.view_angle, Decimal50(2 * w));
    const auto half = [&](const Decimal50& phi) {
      const Vector side = along(shadefit::cos(phi), x, shadefit::sin(phi), y);
      return along(shadefit::cos(w), scene.n, shadefit::sin(w), side);
    };
    const auto n_l = [&](const Decimal50& phi) {
      const Vector h = half(phi);
      return dot(scene.n, along(2 * dot(scene.v, h), h, -1, scene.v));
    };
    if (!is_whole) {
      EXPECT_LT(abs(n_l(end)), 1e-45) << angle;
      EXPECT_GT(dot(scene.v, half(end)), 0) << "the half vector is in front of the view";
    }
    const auto density = [&](const Decimal50& phi) {
      return Decimal50(4 * dot(scene.v, half(phi)) * pow(dot(scene.n, half(phi)), 5));
    };
    const auto plain = integral(density, end);
    const auto with_cosine =
        integral([&](const Decimal50& phi) { return Decimal50(density(phi) * n_l(phi)); }, end);
    const Decimal50 per_dy = shadefit::sin(w) / (2 * shadefit::sin(Decimal50(2 * w)));
    const Direction<Decimal50> view{dot(scene.n, scene.v), shadefit::sin(scene.view_angle)};
    const auto circle =
        blinn_phong_circle(Decimal50(1 - shadefit::cos(Decimal50(2 * w))), a, view, arc_to(end));
    EXPECT_TRUE(is_close(angle, 2 * plain * per_dy, circle.plain, 1e-43));
    EXPECT_TRUE(is_close(angle, 2 * with_cosine * per_dy, circle.with_cosine, 1e-43));
  }
}

// A direction by its longitude from `from` towards `to` (both in the plane y = 0, a right angle apart) and z
// along the pole.
Vector at_longitude(const Vector& from, const Vector& to, const Decimal50& g, const Decimal50& z) {
  const Decimal50 r = shadefit::sqrt(Decimal50(1 - z * z));
  return along(1, along(r * shadefit::cos(g), from, r * shadefit::sin(g), to), z, {0, 1, 0});
}

TEST(Longitude, OfPhongIsTheLobeOfVectors) {
  const Scene scene(Decimal50("0.9"));
  const Decimal50 e = pi<Decimal50>() / 2 - scene.view_angle;
  const Vector t{shadefit::cos(scene.view_angle), 0, shadefit::sin(scene.view_angle)};  // r towards n
  for (const char* g : {"-0.6", "0", "1.2"}) {
    for (const char* z : {"-0.5", "0", "0.9"}) {
      const Decimal50 G(g), Z(z), a(5);
      const Vector l = at_longitude(scene.r, t, G, Z);
      const auto longitude = phong_longitude(G, a, e);
      const auto latitude = phong_latitude(Z, a);
      const std::string where = std::string(g) + " " + z;
      const Decimal50 lobe = pow(dot(scene.r, l), 5);
      EXPECT_TRUE(is_close(where, lobe, longitude.plain * latitude.plain, 1e-46));
      EXPECT_TRUE(
          is_close(where, lobe * dot(scene.n, l), longitude.with_cosine * latitude.with_cosine, 1e-45));
    }
  }
}

TEST(Longitude, OfBlinnPhongIsTheLobeOfVectors) {
  const Scene scene(Decimal50("0.9"));
  const Decimal50 e = pi<Decimal50>() / 2 - scene.view_angle, a(5);
  const Vector x{1, 0, 0};
  for (const char* g : {"0.1", "0.8", "1.4"}) {
    for (const char* z : {"-0.3", "0", "0.4"}) {
      const Decimal50 G(g), Z(z);
      const Vector h = at_longitude(scene.n, x, Decimal50(G - e / 2), Z);
      const Vector l = along(2 * dot(scene.v, h), h, -1, scene.v);
      const std::string where = std::string(g) + " " + z;
      const Decimal50 density = 4 * dot(scene.v, h) * pow(dot(scene.n, h), 5);
      const auto value = blinn_phong_meridian(G, a, e, blinn_phong_latitude(Z, a));
      EXPECT_TRUE(is_close(where, density, value.plain, 1e-46));
      EXPECT_TRUE(is_close(where, density * dot(scene.n, l), value.with_cosine, 1e-45));
    }
    const Vector h =
        at_longitude(scene.n, x, Decimal50(Decimal50(g) - e / 2), horizon_latitude(Decimal50(g), e));
    EXPECT_LT(abs(dot(scene.n, along(2 * dot(scene.v, h), h, -1, scene.v))), 1e-45)
        << "the light is at the horizon";
  }
}

TEST(CosinePower, EndsAtZeroAndNotBeyond) {
  EXPECT_EQ(cosine_power(0.0, 2048.0), 1);
  EXPECT_NEAR(cosine_power(pi<double>() / 2, 8.0), 0, 1e-100);
  EXPECT_EQ(cosine_power(std::nextafter(pi<double>() / 2, 2.0), 8.0), 0) << "a rounded pi/2 is not a NaN";
}

}  // namespace
}  // namespace shadefit
