#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "scene/plan/lobe_form.hpp"
#include "scene/plan/lobes.hpp"
#include "scene/plan/shown_scale.hpp"

/// Fits the constants of the lobe's forms to a scene's powers: for the smallest largest displayed error over
/// all powers, and for the smallest mean error over the powers, weighted by their use.
namespace shadefit::scene {

/// Fits constants and counts the fits.
class LobeFitter {
 public:
  /// A lobe of the fit.
  struct Lobe {
    double power, factor;
  };

  /// At least one of `lobes` must have a power above 0. Neighbours within 10 % are merged into the one with
  /// the largest factor. `used`: the powers of mean errors; without them there are no mean errors.
  LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale, std::span<const UsedPower> used = {});

  /// The offset x in [0, 16] of a Gaussian, by Brent's method. A bright lobe is clamped up to t = n y = log
  /// g. There (n + x) y = t + t^2/(2n) gives x = t/2: at most 9.
  double best_offset();

  /// The slopes of log2(c) in y = c - 1, 2 to 4, each rounded to a float, by the exchange
  /// (fit/minimax/linear_programme.hpp): the error of a lobe is the error of the slopes times n, the lobe's
  /// value and its factor.
  std::vector<double> best_slopes(int count);

  /// The form with the smallest mean error, by iteratively reweighted least squares: within a few percent of
  /// the optimum, and never worse than the given form. Its offset is at least 0.
  LobeForm best_on_the_mean(LobeForm form);

  /// The number of calls of the fits above.
  int fits_run() const { return fits_run_; }

  /// The largest displayed error of a form by slopes, sampled: a lower bound. The search stops once the error
  /// exceeds `enough`.
  double sampled_error(std::span<const double> slopes, double offset, double enough = HUGE_VAL) const;

  /// The root mean square displayed error of a form by slopes, for the light that shows the largest error.
  /// Cosines are uniform, as for the normals of a sphere; powers are weighted by their use. Call it after a
  /// fit for the mean error.
  double mean_error(const LobeForm& form) const;

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
    double width;  ///< of the range of cosines that it represents
    double worth;  ///< largest weight of an error of log c over all lobes
  };
  /// The sums over the used powers n of width * share * u^2, times 1, n and n^2: u is the weight of the
  /// logarithm of a lobe.
  using PlaceSums = std::array<double, 3>;
  struct MeanSquare {
    double square = 0;
    std::vector<PlaceSums> places = {};
  };

  std::vector<WeightedPlace> weighted_places() const;
  MeanSquare mean_square(const LobeForm& form) const;
  LobeForm reweighted(LobeForm form, const MeanSquare& mean) const;

  std::vector<Lobe> lobes_;  ///< merged, with power above 0, by rising power
  std::vector<Sample> samples_;
  std::vector<UsedPower> used_;        ///< powers within 10 % are merged
  std::vector<WeightedPlace> places_;  ///< computed by the first fit that needs them
  ShownScale scale_;
  int fits_run_ = 0;
};

}  // namespace shadefit::scene
