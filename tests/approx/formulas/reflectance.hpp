#pragma once

#include "approx/reflectance.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of the parts of a directional reflectance.
template <class Visit>
void reflectance_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes arcs{{"0.5", "0.75", "1"}, {"0.5", "-0.25", "3"}};
  // y, a, the view angle and the end of the arc; and g, a, the view's elevation and the latitudes' integral
  const Lobes circles{{"0.25", "5", "0.5", "2"}, {"0.5", "8", "1", "1.5"}};
  const Lobes longitudes{{"0.5", "5", "0.25"}, {"1", "8", "1"}};
  const Lobes meridians{{"0.5", "5", "0.25", "0.5"}, {"1", "8", "1", "0.25"}};
  visit(Formula{"arc_of_line", [](auto p, auto q, auto phi) { return arc_of_line(p, q, arc_to(phi)); }, arcs,
                16});
  visit(Formula{"arc_of_square", [](auto p, auto q, auto phi) { return arc_of_square(p, q, arc_to(phi)); },
                arcs, 16});
  visit(Formula{"phong_circle.plain",
                [](auto y, auto a, auto view, auto phi) {
                  return phong_circle(y, a, direction_of(view), arc_to(phi)).plain;
                },
                circles, 32});
  visit(Formula{"phong_circle.with_cosine",
                [](auto y, auto a, auto view, auto phi) {
                  return phong_circle(y, a, direction_of(view), arc_to(phi)).with_cosine;
                },
                circles, 32});
  visit(Formula{"blinn_phong_circle.plain",
                [](auto y, auto a, auto view, auto phi) {
                  return blinn_phong_circle(y, a, direction_of(view), arc_to(phi)).plain;
                },
                circles, 32});
  visit(Formula{"blinn_phong_circle.with_cosine",
                [](auto y, auto a, auto view, auto phi) {
                  return blinn_phong_circle(y, a, direction_of(view), arc_to(phi)).with_cosine;
                },
                circles, 64});
  visit(Formula{"cosine_power", [](auto x, auto a) { return cosine_power(x, a); },
                Lobes{{"0.25", "5"}, {"-1", "8"}}, 32});
  visit(Formula{"phong_longitude.plain",
                [](auto g, auto a, auto e) { return phong_longitude(g, a, e).plain; }, longitudes, 32});
  visit(Formula{"phong_longitude.with_cosine",
                [](auto g, auto a, auto e) { return phong_longitude(g, a, e).with_cosine; }, longitudes, 32});
  visit(Formula{"phong_latitude.plain", [](auto z, auto a) { return phong_latitude(z, a).plain; },
                Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{"phong_latitude.with_cosine", [](auto z, auto a) { return phong_latitude(z, a).with_cosine; },
                Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{"blinn_phong_longitude",
                [](auto g, auto a, auto e) { return blinn_phong_longitude(g, a, e); }, longitudes, 32});
  visit(Formula{"horizon_latitude", [](auto g, auto e) { return horizon_latitude(g, e); },
                Lobes{{"0.5", "0.25"}, {"1", "1"}}, 16});
  visit(Formula{"blinn_phong_latitude.one", [](auto z, auto a) { return blinn_phong_latitude(z, a).one; },
                Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{"blinn_phong_latitude.z_squared",
                [](auto z, auto a) { return blinn_phong_latitude(z, a).z_squared; },
                Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{"blinn_phong_meridian.plain",
                [](auto g, auto a, auto e, auto one) {
                  return blinn_phong_meridian(g, a, e, {one, one * one}).plain;
                },
                meridians, 32});
  visit(Formula{"blinn_phong_meridian.with_cosine",
                [](auto g, auto a, auto e, auto one) {
                  return blinn_phong_meridian(g, a, e, {one, one * one}).with_cosine;
                },
                meridians, 64});
}

}  // namespace shadefit::testing
