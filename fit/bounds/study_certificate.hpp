#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/proof/constants.hpp"
#include "fit/proof/proof.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

/// Proofs of the largest error of a user's own form.
namespace shadefit {

class KnownIntegrals;  // fit/bounds/study_integral.hpp

/// What a proof is about: all formulas, and the constants. Ranges are doubles: an end that is a formula, or a
/// decimal that is not a double, stands for the nearest double.
struct StudySubject {
  Study study;                ///< without densities, held parameters and starts, which belong to a fit
  Constants parameters = {};  ///< of the form, in the order in which they first appear
};

/// The subject of these constants of a study, in the order of its form: without what counts for a fit alone.
/// `fault_of` says whether they are those of the form.
StudySubject subject_of(Study study, const Constants& constants);

/// The fitted and the held values of a fit.
Constants constants_of(const Study& study, const StudyFit& fit);

/// One line that says why a subject is invalid, or an empty text: formulas that cannot be read, an
/// integral inside another one, or other parameters than those of the form.
std::string fault_of(const StudySubject& subject);

/// max |weight * error| lies in [lower, upper].
struct StudyCertificate {
  StudySubject subject;
  std::vector<Domain> ranges;  ///< of each variable, exact
  double lower = 0, upper = 0;
  std::vector<double> attained;  ///< here |weight * error| >= lower
  std::string boxes;             ///< on each |weight * error| <= upper; for `visit_boxes`
  int precision = 0;             ///< of the intervals, in bits
};

struct CertifiedStudy {
  StudyCertificate certificate;
  bool is_reached = false;  ///< whether the bounds have the requested width
};

/// The relative width of bounds that a search reaches within seconds: 1e-9 in one variable, 1e-6 in two, 1e-3
/// in three. The worst case is an error that is largest along a whole curve or surface; a single peak allows
/// far less.
double usual_study_width(std::size_t variables);

/// The most boxes of a search, and in one variable. A box is two characters of a certificate.
inline constexpr std::size_t most_study_boxes = 200'000, most_boxes_of_one_variable = 20'000;

/// The most boxes if a formula has an integral: each takes milliseconds.
inline constexpr std::size_t most_boxes_of_integrals = 4'000;

/// Proves bounds of the largest error by branch and bound over boxes of the variables. Their relative width
/// is `width`, or as near to it as `box_limit` boxes allow. The checkpoint is called for each box that is
/// cut. `known`, if any, has the integrals of earlier proofs, and receives those of this one. Throws
/// UserError if `fault_of` finds a fault in the subject, and for a width outside [least_width, 1);
/// CheckFailed, with the place, if no finite bound was proven.
CertifiedStudy certify_study(const StudySubject& subject, double width,
                             const Checkpoint& checkpoint = keep_going,
                             std::size_t box_limit = most_study_boxes, const KnownIntegrals* known = nullptr);

/// Whether a formula of numbers is exactly that double, as far as 50 digits tell.
bool is_exactly(const Study& study, const std::string& formula, double value);

/// How many boxes a certificate has.
std::size_t count_boxes(const StudyCertificate& certificate);

/// Checks a certificate again, only by evaluating the formulas on its boxes. Empty if all of it holds,
/// otherwise one line with the reason to refuse it. `done` is called for each box.
std::string reason_to_refuse(
    const StudyCertificate& certificate, const ShareDone& done = [](double) {});

}  // namespace shadefit
