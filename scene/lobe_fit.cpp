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

/// Where the error of a lobe is looked at: t = n y from 0.05 in steps of a twentieth up to 44, where e^-44
/// leaves nothing of the largest factor, 1e8; so many see an error to a percent.
constexpr int places = 140;
constexpr double first_t = 0.05, next_t = 1.05;

/// y = 1 - c at one of them.
double place(int i, double power) {
  return std::min(1.0, first_t * std::pow(next_t, i) / power);
}

std::vector<WeightedPower> thinned(std::span<const WeightedPower> lobes) {
  std::vector<WeightedPower> all(lobes.begin(), lobes.end()), kept;
  std::sort(all.begin(), all.end(),
            [](const WeightedPower& a, const WeightedPower& b) { return a.power < b.power; });
  double first = 0;
  for (const WeightedPower& lobe : all) {
    if (kept.empty() || lobe.power > neighbours * first) {
      first = lobe.power;
      kept.push_back(lobe);
    } else if (lobe.factor > kept.back().factor) {
      kept.back() = lobe;
    }
  }
  return kept;
}

/// The largest value shown of a lobe at y.
double largest_shown(const WeightedPower& lobe, double y, double log_larger) {
  return lobe.factor * std::min(1.0, 2 * (1 - y)) * std::exp(log_larger);
}

/// A place of Lawson's iteration: of all lobes what an error of the logarithm is worth there.
struct WeightedPlace {
  double y, worth;
};

/// The lobes' places together, each with the most that it is worth to any lobe.
std::vector<WeightedPlace> weighted_places(std::span<const WeightedPower> lobes, ShownScale scale) {
  const double least = first_t / lobes.back().power;
  std::vector<WeightedPlace> all;
  for (double y = least; y < 1; y *= next_t) {
    double worth = 0;
    for (const WeightedPower& lobe : lobes) {
      const double shown = largest_shown(lobe, y, lobe.power * std::log1p(-y));
      constexpr double little = 1e-3;
      worth = std::max(worth, lobe.power / little * apart_by_ratio(scale, shown, little));
    }
    if (worth > 0) all.push_back({y, worth});
  }
  return all;
}

}  // namespace

LobeFitter::LobeFitter(std::span<const WeightedPower> lobes, ShownScale scale)
    : lobes_(thinned(lobes)), scale_(scale) {}

double LobeFitter::sampled_error(std::span<const double> slopes, double offset) const {
  double largest = 0;
  for (const WeightedPower& lobe : lobes_) {
    for (int i = 0; i < places; ++i) {
      const double y = place(i, lobe.power);
      if (!(y < 1)) break;
      const double target = lobe.power * std::log1p(-y);
      const double form = (lobe.power + offset) * std::numbers::ln2 * log2_by_slopes(-y, slopes);
      const double shown = largest_shown(lobe, y, std::max(target, form));
      largest = std::max(largest, apart_by_ratio(scale_, shown, form - target));
    }
  }
  return largest;
}

double LobeFitter::best_offset() {
  ++fits_run_;
  const std::array slope{natural_slope};
  const auto error = [&](double offset) { return sampled_error(slope, offset); };
  // The largest of functions that fall and then rise does so too.
  double low = 0, high = 16;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double error_at_a = error(a), error_at_b = error(b);
  constexpr double near = 1e-4;
  while (high - low > near) {
    if (error_at_a <= error_at_b) {
      high = b;
      b = a;
      error_at_b = error_at_a;
      a = high - golden * (high - low);
      error_at_a = error(a);
    } else {
      low = a;
      a = b;
      error_at_a = error_at_b;
      b = low + golden * (high - low);
      error_at_b = error(b);
    }
  }
  return low + (high - low) / 2;
}

std::vector<double> LobeFitter::best_slopes(int count) {
  ++fits_run_;
  const std::vector<WeightedPlace> all = weighted_places(lobes_, scale_);
  const auto rows = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd powers(rows, count);
  Eigen::VectorXd target(rows), worth(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto [y, value] = all[static_cast<std::size_t>(i)];
    worth[i] = value;
    for (Eigen::Index j = 0; j < count; ++j) powers(i, j) = std::pow(-y, static_cast<double>(j + 1));
    target[i] = std::log1p(-y) / std::numbers::ln2;
  }
  // |error|, weighed by what it is worth, becomes level where it is largest.
  Eigen::VectorXd level = Eigen::VectorXd::Constant(rows, 1.0 / static_cast<double>(rows));
  Eigen::VectorXd best(count);
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
