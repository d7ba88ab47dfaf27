#pragma once

#include <algorithm>
#include <vector>

#include "approx/cosine.hpp"
#include "approx/scalar.hpp"
#include "fit/quadrature/metric.hpp"

/// Boxes of the domain, for proofs. The ends of each box are exact doubles, and adjacent boxes leave no gap.
namespace shadefit {

/// The end of [0, 1] from which a cosine is measured. A lobe of exponent 1e6 is concentrated within 1 - c =
/// 1e-5, and a power of c can turn at any small c. A double cannot hold both c and 1 - c accurately, so near
/// each end we store the distance from that end. The sides meet at c = 1/2, which both can represent.
enum class Origin {
  horizon,  ///< the distance is c, up to 1/2
  peak,     ///< the distance is 1 - c, up to 1/2
};

inline constexpr double half_way = 0.5;

/// A cosine, exactly.
struct ExactPlace {
  Origin side = Origin::peak;
  double distance = 0;
};

/// The cosines between two distances from one side.
struct Box {
  Origin side = Origin::peak;
  double lower = 0;
  double upper = 0;
};

/// The cosine at a distance from a side, in any scalar.
template <class T>
Cosine<T> cosine_at(Origin side, const T& distance) {
  const T rest = integer<T>(1) - distance;
  return side == Origin::peak ? Cosine<T>{rest, distance} : Cosine<T>{distance, rest};
}

/// A domain as one or two boxes. 1 - c is exact for a double c in [1/2, 1], so the boxes are exactly the
/// domain.
inline std::vector<Box> boxes_of(const Domain& domain) {
  std::vector<Box> boxes;
  if (domain.lower < half_way)
    boxes.push_back({Origin::horizon, domain.lower, std::min(domain.upper, half_way)});
  if (domain.upper > half_way)
    boxes.push_back({Origin::peak, 1 - domain.upper, std::min(1 - domain.lower, half_way)});
  return boxes;
}

}  // namespace shadefit
