#include <algorithm>
#include <cmath>

#include "fit/bounds/enclosed_error.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

/// The check of a certificate. It shares the formulas and their enclosure on a box with the search. It
/// neither chooses nor cuts a box.
namespace shadefit {
namespace {

std::string range_text(double lower, double upper) {
  return "[" + hex_text(lower) + ", " + hex_text(upper) + "]";
}

std::string check_ranges(const StudyCertificate& certificate, const ReadStudy& study) {
  if (certificate.ranges.size() != study.axes.size()) return "it does not have one range for each variable";
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    const StudyAxis& axis = study.axes[i];
    const Domain& range = certificate.ranges[i];
    if (range.lower != axis.lower || range.upper != axis.upper)
      return "the range of " + axis.variable + " is not " + range_text(range.lower, range.upper) +
             ": the doubles of its formulas are " + range_text(axis.lower, axis.upper);
  }
  return "";
}

std::string check_attained(const StudyCertificate& certificate, EnclosedError& error) {
  const std::vector<double>& place = certificate.attained;
  bool is_inside = place.size() == certificate.ranges.size();
  for (std::size_t i = 0; is_inside && i < place.size(); ++i)
    is_inside = certificate.ranges[i].lower <= place[i] && place[i] <= certificate.ranges[i].upper;
  if (!is_inside) return "the place of its lower bound is outside of the ranges";
  const Interval attained = error.at(place);
  if (smallest_magnitude_in(attained) >= certificate.lower) return "";
  return "the error does not reach the lower bound at its place: it is at most " +
         hex_text(largest_magnitude_in(attained));
}

std::string check_boxes(const StudyCertificate& certificate, const ReadStudy& study, EnclosedError& error,
                        const ShareDone& done) {
  const auto all = static_cast<double>(count_boxes(certificate));
  double finished = 0;
  return visit_boxes(error.ranges(), certificate.boxes, [&](const StudyBox& box) -> std::string {
    done(finished++ / all);
    if (error.bound_on(box, certificate.upper).bound <= certificate.upper) return "";
    std::string reason = "the error may exceed the upper bound at";
    for (std::size_t i = 0; i < box.size(); ++i) {
      const Interval numbers = numbers_of(box[i], error.ranges()[i]);
      reason += " " + study.axes[i].variable + " in " + range_text(lower_end(numbers), upper_end(numbers));
    }
    return reason;
  });
}

/// A proof holds again only in an arithmetic that is at least as wide.
std::string fault_of_bounds(const StudyCertificate& certificate) {
  if (!(0 <= certificate.lower && certificate.lower <= certificate.upper && std::isfinite(certificate.upper)))
    return "its bounds are not an interval";
  if (certificate.precision <= 0 || certificate.precision > interval_precision())
    return "it was made with " + std::to_string(certificate.precision) + " bits, this build uses " +
           std::to_string(interval_precision());
  return "";
}

}  // namespace

std::string fault_of(const StudySubject& subject) {
  try {
    const ReadStudy study = read_formulas(subject.study);
    if (integral_depth(error_formula(study)) > 1)
      return "an 'integral' inside another one has no proof; a truth such as ggx_albedo is one";
    return fault_of_constants(subject.parameters, study.parameters, "the form");
  } catch (const UserError& error) {
    return error.what();
  }
}

bool is_exactly(const Study& study, const std::string& formula, double value) {
  const auto no_variable = [](const std::string&) { return Interval(0); };
  const Interval number = evaluate<Interval>(numbers_in(study, {"--over"}, formula), no_variable);
  return lower_end(number) == value && upper_end(number) == value;
}

std::size_t count_boxes(const StudyCertificate& certificate) {
  return static_cast<std::size_t>(std::ranges::count(certificate.boxes, '.'));
}

std::string reason_to_refuse(const StudyCertificate& certificate, const ShareDone& done) {
  if (std::string fault = fault_of(certificate.subject); !fault.empty()) return fault;
  const ReadStudy study = read_formulas(certificate.subject.study);
  if (std::string reason = check_ranges(certificate, study); !reason.empty()) return reason;
  if (std::string fault = fault_of_bounds(certificate); !fault.empty()) return fault;
  const Constants& constants = certificate.subject.parameters;
  EnclosedError error(without_equal_terms(study, constants), enclosed_constants(constants));
  if (std::string reason = check_attained(certificate, error); !reason.empty()) return reason;
  return check_boxes(certificate, study, error, done);
}

}  // namespace shadefit
