#include "fit/proof/error_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <optional>
#include <vector>

#include "fit/proof/certified_formula.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/scalars/taylor.hpp"

namespace shadefit {
namespace {

/// A box and the centre of its series.
struct CentredBox {
  Box box;
  double centre;
};

double middle(double lower, double upper) {
  return lower + (upper - lower) / 2;
}

/// The domain as boxes, each with at most one of the places.
std::vector<CentredBox> boxes_around(std::span<const Cosine<double>> peaks, const Domain& domain) {
  std::vector<CentredBox> boxes;
  for (const Box& box : boxes_of(domain)) {
    std::vector<double> inside;
    for (const Cosine<double>& peak : peaks) {
      const ExactPlace place = place_of(peak);
      if (is_inside(place, {box})) inside.push_back(place.distance);
    }
    std::ranges::sort(inside);
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    if (inside.empty()) inside.push_back(middle(box.lower, box.upper));
    double lower = box.lower;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const double upper = i + 1 < inside.size() ? middle(inside[i], inside[i + 1]) : box.upper;
      boxes.push_back({{box.side, lower, upper}, inside[i]});
      lower = upper;
    }
  }
  return boxes;
}

/// The order of the series. Errors are small differences of a form and its target, so remainders of low order
/// are far larger than the error. Beyond six the report gets no faster.
constexpr int order = 6;

/// The values of a series on a whole box, with `step` the interval around the centre: value + slope step +
/// step^2 (..). At a peak the slope is 0, and the sign of the bracket reduces |error|. So a peak takes a few
/// boxes; a bound by first derivatives takes dozens.
Interval values_on(const Taylor<order - 1, Interval>& at_centre, const Interval& remainder,
                   const Interval& step) {
  Interval bracket = remainder;
  for (int i = order - 1; i >= 2; --i) bracket = at_centre[i] + step * bracket;
  return at_centre.value() + at_centre[1] * step + power(step, 2) * bracket;
}

/// An error for the scalars of this file, type-erased.
class SeriesFunction : public EnclosedFunction {
 public:
  template <class F>
  requires(!std::same_as<F, SeriesFunction>) SeriesFunction(const F& f)
      : EnclosedFunction(f), at_centre_(f), on_box_(f) {}

  using EnclosedFunction::operator();
  Taylor<order - 1, Interval> operator()(const Cosine<Taylor<order - 1, Interval>>& c) const {
    return at_centre_(c);
  }
  Taylor<order, Interval> operator()(const Cosine<Taylor<order, Interval>>& c) const { return on_box_(c); }

 private:
  std::function<Taylor<order - 1, Interval>(const Cosine<Taylor<order - 1, Interval>>&)> at_centre_;
  std::function<Taylor<order, Interval>(const Cosine<Taylor<order, Interval>>&)> on_box_;
};

/// Proves that |error| exceeds its largest value at the peaks by less than `width`: on each box by a Taylor
/// series with enclosed remainder. Empty if the boxes become too small or too many, as at a kink.
std::optional<ErrorBounds> bounds_by_series(const SeriesFunction& error, const Domain& domain,
                                            std::span<const Cosine<double>> peaks, double width,
                                            const Checkpoint& checkpoint) {
  std::vector<CentredBox> open = boxes_around(peaks, domain);
  double lower = 0;
  const auto raise = [&](const Interval& value) { lower = std::fmax(lower, smallest_magnitude_in(value)); };
  for (const auto& [box, centre] : open) raise(error(cosine_at(box.side, Interval(centre))));
  const auto is_below = [&](const Interval& value) {
    return largest_magnitude_in(value) <= lower * (1 + width);
  };
  for (int boxes = 0; !open.empty(); ++boxes) {
    checkpoint();
    const auto [box, centre] = open.back();
    open.pop_back();
    const Interval distance = span_of(box.lower, box.upper);
    const auto on_box = error(cosine_at(box.side, Taylor<order, Interval>::variable(distance)));
    if (is_below(on_box.value())) continue;
    const auto at_centre =
        error(cosine_at(box.side, Taylor<order - 1, Interval>::variable(Interval(centre))));
    raise(at_centre.value());
    const Interval step = distance - Interval(centre);
    if (is_below(values_on(at_centre, on_box[order], step))) continue;
    const double cut = middle(box.lower, box.upper);
    if (boxes > most_boxes || !(box.lower < cut && cut < box.upper)) return std::nullopt;
    for (const Box& half : {Box{box.side, box.lower, cut}, Box{box.side, cut, box.upper}}) {
      const bool has_centre = half.lower <= centre && centre <= half.upper;
      open.push_back({half, has_centre ? centre : middle(half.lower, half.upper)});
    }
  }
  return ErrorBounds{lower, lower * (1 + width), true};
}

ErrorBounds bounds_of(const SeriesFunction& error, const Domain& domain,
                      std::span<const Cosine<double>> peaks, double width, const Checkpoint& checkpoint) {
  // half, so that the rounding of the bound itself stays within the width
  if (const auto bounds = bounds_by_series(error, domain, peaks, width / 2, checkpoint)) return *bounds;
  const Enclosure found = enclose_largest(
      error, domain, {.width = width, .hint = place_of(peaks.front()), .checkpoint = checkpoint});
  return {found.lower, found.upper, found.is_reached};
}

/// The integral over a domain, split where a surface's reflectance has a kink or stops falling.
template <class F>
double integral(const F& f, const Domain& domain, const Surface& surface) {
  constexpr double tolerance = 1e-12;  // far below the printed digits of an rms error
  const auto joint = joint_of(surface);
  if (!joint || joint->cosine <= domain.lower || joint->cosine >= domain.upper)
    return tanh_sinh(f, domain.lower, domain.upper, tolerance).value;
  return tanh_sinh(f, domain.lower, joint->cosine, tolerance).value +
         tanh_sinh(f, joint->cosine, domain.upper, tolerance).value;
}

}  // namespace

ErrorBounds bound_error(const Subject& subject, std::span<const Cosine<double>> peaks, double width,
                        const Checkpoint& checkpoint) {
  const SeriesFunction error =
      visit_formula(subject, [](const auto& f, const auto&) { return SeriesFunction(f); });
  return bounds_of(error, subject.domain, peaks, width, checkpoint);
}

SchlickError schlick_error(const Surface& surface, const Domain& domain, double width,
                           const Checkpoint& checkpoint) {
  const auto error = [&]<class T>(const Cosine<T>& c) {
    const T f0 = normal_reflectance<T>(surface);
    return T((integer<T>(1) - f0) * (schlick_weight(c.cos_theta) - target_weight(surface, c.cos_theta)));
  };
  const auto relative = [&]<class T>(const Cosine<T>& c) {
    return T(error(c) / exact_reflectance(surface, c.cos_theta));
  };
  const auto squared = [&](double c) { return std::pow(error(Cosine<double>{c, 1 - c}), 2); };
  const auto panels =
      Substitution::panels({.domain = domain}, Shape{.joint = joint_of(surface)}.for_search());
  SchlickError result{.bounds = {},
                      .absolute = largest_magnitude(error, panels),
                      .relative = largest_magnitude(relative, panels),
                      .rms = std::sqrt(integral(squared, domain, surface) / (domain.upper - domain.lower))};
  result.bounds = bounds_of(error, domain, std::array{result.absolute.at}, width, checkpoint);
  return result;
}

}  // namespace shadefit
