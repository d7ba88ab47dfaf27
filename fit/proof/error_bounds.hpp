#pragma once

#include <span>

#include "approx/cosine.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/families/surface.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// Proven bounds of the largest error of a curve, without the other data of a certificate.
namespace shadefit {

/// max |error| lies in [lower, upper].
struct ErrorBounds {
  double lower = 0, upper = 0;
  bool is_reached = true;  ///< whether the requested width is reached
};

/// Bounds of a subject's largest error, of relative width `width` or as near as possible. `peaks` are places
/// where |error| may be largest, at least one; they only make the proof faster. The subject's family must be
/// known and its parameters constants. The checkpoint is called for each box.
ErrorBounds bound_error(const Subject& subject, std::span<const Cosine<double>> peaks, double width,
                        const Checkpoint& checkpoint = keep_going);

/// Schlick's formula with the surface's f0 against the exact reflectance of the surface.
struct SchlickError {
  ErrorBounds bounds;
  Extremum absolute, relative;  ///< sampled: of F, and of F relative to the exact F
  double rms = 0;               ///< of F, uniform in the cosine
};

/// The error of Schlick's formula over a domain; `surface` must be exact. The checkpoint is called for each
/// box of the proof.
SchlickError schlick_error(const Surface& surface, const Domain& domain, double width,
                           const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
