#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/fit.hpp"
#include "fit/proof/box.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// What a proof of a largest error says, in values: enough to check it again without the search that found
/// it.
namespace shadefit {

/// What a proof is about: one form with its constants, and where.
struct Subject {
  std::string family;
  /// Name and value of each, in the order of the family's names. A value is a decimal text as it was printed,
  /// which no double need be and which the proof encloses; or, of a fit, a hexadecimal double.
  std::vector<std::pair<std::string, std::string>> parameters = {};
  Setting setting = {};
  Error error = Error::absolute;
  Domain domain = {};
  bool operator==(const Subject&) const = default;
};

/// Why a subject is none, a line: an unknown family; a parameter that is missing, unknown, doubled, out of
/// order or no finite number; an exponent or a surface that the family does not have or that cannot be; a
/// domain that is not within [0, 1]. Empty where nothing is wrong.
std::string fault_of(const Subject& subject);

/// What became of one property of a curve.
enum class Proof {
  none,     ///< the record says nothing of it
  proven,   ///< on the whole domain
  refuted,  ///< a place was found where it fails, beyond doubt
  open,     ///< neither, with the boxes that there may be
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
  std::string target, form;  ///< the formulas as they print themselves
  double lower = 0;
  double upper = 0;
  ExactPlace attained;      ///< here |error| >= lower
  std::vector<Box> places;  ///< outside of these |error| <= lower; by rising cosine
  /// The domain cut into boxes: the distances of their ends from either side, rising, each the end of one box
  /// and the start of the next. On each box |error| <= upper.
  std::vector<double> horizon, peak;
  CurveShape curve;   ///< what is proven of the form on the domain, nothing where it is not
  int precision = 0;  ///< of the intervals, in bits
  bool operator==(const Certificate&) const = default;
};

/// What became of what the record says of a form's curve, over the domain of the proof.
struct CurveProof {
  Proof trend = Proof::none;
  Proof non_negative = Proof::none;
  Proof at_most_one = Proof::none;
};

/// A certificate, whether its bounds are as near as was asked, and what of the curve could be proven.
struct Certified {
  Certificate certificate;
  bool is_reached = false;
  CurveProof curve = {};
};

/// The cosines of a box, rounded outward.
Domain cosines_of(const Box& box);

/// Proves bounds of the largest error of a subject, `width` apart relative to it, and what the record says of
/// the form's curve. A relative error is looked for where it has a meaning, which narrows the domain. The
/// checkpoint is called for each box. Throws UserError for a `fault_of` the subject, a width that is not in
/// [least_width, 1), and where a relative error has no meaning anywhere.
Certified certify(const Subject& subject, double width, const Checkpoint& checkpoint = keep_going);

/// The subject of a fit, its parameters exact.
Subject subject_of(const Fit& fit, Error error = Error::absolute);

/// How much of a check is done, from 0 to 1; throws to end it.
using ShareDone = std::function<void(double share)>;

/// Checks a certificate again, by evaluations of the formula on its boxes alone. Empty where all that it says
/// holds, else the reason to refuse it, a line. `done` is called for each box.
std::string reason_to_refuse(
    const Certificate& certificate, const ShareDone& done = [](double) {});

}  // namespace shadefit
