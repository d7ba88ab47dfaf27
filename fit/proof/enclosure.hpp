#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fit/proof/box.hpp"
#include "fit/proof/interval.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/support/checkpoint.hpp"

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
  Checkpoint checkpoint = keep_going;   ///< called for each box that is cut
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

/// A continuous function of the cosine, behind plain functions: the search is compiled once, and not for each
/// function. Where it has a kink, its derivatives enclose those of both branches.
struct EnclosedFunction {
  using Jet = ceres::Jet<Interval, 1>;

  std::function<Interval(const Cosine<Interval>&)> value;
  std::function<Jet(const Cosine<Jet>&)> jet;
};

/// Encloses max |f| over a domain: see `Enclosure`. `is_reached` is false where f is not bounded, or too
/// rough for the boxes there may be: what is said holds all the same.
Enclosure enclose_largest(const EnclosedFunction& f, const Domain& domain, const EnclosureOptions& options);

/// The same of a template over the cosine's scalar.
template <class F>
Enclosure enclose_largest(const F& f, const Domain& domain, const EnclosureOptions& options = {}) {
  const EnclosedFunction enclosed{[&f](const Cosine<Interval>& c) { return f(c); },
                                  [&f](const Cosine<EnclosedFunction::Jet>& c) { return f(c); }};
  return enclose_largest(enclosed, domain, options);
}

}  // namespace shadefit
