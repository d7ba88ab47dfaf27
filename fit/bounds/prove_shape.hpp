#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/bounds/study_certificate.hpp"
#include "fit/proof/proof.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// How far a fit under a constraint may cross it, as a share of the largest value. The fit touches its bound,
/// and the rounding of its parameters to doubles moves it by some last bits, 1e-16 for each of some terms.
inline constexpr double shape_slack = 1e-12;

/// How far a form that is exact at an end may be off there, as a share of the largest value: the last place
/// of a float.
inline constexpr double exact_slack = 0x1p-24;

/// The most boxes on which a form is enclosed for one constraint. Each takes some microseconds for each
/// operation of the form, so that all of them take about a tenth of a second.
inline constexpr std::size_t most_shape_boxes = 5000;

/// The same of an edge if the target has an integral: each box takes a millisecond or two.
inline constexpr std::size_t most_edge_boxes_of_integrals = 1500;

/// The result of a proof that a form keeps a constraint.
struct ShapeProof {
  Proof proof = Proof::none;
  std::vector<double> place = {};  ///< where it is refuted, or is open, to the nearest doubles
  std::size_t boxes = 0;           ///< on which the form was enclosed
  std::string reason = {};         ///< why it is open: "a proof needs more than 5000 boxes"
};

/// Proves in interval arithmetic, at all numbers of the ranges, that the form of a subject keeps a
/// constraint, where `scale` is the size of its values:
/// - `at_least`, `at_most`: it crosses the bound by no more than `shape_slack * scale`;
/// - `monotone`: along every line of the variable of this index it never falls, or never rises, by more than
///   that, however many times;
/// - `exact_at` an end of that variable: it differs from the target by no more than `exact_slack * scale`, of
///   several variables at every place where that one is at its end.
/// Of several constraints only the first one in this order is proven. Other constraints are not proven.
///
/// A bound is proven on boxes, which are cut until it holds on each. For `monotone` the proof sums over the
/// boxes of a line how far the form may run the wrong way.
///
/// The answer is `open`, with a reason, if that needs more than `most_shape_boxes`, if a monotone form may
/// have a pole, if the form has an integral, or if the target at an end has an integral inside another one.
/// Throws UserError for formulas that cannot be read, and for parameters other than those of the form.
ShapeProof prove_shape(const StudySubject& subject, const Constraints& constraint, double scale,
                       std::size_t variable = 0, const Checkpoint& checkpoint = keep_going);

/// Proves that the form of a subject differs from its target by at most `slack` wherever a variable is at an
/// end of its range. In several variables that is an edge or a face, which is cut into boxes. The answer is
/// `open` for measured rows, if the target has an integral inside another one, and for too many boxes.
ShapeProof prove_exact(const StudySubject& subject, std::size_t axis, double end, double slack,
                       const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
