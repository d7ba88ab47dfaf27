#pragma once

#include <span>
#include <vector>

#include "scene/plan/lobe_form.hpp"
#include "scene/plan/shown_scale.hpp"

/// How far a form of the lobe may move a picture: bounds that are proven.
///
/// What is shown of a light is min(g w t, 1): t = c^n the lobe, w = n.l, g anything up to the largest
/// F (n + 2)/8. Where the viewer sees the surface, n.v >= 0, and l = 2 (h.l) h - v gives n.l <= 2 c: at
/// grazing half vectors there is little light, w <= min(1, 2 c). With a form f in place of t, f/t = e^r, the
/// larger of both shown values is at most v = min(1, g min(1, 2c) max(f, t)), and they are apart by no more
/// than v (1 - e^-|r|), or by the same of encoded values.
///
/// For all forms by slopes ln f = ln t + n d(c) with a `bend` d that no power enters, and of a Gaussian with
/// an offset - x y besides. So the cosines are cut into cells once, d is enclosed on each by intervals, and a
/// bound for one more power, or all powers between two, is a walk over the cells. Cells are 2 % wide, and so
/// are the bounds.
namespace shadefit::scene {

/// A part of the cosines, and what of a form is there the same for every power.
struct LobeCell {
  double weight;               ///< min(1, 2c), at most
  double log_target;           ///< log c, at most
  double log_form;             ///< the form's in its place, at most
  double y_low, y_high;        ///< 1 - c
  double bend_low, bend_high;  ///< the form's logarithm minus log c; the highest may be infinite
  double bend_so_far = 0;      ///< the largest magnitude of one here and nearer to the peak
  double log_from_here = 0;    ///< the largest logarithm here and farther from it
};

/// A form by slopes on all cosines.
class LobeCells {
 public:
  /// For powers up to `largest_power`, at least 1. At least one slope.
  LobeCells(std::span<const double> slopes, double largest_power);

  /// The largest difference between what is shown of any of the lobes, and of the form: not exceeded, in
  /// exact arithmetic. An offset >= 0 is that of the one slope `natural_slope`, else it is 0. `enough`: where
  /// it is no more, it is only proven to be no more.
  double largest_error(const WeightedPower& lobes, double offset, ShownScale scale, double enough) const;

 private:
  std::vector<LobeCell> cells_;
};

}  // namespace shadefit::scene
