#include "scene/lobe_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "approx/shading.hpp"

namespace shadefit::scene {
namespace {

constexpr double golden = std::numbers::phi - 1;

/// Neighbouring powers want the same constants.
constexpr double neighbours = 1.1;

/// Where the error of a lobe is looked at. Near its peak at t = n y from 0.05 in steps of a twentieth up to
/// 44, where e^-44 leaves nothing of the largest factor, 1e8; so many see an error to a percent. What is left
/// of it towards the horizon, at c from 1/2 in such steps down to 1/2000, where hardly any light is.
constexpr double first_t = 0.05, last_t = 44, step = 1.05;
constexpr double last_cosine = 1.0 / 2000;

std::vector<LobeFitter::Lobe> thinned(std::span<const WeightedPower> lobes) {
  std::vector<LobeFitter::Lobe> all, kept;
  for (const WeightedPower& lobe : lobes) {
    if (lobe.power.most > 0) all.push_back({lobe.power.most, lobe.factor});
  }
  std::sort(all.begin(), all.end(),
            [](const LobeFitter::Lobe& a, const LobeFitter::Lobe& b) { return a.power < b.power; });
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

/// What a lobe is multiplied by at y, at most: its factor, and the light that reaches it there.
double brightest_at(const LobeFitter::Lobe& lobe, double y) {
  return lobe.factor * std::min(1.0, 2 * (1 - y));
}

}  // namespace

LobeFitter::LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale)
    : lobes_(thinned(lobes)), scale_(scale) {
  for (const Lobe& lobe : lobes_) {
    const auto add = [&](double y, double log_cosine) {
      samples_.push_back({lobe.power, y, log_cosine, std::log(brightest_at(lobe, y))});
    };
    for (double t = first_t; t < last_t && t < lobe.power / 2; t *= step)
      add(t / lobe.power, std::log1p(-t / lobe.power));
    for (double c = 0.5; c > last_cosine; c /= step) add(1 - c, std::log(c));
  }
}

std::vector<LobeFitter::WeightedPlace> LobeFitter::weighted_places() const {
  std::vector<WeightedPlace> all;
  const auto add = [&](double y, double log_cosine) {
    double worth = 0;
    for (const Lobe& lobe : lobes_) {
      const double shown = brightest_at(lobe, y) * std::exp(lobe.power * log_cosine);
      constexpr double little = 1e-3;  // an error, and with it the slope of what is shown
      worth = std::max(worth, lobe.power / little * apart_by_ratio(scale_, shown, little));
    }
    all.push_back({y, log_cosine, worth});
  };
  double y = first_t / std::max(1.0, lobes_.back().power);
  for (; y < 0.5; y *= step) add(y, std::log1p(-y));
  for (double c = 0.5; c > last_cosine; c /= step) add(1 - c, std::log(c));
  return all;
}

double LobeFitter::sampled_error(std::span<const double> slopes, double offset, double enough) const {
  const double white = on_scale(scale_, 1);
  double largest = 0, log_largest = -HUGE_VAL;
  for (const Sample& sample : samples_) {
    const double target = sample.power * sample.log_cosine;
    const double form = (sample.power + offset) * std::numbers::ln2 * log2_by_slopes(-sample.y, slopes);
    if (std::abs(form - target) * white <= largest) continue;  // no value moves by more than its share
    const double log_shown = sample.log_brightest + std::max(form, target);
    if (log_shown < log_largest) continue;  // nor by more than all of it
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
  // The largest of functions that fall and then rise does so too. Of the larger of two errors it does not
  // matter how large it is: it is never looked at again.
  const auto error = [&](double offset, double other) { return sampled_error(slope, offset, other); };
  double low = 0, high = 16;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double error_at_a = error(a, HUGE_VAL), error_at_b = error(b, error_at_a);
  constexpr double near = 1e-4;
  while (high - low > near) {
    if (error_at_a <= error_at_b) {
      high = b;
      b = a;
      error_at_b = error_at_a;
      a = high - golden * (high - low);
      error_at_a = error(a, error_at_b);
    } else {
      low = a;
      a = b;
      error_at_a = error_at_b;
      b = low + golden * (high - low);
      error_at_b = error(b, error_at_a);
    }
  }
  return low + (high - low) / 2;
}

std::vector<double> LobeFitter::best_slopes(int count) {
  ++fits_run_;
  if (places_.empty()) places_ = weighted_places();
  const auto rows = static_cast<Eigen::Index>(places_.size());
  Eigen::MatrixXd powers(rows, count);
  Eigen::VectorXd target(rows), worth(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const WeightedPlace& place = places_[static_cast<std::size_t>(i)];
    worth[i] = place.worth;
    for (Eigen::Index j = 0; j < count; ++j) powers(i, j) = std::pow(-place.y, static_cast<double>(j + 1));
    target[i] = place.log_cosine / std::numbers::ln2;
  }
  // |error|, weighed by what it is worth, becomes level where it is largest.
  Eigen::VectorXd level = Eigen::VectorXd::Constant(rows, 1.0 / static_cast<double>(rows));
  Eigen::VectorXd best = Eigen::VectorXd::Zero(count);
  double least = HUGE_VAL;
  constexpr int iterations = 60;
  for (int i = 0; i < iterations; ++i) {
    const Eigen::VectorXd root = (level.array().sqrt() * worth.array()).matrix();
    const Eigen::VectorXd slopes =
        (root.asDiagonal() * powers).colPivHouseholderQr().solve(root.cwiseProduct(target));
    const Eigen::VectorXd error = (powers * slopes - target).cwiseAbs().cwiseProduct(worth);
    if (error.maxCoeff() < least) {
      least = error.maxCoeff();
      best = slopes;
    }
    level = level.cwiseProduct(error);
    const double sum = level.sum();
    if (!(sum > 0)) break;
    level /= sum;
  }
  std::vector<double> rounded;
  for (const double slope : best) rounded.push_back(static_cast<double>(static_cast<float>(slope)));
  return rounded;
}

}  // namespace shadefit::scene
