#pragma once

#include "fit/extremum.hpp"

/// How far Schlick's formula itself is from the truth: the yardstick of every approximation of it.
namespace shadefit {

struct ReflectanceError {
  Extremum absolute;  ///< of F, in [0, 1]
  Extremum relative;  ///< of F over the exact F
};

/// Schlick's formula with f0 from the index against the exact dielectric, over all of c. `ior` above 1.
ReflectanceError schlick_against_exact(double ior);

}  // namespace shadefit
