#include "scene/plan/lobe_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <numbers>

#include "approx/shading.hpp"
#include "fit/study_exchange/surface_programme.hpp"
#include "fit/study_squares/linear_optimum.hpp"

namespace shadefit::scene {
namespace {

/// Powers within this ratio need the same constants.
constexpr double neighbours = 1.1;

/// The samples of the error of a lobe. Near its peak: t = n y from 0.05 in steps of 5 % up to 44, where e^-44
/// cancels the largest factor, 1e8. This resolves an error to 1 %. Towards the horizon: c from 1/2 in the
/// same steps down to 1/2000, where there is hardly any light.
constexpr double first_t = 0.05, last_t = 44, step = 1.05;
constexpr double last_cosine = 1.0 / 2000;

std::vector<LobeFitter::Lobe> thinned(std::span<const WeightedPower> lobes) {
  std::vector<LobeFitter::Lobe> all, kept;
  for (const WeightedPower& lobe : lobes) {
    if (lobe.power.most > 0) all.push_back({lobe.power.most, lobe.factor});
  }
  std::ranges::sort(all, {}, &LobeFitter::Lobe::power);
  double first = 0;
  for (const LobeFitter::Lobe& lobe : all) {
    if (kept.empty() || lobe.power > neighbours * first) {
      first = lobe.power;
      kept.push_back(lobe);
    } else if (lobe.factor > kept.back().factor) {
      kept.back() = lobe;
    }
  }
  return kept;
}

/// Merges powers within 10 % into the first of them.
std::vector<UsedPower> taken_together(std::vector<UsedPower> used) {
  std::ranges::sort(used, {}, &UsedPower::power);
  std::vector<UsedPower> kept;
  for (const UsedPower& one : used) {
    if (one.power == 0) continue;
    if (kept.empty() || one.power > neighbours * kept.back().power) {
      kept.push_back(one);
    } else {
      kept.back().share += one.share;
    }
  }
  return kept;
}

/// An upper bound of the multiplier of a lobe at y: its factor times the light there.
double brightest_at(double factor, double y) {
  return factor * std::min(1.0, 2 * (1 - y));
}

/// The weight of a small error in the logarithm of a displayed value.
constexpr double little = 1e-3;
double worth_of_logarithm(ShownScale scale, double shown) {
  return apart_by_ratio(scale, shown, little) / little;
}

/// log2(c) by slopes, one row for each place.
struct SlopeRows {
  Eigen::MatrixXd powers;
  Eigen::VectorXd target;

  template <class Places>
  SlopeRows(const Places& places, std::size_t count) : powers(places.size(), count), target(places.size()) {
    for (Eigen::Index i = 0; i < powers.rows(); ++i) {
      const auto& place = places[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < powers.cols(); ++j)
        powers(i, j) = std::pow(-place.y, static_cast<double>(j + 1));
      target[i] = place.log_cosine / std::numbers::ln2;
    }
  }

  /// Least squares with each row times its `root`.
  Eigen::VectorXd solve(const Eigen::VectorXd& root) const {
    return least_squares(root.asDiagonal() * powers, root.cwiseProduct(target));
  }
};

/// Rounds each slope to a float.
std::vector<double> rounded(const Eigen::VectorXd& slopes) {
  std::vector<double> result;
  for (const double slope : slopes) result.push_back(static_cast<double>(static_cast<float>(slope)));
  return result;
}

}  // namespace

LobeFitter::LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale,
                       std::span<const UsedPower> used)
    : lobes_(thinned(lobes)), used_(taken_together({used.begin(), used.end()})), scale_(scale) {
  for (const Lobe& lobe : lobes_) {
    const auto add = [&](double y, double log_cosine) {
      samples_.push_back({lobe.power, y, log_cosine, std::log(brightest_at(lobe.factor, y))});
    };
    for (double t = first_t; t < last_t && t < lobe.power / 2; t *= step)
      add(t / lobe.power, std::log1p(-t / lobe.power));
    for (double c = 0.5; c > last_cosine; c /= step) add(1 - c, std::log(c));
  }
}

std::vector<LobeFitter::WeightedPlace> LobeFitter::weighted_places() const {
  std::vector<WeightedPlace> all;
  const auto add = [&](double y, double log_cosine, double width) {
    WeightedPlace place{y, log_cosine, width, 0};
    const auto shown = [&](double power, double factor) {
      return brightest_at(factor, y) * std::exp(power * log_cosine);
    };
    for (const Lobe& lobe : lobes_) {
      const double worth = worth_of_logarithm(scale_, shown(lobe.power, lobe.factor));
      place.worth = std::max(place.worth, lobe.power * worth);
    }
    all.push_back(place);
  };
  double y = first_t / std::max(1.0, lobes_.back().power);
  for (; y < 0.5; y *= step) add(y, std::log1p(-y), y * (step - 1));
  for (double c = 0.5; c > last_cosine; c /= step) add(1 - c, std::log(c), c * (step - 1));
  return all;
}

