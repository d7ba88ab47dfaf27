#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "scene/lobe_form.hpp"
#include "scene/shown_scale.hpp"

/// Constants of the lobe's forms for a scene's own powers: those whose largest error that is shown, over all
/// of them, is least.
namespace shadefit::scene {

/// Solves for constants, and counts how often.
class LobeFitter {
 public:
  /// What is fitted.
  struct Lobe {
    double power, factor;
  };

  /// `lobes` of which one has a power above 0. Many are thinned out: of neighbours within a tenth the one
  /// with the largest factor stands for all.
  LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale);

  /// The offset x in [0, 16] of a Gaussian, to four decimals, by the golden section. A bright lobe is clamped
  /// up to t = n y = log g, and there (n + x) y = t + t^2/(2n) has x = t/2: at most 9.
  double best_offset();

  /// The slopes of log2(c) in y = c - 1, 2 to 4, each rounded to a float. By Lawson's iteration of weighted
  /// least squares: the error of a lobe is the slopes' times n, its own value and its factor. Source: Lawson
  /// 1961, "Contributions to the Theory of Linear Least Maximum Approximation", thesis, University of
  /// California.
  std::vector<double> best_slopes(int count);

  /// How many times one of the above was asked for.
  int fits_run() const { return fits_run_; }

  /// The largest error that is shown of a form by slopes, sampled: from below. Once it is above `enough`, it
  /// is looked for no further.
  double sampled_error(std::span<const double> slopes, double offset, double enough = HUGE_VAL) const;

 private:
  /// A lobe at a place.
  struct Sample {
    double power;
    double y;              ///< 1 - c
    double log_cosine;     ///< log c
    double log_brightest;  ///< of what the lobe is multiplied by there, at most
  };
  /// A place of Lawson's iteration: what an error of the logarithm is worth there to the lobe that it is
  /// worth most to.
  struct WeightedPlace {
    double y, log_cosine, worth;
  };

  std::vector<WeightedPlace> weighted_places() const;

  std::vector<Lobe> lobes_;  ///< one of the powers of each, above 0, by rising power
  std::vector<Sample> samples_;
  std::vector<WeightedPlace> places_;  ///< made by the first fit of slopes
  ShownScale scale_;
  int fits_run_ = 0;
};

}  // namespace shadefit::scene
