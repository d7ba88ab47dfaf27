#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <vector>

#include "fit/box.hpp"
#include "fit/interval.hpp"
#include "fit/interval_ends.hpp"
#include "fit/jet.hpp"

/// Where a function of the cosine is largest in magnitude, as a theorem: interval branch and bound.
namespace shadefit {

/// The relative width that bounds have where nothing else is asked: far below any digit that is printed.
inline constexpr double usual_width = 1e-9;
/// The ends of an enclosure are doubles: narrower than a few of their steps of 2.2e-16 it cannot be.
inline constexpr double least_width = 1e-15;
/// Boxes after which a search is given up. The catalogue's fits take 30 to 500.
inline constexpr int most_boxes = 20000;

struct EnclosureOptions {
  double width = usual_width;           ///< relative to the largest magnitude
  std::optional<ExactPlace> hint = {};  ///< where it probably is: a good lower bound from the start
  int boxes = most_boxes;               ///< the search gives up when it has as many
  double least = 0;                     ///< a magnitude up to this one is of no interest
};

/// max |f|, or `EnclosureOptions::least` where that is more, lies in [lower, upper].
struct Enclosure {
  double lower = 0;
  double upper = 0;
  ExactPlace attained;      ///< here |f| >= lower
  std::vector<Box> places;  ///< outside of these |f| <= lower; by rising cosine
  std::vector<Box> boxes;   ///< all that the domain was cut into, by rising cosine; on each |f| <= upper
  bool is_reached = false;  ///< the width that was asked for
};

/// A box and an upper bound of |f| on it.
struct BoundedBox {
  Box box;
  double bound;
  bool operator<(const BoundedBox& other) const { return bound < other.bound; }
};

/// The search itself. `F` maps a Cosine<T> to a T for T = Interval and Jet<Interval, 1>, and is continuous:
/// where it has a kink, its derivatives enclose those of both branches.
template <class F>
class LargestSearch {
 public:
  LargestSearch(const F& f, const EnclosureOptions& options)
      : f_(f), options_(options), lower_(options.least) {}

  Enclosure search(const std::vector<Box>& domain) {
    for (const Box& box : domain) raise({box.side, box.lower});
    if (options_.hint && is_inside(*options_.hint, domain)) raise(*options_.hint);
    for (const Box& box : domain) add(box);
    bool is_reached = false;
    while (!(is_reached = boxes_.top().bound - lower_ <= options_.width * lower_) &&
           static_cast<int>(boxes_.size()) < options_.boxes) {
      const Box box = boxes_.top().box;
      const double centre = box.lower + (box.upper - box.lower) / 2;
      if (!(box.lower < centre && centre < box.upper)) break;  // two neighbouring doubles
      boxes_.pop();
      add({box.side, box.lower, centre});
      add({box.side, centre, box.upper});
    }
    return collected(is_reached);
  }

 private:
  using Jet = ceres::Jet<Interval, 1>;

  void add(const Box& box) { boxes_.push({box, bound_on(box)}); }

  /// |f| on a box: its natural extension, or the mean-value form f(m) + f'(box) (box - m), whose error falls
  /// with the square of the width; where f' has one sign, the larger of both ends.
  double bound_on(const Box& box) {
    const Interval distance = span_of(box.lower, box.upper);
    const Jet value = f_(cosine_at(box.side, Jet(distance, 0)));
    double natural = largest_magnitude_in(value.a);
    // At a kink below a root a Jet's maximum is the hull of both branches, an interval's own is not.
    if (std::isinf(natural)) natural = largest_magnitude_in(f_(cosine_at(box.side, distance)));
    if (natural <= lower_ || !is_bounded(value.v[0])) return natural;
    const double centre = box.lower + (box.upper - box.lower) / 2;
    const Interval mean = raise({box.side, centre}) + value.v[0] * (distance - Interval(centre));
    const double bound = std::fmin(natural, largest_magnitude_in(mean));
    if (bound <= lower_ || !has_one_sign(value.v[0])) return bound;
    const Interval left = raise({box.side, box.lower}), right = raise({box.side, box.upper});
    return std::fmin(bound, std::fmax(largest_magnitude_in(left), largest_magnitude_in(right)));
  }

  /// f at a place, which may raise the lower bound.
  Interval raise(const ExactPlace& place) {
    const Interval value = f_(cosine_at(place.side, Interval(place.distance)));
    const double magnitude = smallest_magnitude_in(value);
    if (magnitude > lower_) {
      lower_ = magnitude;
      attained_ = place;
    }
    return value;
  }

  Enclosure collected(bool is_reached) {
    Enclosure result;
    result.lower = lower_;
    result.upper = std::fmax(boxes_.top().bound, lower_);
    result.attained = attained_;
    result.is_reached = is_reached;
    std::vector<BoundedBox> all;
    for (; !boxes_.empty(); boxes_.pop()) all.push_back(boxes_.top());
    std::sort(all.begin(), all.end(), [](const BoundedBox& a, const BoundedBox& b) {
      if (a.box.side != b.box.side) return a.box.side == Origin::horizon;
      return (a.box.side == Origin::horizon) == (a.box.lower < b.box.lower);
    });
    for (const auto& [box, bound] : all) {
      result.boxes.push_back(box);
      if (bound > lower_) append(result.places, box);
    }
    // A largest magnitude that a box's bound proves to be attained exactly leaves no box above it.
    if (result.places.empty())
      result.places.push_back({attained_.side, attained_.distance, attained_.distance});
    return result;
  }

  /// Neighbours become one, and so do places with little between them: around a maximum the box that holds it
  /// may be settled before those beside it, which are of about its size.
  static void append(std::vector<Box>& places, const Box& box) {
    if (!places.empty() && places.back().side == box.side) {
      Box& last = places.back();
      const Box both{box.side, std::fmin(last.lower, box.lower), std::fmax(last.upper, box.upper)};
      constexpr double little = 8;  // times as wide as what is left
      const double widest = std::fmax(last.upper - last.lower, box.upper - box.lower);
      const double gap = both.upper - both.lower - (last.upper - last.lower) - (box.upper - box.lower);
      if (gap <= little * widest) {
        last = both;
        return;
      }
    }
    places.push_back(box);
  }

  const F& f_;
  EnclosureOptions options_;
  std::priority_queue<BoundedBox> boxes_;
  double lower_;
  ExactPlace attained_;
};

/// Encloses max |f| over a domain: see `Enclosure`. `is_reached` is false where f is not bounded, or too
/// rough for the boxes there may be: what is said holds all the same.
template <class F>
Enclosure enclose_largest(const F& f, const Domain& domain, const EnclosureOptions& options = {}) {
  return LargestSearch<F>(f, options).search(boxes_of(domain));
}

}  // namespace shadefit
