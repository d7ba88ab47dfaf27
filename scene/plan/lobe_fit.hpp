#pragma once

#include <span>
#include <vector>

#include "scene/plan/lobe_form.hpp"
#include "scene/plan/shown_scale.hpp"

/// Fits the constants of the lobe's forms to a scene's powers, for the smallest largest displayed error.
namespace shadefit::scene {

class LobeFitter {
 public:
  /// A lobe of the fit.
  struct Lobe {
    double power, factor;
  };

  /// The lobes by rising power, at least one of them above 0. Neighbours within 10 % are merged into the one
  /// with the largest factor.
  LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale);

  /// The offset x in [0, 16] of a Gaussian, by Brent's method. A bright lobe is clamped up to t = n y = log
  /// g. There (n + x) y = t + t^2/(2n) gives x = t/2: at most 9.
  double best_offset() const;

  /// The slopes of log2(c) in y = c - 1, 2 to 4, each rounded to a float, by the exchange
  /// (fit/exchange/surface_programme.hpp): the error of a lobe is the error of the slopes times n, the
  /// lobe's value and its factor.
  std::vector<double> best_slopes(int count);

  /// The largest displayed error of a form by slopes, sampled: a lower bound.
  double sampled_error(std::span<const double> slopes, double offset) const;

 private:
  /// A lobe at a place.
  struct Sample {
    double power;
    double y;              ///< 1 - c
    double log_cosine;     ///< log c
    double log_brightest;  ///< upper bound of the lobe's multiplier there
  };
  /// A place shared by all lobes.
  struct WeightedPlace {
    double y, log_cosine;
    double worth;  ///< largest weight of an error of log c over all lobes
  };

  void weigh_places();

  std::vector<Lobe> lobes_;  ///< merged, with power above 0, by rising power
  std::vector<Sample> samples_;
  std::vector<WeightedPlace> places_;  ///< computed by the first fit that needs them
  ShownScale scale_;
};

}  // namespace shadefit::scene
