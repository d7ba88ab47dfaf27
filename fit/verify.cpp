#include <algorithm>
#include <cmath>

#include "fit/certificate.hpp"
#include "fit/certified_formula.hpp"
#include "fit/hex_float.hpp"
#include "fit/interval_ends.hpp"

/// The check of a certificate. It shares the formula with the search and nothing else: it neither chooses nor
/// cuts a box.
namespace shadefit {
namespace {

using Jet = ceres::Jet<Interval, 1>;

std::string text_of(const Box& box) {
  return std::string(box.side == Origin::peak ? "1 - c" : "c") + " in [" + hex_text(box.lower) + ", " +
         hex_text(box.upper) + "]";
}

bool is_finite(double x) {
  return std::isfinite(x);
}

std::string check_subject(const Certificate& certificate) {
  const Subject& subject = certificate.subject;
  const FittableFamily* family = find_family(subject.family);
  if (family == nullptr) return "there is no family '" + subject.family + "'";
  if (certificate.form != to_text(family->form()))
    return "the form '" + certificate.form + "' is not the family's " + to_text(family->form());
  const std::string target = target_text(*family, subject.setting);
  if (certificate.target != target)
    return "the target '" + certificate.target + "' is not the family's " + target;
  if (subject.parameters.size() != family->parameters.size()) return "a parameter is missing, or too much";
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    const auto& [name, value] = subject.parameters[i];
    if (name != family->parameters[i]) return "the family has no parameter '" + name + "' in that place";
    if (!enclosed_constant(value)) return "the parameter " + name + " '" + value + "' is no finite number";
  }
  if (family->has_exponent() && !(subject.setting.exponent > 0 && is_finite(subject.setting.exponent)))
    return "the exponent is not greater than 0";
  const Domain& domain = subject.domain;
  if (!(0 <= domain.lower && domain.lower < domain.upper && domain.upper <= 1))
    return "the domain is not within [0, 1]";
  if (!(0 <= certificate.lower && certificate.lower <= certificate.upper && is_finite(certificate.upper)))
    return "its bounds are no interval";
  // Only a wider arithmetic than was used can hold what was proven with it.
  if (certificate.precision <= 0 || certificate.precision > interval_precision())
    return "it was made with " + std::to_string(certificate.precision) + " bits, here are " +
           std::to_string(interval_precision());
  return "";
}

/// The boxes of a side between two distances, where the ends say that they cover it.
std::string check_cover(const std::vector<double>& ends, Origin side, double from, double to) {
  const std::string where = side == Origin::peak ? "1 - c" : "c";
  if (from >= to) return ends.empty() ? "" : "there are boxes in " + where + " outside of the domain";
  if (ends.size() < 2 || ends.front() != from || ends.back() != to)
    return "the boxes in " + where + " do not reach from " + hex_text(from) + " to " + hex_text(to);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!(ends[i] < ends[i + 1]))
      return "the ends of the boxes in " + where + " do not rise at " + hex_text(ends[i]);
  }
  return "";
}

std::vector<Box> boxes_in(const Certificate& certificate) {
  std::vector<Box> boxes;
  const auto append = [&](Origin side, const std::vector<double>& ends) {
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) boxes.push_back({side, ends[i], ends[i + 1]});
  };
  append(Origin::horizon, certificate.horizon);
  append(Origin::peak, certificate.peak);
  return boxes;
}

/// Whether |error| <= bound on a box: by its range; by its range around the middle, f(m) + f'(box) (box - m);
/// or, where it does not turn, at both ends.
template <class Function>
bool is_bounded_by(const Function& error, const Box& box, double bound) {
  const Interval distance = span_of(box.lower, box.upper);
  const auto value_at = [&](double place) { return error(cosine_at(box.side, Interval(place))); };
  const auto fits = [&](const Interval& value) { return largest_magnitude_in(value) <= bound; };
  const Jet range = error(cosine_at(box.side, Jet(distance, 0)));
  if (fits(range.a)) return true;
  // Without its derivative a formula may be narrower: a Jet's maximum is the hull of what it chooses from.
  if (!is_bounded(range.a)) return fits(error(cosine_at(box.side, distance)));
  const Interval& slope = range.v[0];
  if (!is_bounded(slope)) return false;
  const double inner = box.lower + (box.upper - box.lower) / 2;
  if (fits(value_at(inner) + slope * (distance - Interval(inner)))) return true;
  return has_one_sign(slope) && fits(value_at(box.lower)) && fits(value_at(box.upper));
}

template <class Function>
std::string check_bounds(const Certificate& certificate, const std::vector<Box>& boxes,
                         const Function& error) {
  const ExactPlace& place = certificate.attained;
  const bool is_in_domain = std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    return box.side == place.side && box.lower <= place.distance && place.distance <= box.upper;
  });
  if (!is_in_domain) return "the place of its lower bound is outside of the domain";
  const Interval attained = error(cosine_at(place.side, Interval(place.distance)));
  if (!(smallest_magnitude_in(attained) >= certificate.lower))
    return "the error does not reach the lower bound at its place: it is at most " +
           hex_text(largest_magnitude_in(attained));
  for (const Box& box : boxes) {
    const auto holds_box = [&](const Box& outer) {
      return outer.side == box.side && outer.lower <= box.lower && box.upper <= outer.upper;
    };
    const bool is_a_place = std::any_of(certificate.places.begin(), certificate.places.end(), holds_box);
    if (!is_bounded_by(error, box, is_a_place ? certificate.upper : certificate.lower))
      return "the error may exceed the " +
             std::string(is_a_place ? "upper bound" : "lower bound outside of its places") + " at " +
             text_of(box);
  }
  return "";
}

template <class Form>
std::string check_curve(const CurveShape& curve, const std::vector<Box>& boxes, const Form& form) {
  for (const Box& box : boxes) {
    const Jet value = form(cosine_at(box.side, Jet(span_of(box.lower, box.upper), 0)));
    // c falls as the angle rises, 1 - c rises with it.
    const bool falls_with_distance = (curve.trend == Trend::falls) == (box.side == Origin::peak);
    const bool goes = falls_with_distance ? is_never_positive(value.v[0]) : is_never_negative(value.v[0]);
    if (curve.trend != Trend::none && !goes) return "the form may turn at " + text_of(box);
    if (curve.is_non_negative && !is_never_negative(value.a))
      return "the form may be negative at " + text_of(box);
    if (curve.is_at_most_one && !(upper_end(value.a) <= 1)) return "the form may exceed 1 at " + text_of(box);
  }
  return "";
}

}  // namespace

std::string reason_to_refuse(const Certificate& certificate) {
  if (const auto reason = check_subject(certificate); !reason.empty()) return reason;
  const Domain& domain = certificate.subject.domain;
  const double half = 0.5;
  if (const auto reason =
          check_cover(certificate.horizon, Origin::horizon, domain.lower, std::min(domain.upper, half));
      !reason.empty())
    return reason;
  if (const auto reason =
          check_cover(certificate.peak, Origin::peak, 1 - domain.upper, std::min(1 - domain.lower, half));
      !reason.empty())
    return reason;
  const std::vector<Box> boxes = boxes_in(certificate);
  return visit_formula(certificate.subject, [&](const auto& error, const auto& form, const auto&) {
    const std::string reason = check_bounds(certificate, boxes, error);
    return reason.empty() ? check_curve(certificate.curve, boxes, form) : reason;
  });
}

}  // namespace shadefit