LobeFitter::MeanSquare LobeFitter::mean_square(const LobeForm& form) const {
  MeanSquare mean;
  for (const WeightedPlace& place : places_) {
    const double slope = std::numbers::ln2 * log2_by_slopes(-place.y, form.slopes);
    PlaceSums sums{};
    for (const UsedPower& one : used_) {
      const double log_target = one.power * place.log_cosine, log_form = (one.power + form.offset) * slope;
      const double log_larger = std::max(log_target, log_form);
      if (log_larger < -last_t) continue;
      const double shown = brightest_at(one.factor, place.y) * std::exp(log_larger);
      const double apart = log_form - log_target;
      const double error = apart_by_ratio(scale_, shown, apart);
      mean.square += place.width * one.share * error * error;
      const double worth = std::abs(apart) > little ? error / apart : worth_of_logarithm(scale_, shown);
      double sum = place.width * one.share * worth * worth;
      for (double& of_power : sums) {
        of_power += sum;
        sum *= one.power;
      }
    }
    mean.places.push_back(sums);
  }
  return mean;
}

double LobeFitter::mean_error(const LobeForm& form) const {
  return std::sqrt(mean_square(form).square);
}

/// The error of a lobe's logarithm is n bend - x y, where bend is the error of log c by the slopes. With
/// fixed weights of the logarithms, the problem is linear.
LobeForm LobeFitter::reweighted(LobeForm form, const MeanSquare& mean) const {
  if (form.slopes.size() == 1) {
    double along = 0, square = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const WeightedPlace& place = places_[i];
      const double bend = std::numbers::ln2 * log2_by_slopes(-place.y, form.slopes) - place.log_cosine;
      along += mean.places[i][1] * bend * place.y;
      square += mean.places[i][0] * place.y * place.y;
    }
    if (square > 0) form.offset = std::max(0.0, along / square);
    return form;
  }
  const SlopeRows rows(places_, form.slopes.size());
  Eigen::VectorXd root(rows.target.size());
  for (Eigen::Index i = 0; i < root.size(); ++i)
    root[i] = std::sqrt(mean.places[static_cast<std::size_t>(i)][2]);
  form.slopes = rounded(rows.solve(root));
  return form;
}

LobeForm LobeFitter::best_on_the_mean(LobeForm form) {
  ++fits_run_;
  if (places_.empty()) places_ = weighted_places();
  MeanSquare best = mean_square(form);
  constexpr int most_times = 2;  // a third gains less than a percent
  for (int time = 0; time < most_times; ++time) {
    const LobeForm next = reweighted(form, best);
    MeanSquare mean = mean_square(next);
    constexpr double hardly = 0.98;  // stops if the square falls by less than 2 %, the error by less than 1 %
    const bool goes_on = mean.square < hardly * best.square;
    if (mean.square < best.square) {
      form = next;
      best = std::move(mean);
    }
    if (!goes_on) break;
  }
  return form;
}

double LobeFitter::sampled_error(std::span<const double> slopes, double offset, double enough) const {
  const double white = on_scale(scale_, 1);
  double largest = 0, log_largest = -HUGE_VAL;
  for (const Sample& sample : samples_) {
    const double target = sample.power * sample.log_cosine;
    const double form = (sample.power + offset) * std::numbers::ln2 * log2_by_slopes(-sample.y, slopes);
    if (std::abs(form - target) * white <= largest)
      continue;  // no value changes by more than its relative error
    const double log_shown = sample.log_brightest + std::max(form, target);
    if (log_shown < log_largest) continue;  // nor by more than the whole value
    const double error = apart_by_ratio(scale_, std::exp(log_shown), form - target);
    if (error <= largest) continue;
    if (error > enough) return error;
    largest = error;
    log_largest = std::log(from_scale(scale_, largest));
  }
  return largest;
}

double LobeFitter::best_offset() {
  ++fits_run_;
  const std::array slope{natural_slope};
  constexpr double most = 16;
  constexpr int bits = 20;
  // The maximum of functions that first fall and then rise has the same shape.
  return boost::math::tools::brent_find_minima([&](double offset) { return sampled_error(slope, offset); },
                                               0.0, most, bits)
      .first;
}

std::vector<double> LobeFitter::best_slopes(int count) {
  ++fits_run_;
  if (places_.empty()) places_ = weighted_places();
  const SlopeRows rows(places_, static_cast<std::size_t>(count));
  Eigen::VectorXd worth(rows.target.size());
  for (Eigen::Index i = 0; i < worth.size(); ++i) worth[i] = places_[static_cast<std::size_t>(i)].worth;
  const auto step = level_step(-rows.target.cwiseProduct(worth), worth.asDiagonal() * rows.powers, 0);
  // Lobes so dull that no place counts for all slopes have those of least squares.
  if (!step) return rounded(rows.solve(worth));
  return rounded(Eigen::Map<const Eigen::VectorXd>(step->lowest.unknowns.data(), count));
}

}  // namespace shadefit::scene
