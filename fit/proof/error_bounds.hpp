#pragma once

#include <span>

#include "approx/cosine.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/families/surface.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// The largest error of a curve between proven bounds, without what a certificate holds besides.
namespace shadefit {

/// max |error| lies in [lower, upper].
struct ErrorBounds {
  double lower = 0, upper = 0;
  bool is_reached = true;  ///< whether they are as near as was asked
};

/// Bounds of a subject's largest error, `width` apart relative to it, or as near as they get. `peaks` are
/// places where |error| may be largest, at least one: they make the proof short, and nothing else rests on
/// them. The subject's family is known and its parameters are constants. The checkpoint is called for each
/// box.
ErrorBounds bound_error(const Subject& subject, std::span<const Cosine<double>> peaks, double width,
                        const Checkpoint& checkpoint = keep_going);

/// Schlick's formula with the surface's f0 against the exact reflectance of the surface.
struct SchlickError {
  ErrorBounds bounds;
  Extremum absolute, relative;  ///< sampled: of F, and of F over the exact one
  double rms = 0;               ///< of F, uniform in the cosine
};

/// Its error over a domain; `surface` is an exact one. The checkpoint is called for each box of the proof.
SchlickError schlick_error(const Surface& surface, const Domain& domain, double width,
                           const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
