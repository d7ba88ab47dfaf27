// Reference values of directional reflectance: the integrals over the hemisphere n.l >= 0 of (r.v)^a and
// (n.h)^a, as they stand and times n.l.
//
// shadefit integrates in polar coordinates around the lobe's axis (half vectors for Blinn-Phong) and around a
// pole square to normal and view; here the integrand is written as it is defined, over the light l in polar
// coordinates around the normal, and integrated twice by tanh-sinh in 40 digits. Both integrals of a lobe are
// taken together.
//
//   make_reflectance_references            prints reflectance.csv
//   make_reflectance_references --check F  compares F with what it computes; exit 1 where a digit differs
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <ostream>
#include <utility>
#include <vector>

#include "print_or_check.hpp"

namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>, boost::multiprecision::et_off>;

const Real pi = boost::math::constants::pi<Real>();

// The lobe as it stands and times n.l.
struct Pair {
  Real plain = 0, with_cosine = 0;
};

// Nodes and weights of tanh-sinh on [0, 1]: x = 1/(1 + exp(-pi sinh t)), to |t| = 3.8, where x is 1e-30 from
// the end. Halving the step of 1/20 changes none of the 18 printed digits.
struct Node {
  Real x, weight;
};

std::vector<Node> tanh_sinh_nodes() {
  constexpr int steps_per_unit = 20;
  std::vector<Node> nodes;
  for (int i = -38 * steps_per_unit / 10; i <= 38 * steps_per_unit / 10; ++i) {
    const Real t = Real(i) / steps_per_unit;
    const Real e = exp(-pi * sinh(t));
    nodes.push_back({1 / (1 + e), pi * cosh(t) * e / ((1 + e) * (1 + e)) / steps_per_unit});
  }
  return nodes;
}

template <class F>
Pair integrate_panel(const F& f, const Real& from, const Real& to) {
  static const std::vector<Node> nodes = tanh_sinh_nodes();
  Pair sum;
  for (const Node& node : nodes) {
    const Pair value = f(from + (to - from) * node.x);
    sum.plain += (to - from) * node.weight * value.plain;
    sum.with_cosine += (to - from) * node.weight * value.with_cosine;
  }
  return sum;
}

// Panel by panel: `cuts` in any order, those outside (from, to) left out.
template <class F>
Pair integrate(const F& f, const Real& from, const Real& to, std::vector<Real> cuts) {
  std::erase_if(cuts, [&](const Real& cut) { return cut <= from || cut >= to; });
  cuts.insert(cuts.end(), {from, to});
  std::sort(cuts.begin(), cuts.end());
  Pair sum;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Pair part = integrate_panel(f, cuts[i], cuts[i + 1]);
    sum.plain += part.plain;
    sum.with_cosine += part.with_cosine;
  }
  return sum;
}

// Cosine and sine of the view angle, and the angle itself.
struct View {
  Real angle, cosine, sine;
};

// The lobe at l in polar coordinates: cos(theta), sin(theta), and the cosine of the azimuth counted from r.
using Lobe = std::function<Real(const Real& cosine, const Real& sine, const Real& azimuth_cosine)>;

Lobe phong(const View& view, int alpha) {
  return [=](const Real& c, const Real& s, const Real& azimuth) {
    const Real r_l = view.cosine * c + view.sine * s * azimuth;
    return r_l > 0 ? Real(pow(r_l, alpha)) : Real(0);
  };
}

// n.h = n.(l+v) / |l+v|, |l+v|^2 = 2 + 2 l.v; v stands opposite to r.
Lobe blinn_phong(const View& view, int alpha) {
  return [=](const Real& c, const Real& s, const Real& azimuth) {
    const Real l_v = view.cosine * c - view.sine * s * azimuth;
    const Real n_h = (c + view.cosine) / sqrt(2 + 2 * l_v);
    return Real(pow(n_h, alpha));
  };
}

// The azimuth up to which r.l > 0 on the circle at theta.
Real clamp_of(const View& view, const Real& c, const Real& s) {
  const Real cosine = -view.cosine * c / (view.sine * s);
  return cosine <= -1 ? pi : Real(acos(cosine));
}

// theta is cut at the peak, where the clamp begins, and on either side of a sharp peak; phi, counted from the
// peak, beyond a sharp one, whose width shrinks with n.l + n.v at grazing views (Blinn-Phong).
Pair integrate_hemisphere(const Lobe& lobe, const View& view, int alpha, bool is_clamped) {
  const Real end = pi / 2, width = 6 / sqrt(Real(alpha));
  const auto circle = [&](const Real& theta) {
    const Real c = cos(theta), s = sin(theta);
    const auto at = [&](const Real& phi) {
      const Real value = lobe(c, s, cos(phi));
      return Pair{value, c * value};
    };
    const Pair half =
        integrate(at, 0, is_clamped ? clamp_of(view, c, s) : pi, {width, width * (c + view.cosine)});
    return Pair{2 * s * half.plain, 2 * s * half.with_cosine};
  };
  return integrate(circle, 0, end, {end - view.angle, view.angle, view.angle - width, view.angle + width});
}

void write_references(std::ostream& out) {
  out.precision(18);
  out << "lobe,exponent,view_angle,with_cosine,value\n";
  for (const int tenths : {300, 750, 899}) {
    const Real angle = pi * tenths / 1800;
    const View view{angle, sin(pi / 2 - angle), cos(pi / 2 - angle)};
    for (const int alpha : {1, 8, 2048}) {
      const auto rows = [&](const char* name, const Pair& value) {
        const auto row = [&](const char* with_cosine, const Real& number) {
          out << name << ',' << alpha << ',' << tenths / 10 << '.' << tenths % 10 << ',' << with_cosine << ','
              << number << '\n';
        };
        row("no", value.plain);
        row("yes", value.with_cosine);
      };
      rows("phong", integrate_hemisphere(phong(view, alpha), view, alpha, true));
      rows("blinn-phong", integrate_hemisphere(blinn_phong(view, alpha), view, alpha, false));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shadefit::references::print_or_check(argc, argv, write_references);
}
