#include "bench/shading/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "approx/encoding.hpp"

namespace shadefit::shade {
namespace {

/// The pixels of a tile under one of its lights.
template <class Real>
Block<Real> under_one_light(const Block<Real>& block, std::size_t tile, std::size_t light,
                            const std::array<Real*, 3>& out) {
  const std::size_t samples = (tile * block.lights + light) * tile_pixels;
  return {.tiles = 1,
          .lights = 1,
          .n_dot_h = block.n_dot_h + samples,
          .l_dot_h = block.l_dot_h + samples,
          .n_dot_l = block.n_dot_l + samples,
          .alpha = block.alpha == nullptr ? nullptr : block.alpha + tile * tile_pixels,
          .out = out};
}

/// The reference's result for a tile.
struct Truth {
  std::array<std::array<double, tile_pixels>, 3> linear, codes;
  bool is_grey = true;  ///< the channels are equal, and one is enough
};

Truth truth_of(const Results<double>& results) {
  Truth truth;
  truth.is_grey = results.channel(0) == results.channel(1) && results.channel(1) == results.channel(2);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t p = 0; p < tile_pixels; ++p) {
      truth.linear[i][p] = results.channel(i)[p];
      truth.codes[i][p] = truth.is_grey && i > 0 ? truth.codes[0][p] : srgb_code(truth.linear[i][p]);
    }
  }
  return truth;
}

/// The sums for the means.
class Sums {
 public:
  /// `is_grey`: only the first channel of the results is used.
  void add(const Truth& truth, const Results<float>& results, bool is_grey) {
    const std::size_t channels = truth.is_grey && is_grey ? 1 : 3;
    for (std::size_t i = 0; i < channels; ++i) {
      const auto& shown = results.channel(is_grey ? 0 : i);
      for (std::size_t p = 0; p < tile_pixels; ++p)
        add(truth.linear[i][p], truth.codes[i][p], static_cast<double>(shown[p]),
            3.0 / static_cast<double>(channels));
    }
  }
  Errors errors() const {
    Errors result = errors_;
    result.mean /= count_;
    result.mean_codes /= count_;
    return result;
  }

 private:
  void add(double truth, double truth_code, double shown, double weight) {
    count_ += weight;
    if (shown == truth) return;
    // NaN counts as the largest error; a comparison of errors would miss it.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool is_number = !std::isnan(shown);
    const double error = is_number ? std::abs(shown - truth) : infinity;
    const double codes = is_number ? std::abs(srgb_code(shown) - truth_code) : infinity;
    errors_.most = std::max(errors_.most, error);
    errors_.most_codes = std::max(errors_.most_codes, codes);
    errors_.mean += weight * error;
    errors_.mean_codes += weight * codes;
  }

  Errors errors_;  ///< the means before the division
  double count_ = 0;
};

}  // namespace

std::vector<Errors> errors_of(const Workload& workload, const ReferenceWay& reference,
                              std::span<const FloatWay> ways, const Checkpoint& checkpoint) {
  Results<double> truths(1);
  Results<float> results(1);
  std::vector<Sums> sums(ways.size());
  for (const Visit& visit : workload.visits()) {
    checkpoint();
    const Block<double> wide = workload.block<double>(visit);
    const Block<float> narrow = workload.block<float>(visit);
    for (std::size_t i = 0; i < wide.tiles * wide.lights; ++i) {
      const std::size_t tile = i / wide.lights, light = i % wide.lights;
      reference.shade(under_one_light(wide, tile, light, truths.out()), visit.material);
      const Truth truth = truth_of(truths);
      const Block<float> block = under_one_light(narrow, tile, light, results.out());
      for (std::size_t way = 0; way < ways.size(); ++way) {
        results.clear();
        ways[way].shade(block, visit.material);
        sums[way].add(truth, results, !ways[way].is_coloured());
      }
    }
  }
  std::vector<Errors> errors;
  for (const Sums& sum : sums) errors.push_back(sum.errors());
  return errors;
}

}  // namespace shadefit::shade
