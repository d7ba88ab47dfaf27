#include "tests/bench/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "fit/proof/interval_ends.hpp"

namespace shadefit {
namespace {

/// A box and an upper bound of |f| on it.
struct BoundedBox {
  Box box;
  double bound;
  bool operator<(const BoundedBox& other) const { return bound < other.bound; }
};

/// The search itself.
class LargestSearch {
 public:
  LargestSearch(const EnclosedFunction& f, const EnclosureOptions& options)
      : f_(f), options_(options), lower_(options.least) {}

  Enclosure search(const std::vector<Box>& domain) {
    for (const Box& box : domain) raise({box.side, box.lower});
    if (options_.hint && is_inside(*options_.hint, domain)) raise(*options_.hint);
    for (const Box& box : domain) add(box);
    bool is_reached = false;
    while (!(is_reached = boxes_.top().bound - lower_ <= options_.width * lower_) &&
           static_cast<int>(boxes_.size()) < options_.boxes) {
      options_.checkpoint();
      const Box box = boxes_.top().box;
      const double centre = box.lower + (box.upper - box.lower) / 2;
      if (!(box.lower < centre && centre < box.upper)) break;  // lower and upper are neighbouring doubles
      boxes_.pop();
      add({box.side, box.lower, centre});
      add({box.side, centre, box.upper});
    }
    return collected(is_reached);
  }

 private:
  using Jet = EnclosedFunction::Jet;

  void add(const Box& box) { boxes_.push({box, bound_on(box)}); }

  /// |f| on a box: its natural extension, or the mean-value form f(m) + f'(box) (box - m), whose excess falls
  /// with the square of the width. Where f' has one sign, the larger value of the two ends.
  double bound_on(const Box& box) {
    const Interval distance = span_of(box.lower, box.upper);
    const Jet value = f_(cosine_at(box.side, Jet(distance, 0)));
    double natural = largest_magnitude_in(value.a);
    // At a kink under a root, the maximum of Jets is the hull of both branches; the maximum of intervals is
    // narrower.
    if (std::isinf(natural)) natural = largest_magnitude_in(f_(cosine_at(box.side, distance)));
    if (natural <= lower_ || !is_bounded(value.v[0])) return natural;
    const double centre = box.lower + (box.upper - box.lower) / 2;
    const Interval mean = raise({box.side, centre}) + value.v[0] * (distance - Interval(centre));
    const double bound = std::fmin(natural, largest_magnitude_in(mean));
    if (bound <= lower_ || !has_one_sign(value.v[0])) return bound;
    const Interval left = raise({box.side, box.lower}), right = raise({box.side, box.upper});
    return std::fmin(bound, std::fmax(largest_magnitude_in(left), largest_magnitude_in(right)));
  }

  /// Evaluates f at a place and raises the lower bound if |f| is larger.
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
    Enclosure result{.lower = lower_,
                     .upper = std::fmax(boxes_.top().bound, lower_),
                     .attained = attained_,
                     .is_reached = is_reached};
    std::vector<BoundedBox> all;
    for (; !boxes_.empty(); boxes_.pop()) all.push_back(boxes_.top());
    std::ranges::sort(all, [](const BoundedBox& a, const BoundedBox& b) {
      if (a.box.side != b.box.side) return a.box.side == Origin::horizon;
      return (a.box.side == Origin::horizon) == (a.box.lower < b.box.lower);
    });
    for (const auto& [box, bound] : all) {
      result.boxes.push_back(box);
      if (bound > lower_) append(result.places, box);
    }
    // If the upper bound of a box equals the attained maximum exactly, no box is left above it.
    if (result.places.empty())
      result.places.push_back({attained_.side, attained_.distance, attained_.distance});
    return result;
  }

  /// Merges adjacent places and places with a small gap. Around a maximum, the box that contains it may be
  /// finished before its neighbours of about the same size.
  static void append(std::vector<Box>& places, const Box& box) {
    if (!places.empty() && places.back().side == box.side) {
      Box& last = places.back();
      const Box both{box.side, std::fmin(last.lower, box.lower), std::fmax(last.upper, box.upper)};
      constexpr double little = 8;  // gaps up to this many times the wider place are merged
      const double widest = std::fmax(last.upper - last.lower, box.upper - box.lower);
      const double gap = both.upper - both.lower - (last.upper - last.lower) - (box.upper - box.lower);
      if (gap <= little * widest) {
        last = both;
        return;
      }
    }
    places.push_back(box);
  }

  const EnclosedFunction& f_;
  EnclosureOptions options_;
  std::priority_queue<BoundedBox> boxes_;
  double lower_;
  ExactPlace attained_;
};

}  // namespace

Enclosure enclose_largest(const EnclosedFunction& f, const Domain& domain, const EnclosureOptions& options) {
  return LargestSearch(f, options).search(boxes_of(domain));
}

}  // namespace shadefit
