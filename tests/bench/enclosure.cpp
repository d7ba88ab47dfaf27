#include "tests/bench/enclosure.hpp"

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
  LargestSearch(const EnclosedFunction& f, double width) : f_(f), width_(width) {}

  Enclosure search(const std::vector<Box>& domain) {
    constexpr int most_boxes = 20000;
    for (const Box& box : domain) raise({box.side, box.lower});
    for (const Box& box : domain) add(box);
    while (boxes_.top().bound - lower_ > width_ * lower_ && static_cast<int>(boxes_.size()) < most_boxes) {
      const Box box = boxes_.top().box;
      const double centre = box.lower + (box.upper - box.lower) / 2;
      if (!(box.lower < centre && centre < box.upper)) break;  // lower and upper are neighbouring doubles
      boxes_.pop();
      add({box.side, box.lower, centre});
      add({box.side, centre, box.upper});
    }
    return {lower_, std::fmax(boxes_.top().bound, lower_)};
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
    lower_ = std::fmax(lower_, smallest_magnitude_in(value));
    return value;
  }

  const EnclosedFunction& f_;
  double width_;
  std::priority_queue<BoundedBox> boxes_;
  double lower_ = 0;
};

}  // namespace

Enclosure enclose_largest(const EnclosedFunction& f, const Domain& domain, double width) {
  return LargestSearch(f, width).search(boxes_of(domain));
}

}  // namespace shadefit
