#include <algorithm>
#include <cmath>

#include "fit/proof/certificate.hpp"
#include "fit/proof/certified_formula.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/support/hex_float.hpp"

/// The check of a certificate. It shares the formula and the interval arithmetic with the search. It neither
/// chooses nor cuts a box.
namespace shadefit {
namespace {

using Jet = EnclosedFunction::Jet;

std::string text_of(const Box& box) {
  return std::string(box.side == Origin::peak ? "1 - c" : "c") + " in [" + hex_text(box.lower) + ", " +
         hex_text(box.upper) + "]";
}

std::string check_subject(const Certificate& certificate) {
  const Subject& subject = certificate.subject;
  if (std::string fault = fault_of(subject); !fault.empty()) return fault;
  const FittableFamily& family = *find_family(subject.family);
  if (const std::string form = to_text(family.form()); certificate.form != form)
    return "the form '" + certificate.form + "' is not the family's " + form;
  if (const std::string target = target_text(family, subject.setting); certificate.target != target)
    return "the target '" + certificate.target + "' is not the family's " + target;
  return fault_of_bounds(certificate.lower, certificate.upper, certificate.precision);
}

/// Whether all cosines of a box are at most those of another.
bool cosine_rises(const Box& from, const Box& to) {
  if (from.side != to.side) return from.side == Origin::horizon;
  return from.side == Origin::horizon ? from.upper <= to.lower : to.upper <= from.lower;
}

/// Where the places are parts of the domain by rising cosine, none within another.
std::string check_places(const Certificate& certificate) {
  const std::vector<Box> domain = boxes_of(certificate.subject.domain);
  const auto& places = certificate.places;
  if (places.empty()) return "it names no place of the largest error";
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Box& place = places[i];
    if (!(place.lower <= place.upper) || !is_inside({place.side, place.lower}, domain) ||
        !is_inside({place.side, place.upper}, domain))
      return "the place " + text_of(place) + " is not within the domain";
    if (i > 0 && !cosine_rises(places[i - 1], place))
      return "the place " + text_of(place) + " does not follow the one before";
  }
  return "";
}

/// Whether a box lies in a place where the largest error may be.
bool is_in_a_place(const Box& box, const std::vector<Box>& places) {
  const auto place =
      std::ranges::partition_point(places, [&](const Box& before) { return cosine_rises(before, box); });
  return place != places.end() && place->side == box.side && place->lower <= box.lower &&
         box.upper <= place->upper;
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
bool is_bounded_by(const EnclosedFunction& error, const Box& box, double bound) {
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

std::string check_attained(const Certificate& certificate, const EnclosedFunction& error) {
  const ExactPlace& place = certificate.attained;
  if (!is_inside(place, boxes_of(certificate.subject.domain)))
    return "the place of its lower bound is outside of the domain";
  const Interval attained = error(cosine_at(place.side, Interval(place.distance)));
  if (smallest_magnitude_in(attained) >= certificate.lower) return "";
  return "the error does not reach the lower bound at its place: it is at most " +
         hex_text(largest_magnitude_in(attained));
}

std::string check_curve(const CurveShape& curve, const Box& box, const EnclosedFunction& form) {
  const Jet value = form(cosine_at(box.side, Jet(span_of(box.lower, box.upper), 0)));
  // c falls as the angle rises, 1 - c rises with it.
  const bool falls_with_distance = (curve.trend == Trend::falls) == (box.side == Origin::peak);
  const bool goes = falls_with_distance ? is_never_positive(value.v[0]) : is_never_negative(value.v[0]);
  if (curve.trend != Trend::none && !goes) return "the form may turn at " + text_of(box);
  if (curve.is_non_negative && !is_never_negative(value.a))
    return "the form may be negative at " + text_of(box);
  if (curve.is_at_most_one && !(upper_end(value.a) <= 1)) return "the form may exceed 1 at " + text_of(box);
  return "";
}

std::string check_cover(const Certificate& certificate) {
  const Domain& domain = certificate.subject.domain;
  std::string reason =
      check_cover(certificate.horizon, Origin::horizon, domain.lower, std::min(domain.upper, half_way));
  if (!reason.empty()) return reason;
  return check_cover(certificate.peak, Origin::peak, 1 - domain.upper, std::min(1 - domain.lower, half_way));
}

std::string check_boxes(const Certificate& certificate, const ShareDone& done) {
  const auto [error, form] = certified_formula(certificate.subject);
  if (std::string reason = check_attained(certificate, error); !reason.empty()) return reason;
  const std::vector<Box> boxes = boxes_in(certificate);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    done(static_cast<double>(i) / static_cast<double>(boxes.size()));
    const Box& box = boxes[i];
    const bool is_a_place = is_in_a_place(box, certificate.places);
    if (!is_bounded_by(error, box, is_a_place ? certificate.upper : certificate.lower))
      return "the error may exceed the " +
             std::string(is_a_place ? "upper bound" : "lower bound outside of its places") + " at " +
             text_of(box);
    if (std::string reason = check_curve(certificate.curve, box, form); !reason.empty()) return reason;
  }
  return "";
}

}  // namespace

std::string fault_of_bounds(double lower, double upper, int precision) {
  if (!(0 <= lower && lower <= upper && std::isfinite(upper))) return "its bounds are not an interval";
  // A proof holds again only in an arithmetic that is at least as wide.
  if (precision <= 0 || precision > interval_precision())
    return "it was made with " + std::to_string(precision) + " bits, this build uses " +
           std::to_string(interval_precision());
  return "";
}

std::string reason_to_refuse(const Certificate& certificate, const ShareDone& done) {
  if (std::string reason = check_subject(certificate); !reason.empty()) return reason;
  if (std::string reason = check_cover(certificate); !reason.empty()) return reason;
  if (std::string reason = check_places(certificate); !reason.empty()) return reason;
  return check_boxes(certificate, done);
}

}  // namespace shadefit
