#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fit/fit.hpp"

/// Whether a least-squares fit is where its integral says: existence and uniqueness, proven.
namespace shadefit {

/// Relative: the half width of the box around a fit in which its stationary point is shown to be the only
/// one. A hundred times what a fit promises.
inline constexpr double stationary_radius = 1e-13;

/// A proof that the gradient of the integral of measure * error^2 vanishes once in a box of parameters.
struct StationaryPoint {
  using Range = std::pair<double, double>;

  bool is_proven = false;
  std::string reason;            ///< why it is not
  bool is_minimum = false;       ///< the Hessian is positive definite in all of the box
  std::vector<Range> unique_in;  ///< parameters: here is one stationary point and no other
  std::vector<Range> lies_in;    ///< and here it is
  int digits = 0;  ///< floor(-log10) of the fit's distance from it, relative; the worst parameter
};

/// Proves it by one step of Krawczyk's operator, K = p - C g(p) + (1 - C H)(P - p): where K lies inside of
/// the box P, g vanishes once in P, and there in K. Gradient g and Hessian H are integrals, enclosed with
/// their quadrature's remainder (fit/proof/enclosed_integral.hpp), so that it is a proof about the integral
/// and not about a sum. Source: Krawczyk 1969, "Newton-Algorithmen zur Bestimmung von Nullstellen mit
/// Fehlerschranken"; Moore 1977, "A test for existence of solutions to nonlinear systems".
///
/// For a fit under least squares of the absolute error; of another, or of one that did not converge, the
/// reason says so.
StationaryPoint prove_stationary(const Fit& fit, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
