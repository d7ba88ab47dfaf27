#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/fit.hpp"
#include "fit/proof/box.hpp"
#include "fit/proof/constants.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// The data of a proof of a largest error: enough to check the proof again without repeating the search.
namespace shadefit {

/// The subject of a proof: one form with its constants, and the domain.
struct Subject {
  std::string family;
  Constants parameters = {};  ///< in the order of the family's names
  Setting setting = {};
  Error error = Error::absolute;
  Domain domain = {};
  bool operator==(const Subject&) const = default;
};

/// One line that says why a subject is invalid, or an empty text. Faults: an unknown family; a parameter that
/// is missing, unknown, repeated, out of order or not a finite number; an exponent or a surface that is
/// invalid or that the family does not have; a domain outside [0, 1].
std::string fault_of(const Subject& subject);

/// The result of proving one property of a curve.
enum class Proof {
  none,     ///< the record does not state it
  proven,   ///< on the whole domain
  refuted,  ///< it certainly fails at a place that was found
  open,     ///< undecided within the allowed number of boxes
};

constexpr std::string_view name(Proof proof) {
  switch (proof) {
    case Proof::none:
      return "none";
    case Proof::proven:
      return "proven";
    case Proof::refuted:
      return "refuted";
    case Proof::open:
      return "open";
  }
  return "";
}

constexpr std::string_view name(Trend trend) {
  return trend == Trend::none ? "none" : trend == Trend::falls ? "falls" : "rises";
}

/// max |error| lies in [lower, upper].
struct Certificate {
  Subject subject;
  std::string target, form;  ///< the formulas as text
  double lower = 0;
  double upper = 0;
  ExactPlace attained;      ///< here |error| >= lower
  std::vector<Box> places;  ///< outside these |error| <= lower; by rising cosine
  /// The domain cut into boxes: for each side, the rising distances at which one box ends and the next
  /// begins. On each box |error| <= upper.
  std::vector<double> horizon, peak;
  CurveShape curve;   ///< the properties proven for the form on the domain; `none` where nothing is proven
  int precision = 0;  ///< of the intervals, in bits
  bool operator==(const Certificate&) const = default;
};

/// The results for the properties that the record states of a form's curve, over the domain of the proof.
struct CurveProof {
  Proof trend = Proof::none;
  Proof non_negative = Proof::none;
  Proof at_most_one = Proof::none;
};

/// A certificate, whether its bounds reach the requested width, and the proof of the curve's properties.
struct Certified {
  Certificate certificate;
  bool is_reached = false;
  CurveProof curve = {};
};

/// The cosines of a box, rounded outward.
Domain cosines_of(const Box& box);

/// Throws UserError for a relative width of bounds outside [least_width, 1).
void require_width(double width);

/// Proves bounds of the largest error of a subject, of relative width `width`, and the properties that the
/// record states of the form's curve. For a relative error, the domain is narrowed to where it is defined.
/// The checkpoint is called for each box. Throws UserError for a `fault_of` the subject, for a width outside
/// [least_width, 1), and for a relative error that is not defined anywhere.
Certified certify(const Subject& subject, double width, const Checkpoint& checkpoint = keep_going);

/// The subject of a fit, its parameters exact.
Subject subject_of(const Fit& fit, Error error = Error::absolute);

/// One line that says what is wrong with the bounds of a certificate or with the precision, in bits, in which
/// it was made; or an empty text.
std::string fault_of_bounds(double lower, double upper, int precision);

/// The finished fraction of a check, from 0 to 1; throws to stop it.
using ShareDone = std::function<void(double share)>;

/// Checks a certificate again, only by evaluating the formula on its boxes. Empty if everything in it holds,
/// else one line with the reason to refuse it. `done` is called for each box.
std::string reason_to_refuse(
    const Certificate& certificate, const ShareDone& done = [](double) {});

}  // namespace shadefit
