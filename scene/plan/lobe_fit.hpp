#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "scene/plan/lobe_form.hpp"
#include "scene/plan/lobes.hpp"
#include "scene/plan/shown_scale.hpp"

/// Constants of the lobe's forms for a scene's own powers: those whose largest error that is shown, over all
/// of them, is least, and those whose mean error is least over the powers by how often they are used.
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
  /// `used`: what mean errors are over; without it there are none.
  LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale, std::span<const UsedPower> used = {});

  /// The offset x in [0, 16] of a Gaussian, to four decimals, by the golden section. A bright lobe is clamped
  /// up to t = n y = log g, and there (n + x) y = t + t^2/(2n) has x = t/2: at most 9.
  double best_offset();

  /// The slopes of log2(c) in y = c - 1, 2 to 4, each rounded to a float. By Lawson's iteration of weighted
  /// least squares: the error of a lobe is the slopes' times n, its own value and its factor. Source: Lawson
  /// 1961, "Contributions to the Theory of Linear Least Maximum Approximation", thesis, University of
  /// California.
  std::vector<double> best_slopes(int count);

  /// The form with the constants of the least mean error, by least squares that are weighed anew: within some
  /// percent of it, and never above that of the form that is given. Its offset is at least 0.
  LobeForm best_on_the_mean(LobeForm form);

  /// How many times one of the above was asked for.
  int fits_run() const { return fits_run_; }

  /// The largest error that is shown of a form by slopes, sampled: from below. Once it is above `enough`, it
  /// is looked for no further.
  double sampled_error(std::span<const double> slopes, double offset, double enough = HUGE_VAL) const;

  /// The root of the mean square error that is shown of a form by slopes, by a light that shows most of it:
  /// over all cosines alike, as normals of a sphere have them, and over the powers by how often each is used.
  /// After a fit that asked for it.
  double mean_error(const LobeForm& form) const;

 private:
  /// A lobe at a place.
  struct Sample {
    double power;
    double y;              ///< 1 - c
    double log_cosine;     ///< log c
    double log_brightest;  ///< of what the lobe is multiplied by there, at most
  };
  /// A place that all lobes have in common.
  struct WeightedPlace {
    double y, log_cosine;
    double width;  ///< of the cosines that it stands for
    double worth;  ///< of an error of log c to the lobe that it is worth most to
  };
  /// The sums over the used powers n of width * share * u^2, times 1, n and n^2: u is what the logarithm of a
  /// lobe is worth.
  using PlaceSums = std::array<double, 3>;
  struct MeanSquare {
    double square = 0;
    std::vector<PlaceSums> places = {};
  };

  std::vector<WeightedPlace> weighted_places() const;
  MeanSquare mean_square(const LobeForm& form) const;
  LobeForm reweighted(LobeForm form, const MeanSquare& mean) const;

  std::vector<Lobe> lobes_;  ///< one of the powers of each, above 0, by rising power
  std::vector<Sample> samples_;
  std::vector<UsedPower> used_;        ///< with those within a tenth taken together
  std::vector<WeightedPlace> places_;  ///< made by the first fit that needs them
  ShownScale scale_;
  int fits_run_ = 0;
};

}  // namespace shadefit::scene
