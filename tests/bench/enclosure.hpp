#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <vector>

#include "fit/proof/bound_width.hpp"
#include "fit/proof/interval.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/support/checkpoint.hpp"
#include "tests/bench/box.hpp"

/// The proven maximum of the magnitude of a function of the cosine, by interval branch and bound.
namespace shadefit {

/// The most boxes of a search. The catalogue's fits take 30 to 500.
inline constexpr int most_boxes = 20000;

struct EnclosureOptions {
  double width = usual_width;  ///< relative to the largest magnitude
  std::optional<ExactPlace> hint =
      {};                  ///< the probable place of the maximum: gives a good lower bound from the start
  int boxes = most_boxes;  ///< the search gives up at this number
  double least = 0;        ///< magnitudes up to this one are ignored
  Checkpoint checkpoint = keep_going;  ///< called for each box that is cut
};

/// [lower, upper] contains max |f|, or `EnclosureOptions::least` if that is larger.
struct Enclosure {
  double lower = 0;
  double upper = 0;
  ExactPlace attained;           ///< here |f| >= lower
  std::vector<Box> places = {};  ///< outside these |f| <= lower; by rising cosine
  std::vector<Box> boxes = {};   ///< all boxes of the domain, by rising cosine; on each |f| <= upper
  bool is_reached = false;       ///< whether the requested width is reached
};

/// A continuous function of the cosine, type-erased so that the search is compiled only once. Where it has a
/// kink, its derivatives enclose those of both branches.
class EnclosedFunction {
 public:
  using Jet = ceres::Jet<Interval, 1>;

  /// `f` is a template over the cosine's scalar.
  template <class F>
  requires(!std::same_as<F, EnclosedFunction>) EnclosedFunction(const F& f) : value_(f), jet_(f) {}

  Interval operator()(const Cosine<Interval>& c) const { return value_(c); }
  Jet operator()(const Cosine<Jet>& c) const { return jet_(c); }

 private:
  std::function<Interval(const Cosine<Interval>&)> value_;
  std::function<Jet(const Cosine<Jet>&)> jet_;
};

/// Encloses max |f| over a domain: see `Enclosure`. `is_reached` is false if f is unbounded or needs more
/// boxes than allowed; the bounds hold nevertheless.
Enclosure enclose_largest(const EnclosedFunction& f, const Domain& domain,
                          const EnclosureOptions& options = {});

}  // namespace shadefit
