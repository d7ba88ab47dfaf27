#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_edges.hpp"

/// What formulas of one variable do between the places at which they are sampled.
namespace shadefit {

/// Narrow features of formulas, as far as enclosures tell.
struct Features {
  /// Places that cut panels. Between them, nodes of a rule see the formulas.
  std::vector<double> cuts;
  /// A place where more boxes would be needed; none if everything is explained. A jump, an infinite slope and
  /// a pole are explained: the boxes shrink to their place.
  std::optional<double> unresolved;
};

/// The features of a formula of the only variable of a study, between edges. What is unexplained is below a
/// share of the range of its values.
///
/// The range is divided into boxes. On each the Taylor coefficients c_0 .. c_8 are enclosed in doubles that
/// are rounded outward. A box of half width h is explained if half the width of c_0, or |c_n| h^n of any n,
/// is small enough: the formula is then that near to a polynomial of degree n - 1. Or if it is rounding, or
/// the box cannot be halved. Samples alone miss what lies between them: a Gaussian of width 0.0005, a line of
/// a spectrum, a lobe.
Features features_of(const Symbolic& formula, const StudyAxis& axis, const std::vector<StudyEdge>& edges,
                     double share);

/// Whether enclosures know the formulas of a study: of one variable, without an integral.
bool is_enclosed(const ReadStudy& study);

/// Cuts the only variable of a study at the features of its target, weight and density, and of the parts of
/// its form without parameters. A study that is not enclosed, or of rows, stays as it is.
std::optional<double> cut_at_features(ReadStudy& study);

/// The same for its error at some parameters.
Features features_of_error(const ReadStudy& study, const std::vector<double>& parameters);

/// Why a fit is unresolved: the place where more boxes would be needed.
std::string why_unresolved(const ReadStudy& study, double place);

}  // namespace shadefit
