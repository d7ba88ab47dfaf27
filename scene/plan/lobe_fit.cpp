#include "scene/plan/lobe_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "approx/shading.hpp"
#include "fit/exchange/surface_programme.hpp"
#include "fit/support/decompositions.hpp"

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
  std::vector<LobeFitter::Lobe> kept;
  double first = 0;
  for (const WeightedPower& lobe : lobes) {
    if (lobe.power.most > neighbours * first) {
      first = lobe.power.most;
      kept.push_back({lobe.power.most, lobe.factor});
    } else if (!kept.empty() && lobe.factor > kept.back().factor) {
      kept.back() = {lobe.power.most, lobe.factor};
    }
  }
  return kept;
}

/// An upper bound of the multiplier of a lobe at y: its factor times the light there.
double brightest_at(double factor, double y) {
  return factor * std::min(1.0, 2 * (1 - y));
}

/// The weight of a small error in the logarithm of a displayed value.
double worth_of_logarithm(ShownScale scale, double shown) {
  constexpr double little = 1e-3;
  return apart_by_ratio(scale, shown, little) / little;
}

/// Rounds each slope to a float.
std::vector<double> rounded(const Eigen::VectorXd& slopes) {
  std::vector<double> result;
  for (const double slope : slopes) result.push_back(static_cast<double>(static_cast<float>(slope)));
  return result;
}

}  // namespace

LobeFitter::LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale)
    : lobes_(thinned(lobes)), scale_(scale) {
  for (const Lobe& lobe : lobes_) {
    const auto add = [&](double y, double log_cosine) {
      samples_.push_back({lobe.power, y, log_cosine, std::log(brightest_at(lobe.factor, y))});
    };
    for (double t = first_t; t < last_t && t < lobe.power / 2; t *= step)
      add(t / lobe.power, std::log1p(-t / lobe.power));
    for (double c = 0.5; c > last_cosine; c /= step) add(1 - c, std::log(c));
  }
}

void LobeFitter::weigh_places() {
  const auto add = [&](double y, double log_cosine) {
    double worth = 0;
    for (const Lobe& lobe : lobes_) {
      const double shown = brightest_at(lobe.factor, y) * std::exp(lobe.power * log_cosine);
      worth = std::max(worth, lobe.power * worth_of_logarithm(scale_, shown));
    }
    places_.push_back({y, log_cosine, worth});
  };
  for (double y = first_t / std::max(1.0, lobes_.back().power); y < 0.5; y *= step) add(y, std::log1p(-y));
  for (double c = 0.5; c > last_cosine; c /= step) add(1 - c, std::log(c));
}

double LobeFitter::sampled_error(std::span<const double> slopes, double offset) const {
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
    largest = error;
    log_largest = std::log(from_scale(scale_, largest));
  }
  return largest;
}

double LobeFitter::best_offset() const {
  const std::array slope{natural_slope};
  constexpr double most = 16;
  constexpr int bits = 20;
  // The maximum of functions that first fall and then rise has the same shape.
  return boost::math::tools::brent_find_minima([&](double offset) { return sampled_error(slope, offset); },
                                               0.0, most, bits)
      .first;
}

std::vector<double> LobeFitter::best_slopes(int count) {
  if (places_.empty()) weigh_places();
  // log2(c) by slopes, one row for each place
  Eigen::MatrixXd powers(std::ssize(places_), count);
  Eigen::VectorXd target(powers.rows()), worth(powers.rows());
  for (Eigen::Index i = 0; i < powers.rows(); ++i) {
    const WeightedPlace& place = places_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < count; ++j) powers(i, j) = std::pow(-place.y, static_cast<double>(j + 1));
    target[i] = place.log_cosine / std::numbers::ln2;
    worth[i] = place.worth;
  }
  const auto step = level_step(-target.cwiseProduct(worth), worth.asDiagonal() * powers, 0);
  // Lobes so dull that no place counts for all slopes have those of least squares.
  if (!step) return rounded(solution(pivoted_qr(worth.asDiagonal() * powers), worth.cwiseProduct(target)));
  return rounded(Eigen::Map<const Eigen::VectorXd>(step->lowest.unknowns.data(), count));
}

}  // namespace shadefit::scene
