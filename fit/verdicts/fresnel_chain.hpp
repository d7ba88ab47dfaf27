#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "approx/records/optical_constants.hpp"
#include "fit/catalogue/family.hpp"

/// The chain of a Fresnel approximation: from the published form to Schlick's formula, which it was fitted
/// to, and on to the exact reflectance of real surfaces.
namespace shadefit {

/// Of a curve against the reflectance of a surface.
struct ReflectanceError {
  Extremum absolute;  ///< of F, in [0, 1]
  Extremum relative;  ///< of F over the reflectance of the surface
  double srgb_codes;  ///< the largest, in 8-bit sRGB codes (a real number: 1 is one code)
};

/// A form of c, with the values of its parameters in their order, against the target of a surface.
ReflectanceError reflectance_error(const Surface& surface, const std::string& form,
                                   const std::vector<double>& parameters = {});

/// A curve on a surface.
struct FresnelLink {
  const OpticalConstants* surface;
  double f0;
  const Family* family;        ///< null: Schlick's formula itself
  std::string_view published;  ///< the id of the number that names a published curve; empty for a refit
  std::vector<double> parameters;
  Status status;                  ///< of a refit; not used for a published curve
  ReflectanceError from_schlick;  ///< of F, against Schlick's formula with the surface's f0
  ReflectanceError from_exact;
};

/// For each of the `dielectrics` and `metals`: Schlick's formula, the published curves of each family, and
/// its form refitted to the exact reflectance (least squares in F, uniform in the cosine).
std::vector<FresnelLink> fresnel_chain(const std::vector<const Family*>& families);

}  // namespace shadefit
