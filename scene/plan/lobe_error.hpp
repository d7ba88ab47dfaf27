#pragma once

#include <span>
#include <vector>

#include "scene/plan/lobe_form.hpp"
#include "scene/plan/shown_scale.hpp"

/// Proven bounds of the error of a picture by a form of the lobe.
///
/// The displayed value of a light is min(g w t, 1): t = c^n the lobe, w = n.l, g any value up to the largest
/// F (n + 2)/8. If the viewer sees the surface, n.v >= 0, and l = 2 (h.l) h - v gives n.l <= 2 c. So there is
/// little light at grazing half vectors: w <= min(1, 2 c). Let a form f replace t, with f/t = e^r. The larger
/// displayed value is at most v = min(1, g min(1, 2c) max(f, t)). The two values differ by at most v (1 -
/// e^-|r|); for encoded values the same ratio is applied before the encoding.
///
/// For all forms by slopes, ln f = ln t + n d(c), where the `bend` d does not depend on the power. An offset
/// of a Gaussian adds - x y. So the cosines are cut into cells once, and intervals enclose d on each cell. A
/// bound for another power, or for all powers between two, only needs a walk over the cells. Cells and bounds
/// are 2 % wide.
namespace shadefit::scene {

/// A range of cosines, and the values of a form there that are the same for every power.
struct LobeCell {
  double weight;               ///< upper bound of min(1, 2c)
  double log_target;           ///< upper bound of log c
  double log_form;             ///< upper bound of the form's value in place of log c
  double y_low, y_high;        ///< 1 - c
  double bend_low, bend_high;  ///< the form's logarithm minus log c; `bend_high` may be infinite
  double bend_so_far = 0;      ///< the largest |bend| of this cell and those nearer to the peak
  double log_from_here = 0;    ///< the largest logarithm of this cell and those farther from the peak
};

/// A form by slopes on all cosines.
class LobeCells {
 public:
  /// For powers up to `largest_power`, at least 1. At least one slope.
  LobeCells(std::span<const double> slopes, double largest_power);

  /// An upper bound, in exact arithmetic, of the difference between the displayed values of any of the lobes
  /// and of the form. `offset` >= 0 belongs to the single slope `natural_slope`, else it is 0. If the bound
  /// is at most `enough`, only that is proven.
  double largest_error(const WeightedPower& lobes, double offset, ShownScale scale, double enough) const;

 private:
  std::vector<LobeCell> cells_;
};

}  // namespace shadefit::scene
