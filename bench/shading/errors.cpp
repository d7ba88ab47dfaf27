#include "bench/shading/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "approx/encoding.hpp"

namespace shadefit::shade {
namespace {

/// The reference's result for a block.
struct Truth {
  std::array<std::vector<double>, 3> linear, codes;
  bool is_grey = true;  ///< the channels are equal, and one is enough
};

Truth truth_of(const Results<double>& results) {
  Truth truth;
  truth.is_grey = results.channel(0) == results.channel(1) && results.channel(1) == results.channel(2);
  for (std::size_t i = 0; i < 3; ++i) {
    truth.linear[i] = results.channel(i);
    if (truth.is_grey && i > 0) {
      truth.codes[i] = truth.codes[0];
    } else {
      for (const double value : truth.linear[i]) truth.codes[i].push_back(srgb_code(value));
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
      for (std::size_t p = 0; p < shown.size(); ++p)
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
                              std::span<const Way> ways, const Checkpoint& checkpoint) {
  const std::size_t tiles = workload.tiles() * workload.lights();
  Results<double> truths(tiles);
  Results<float> results(tiles);
  std::vector<Sums> sums(ways.size());
  for (const Visit& visit : workload.visits()) {
    checkpoint();
    const SingleLights<double> wide(workload.block<double>(visit));
    const SingleLights<float> narrow(workload.block<float>(visit));
    reference.shade(wide.block(truths.out()), visit.material);
    const Truth truth = truth_of(truths);
    for (std::size_t way = 0; way < ways.size(); ++way) {
      results.clear();
      ways[way].shade(narrow.block(results.out()), visit.material);
      sums[way].add(truth, results, !ways[way].is_coloured);
    }
  }
  std::vector<Errors> errors;
  for (const Sums& sum : sums) errors.push_back(sum.errors());
  return errors;
}

}  // namespace shadefit::shade
