#include "bench/exhaustive/float_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "fit/support/parallel.hpp"

namespace shadefit::bench {
namespace {

/// A maximum with the smallest place of it.
template <class T>
void keep_larger(T& most, std::uint32_t& at, T value, std::uint32_t value_at) {
  if (value > most || (value == most && value_at < at)) {
    most = value;
    at = value_at;
  }
}

/// The number of floats per block: small enough that they, their values and the reference stay in the first
/// cache.
constexpr std::size_t block = 1024;

struct Block {
  alignas(64) std::array<float, block> in;
  alignas(64) std::array<float, block> out;
  alignas(64) std::array<double, block> truth, middle, radius;
};

/// Notes the results beyond the bound; those that are no number too.
void look_at_bound(const Block& floats, std::size_t count, std::uint32_t first, FloatErrors& found) {
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(static_cast<double>(floats.out[i]) - floats.middle[i]) <= floats.radius[i]) continue;
    FloatErrors one;
    one.beyond = 1;
    one.beyond_at.front() = first + static_cast<std::uint32_t>(i);
    include(found, one);
  }
}

void look_at(const Block& floats, std::size_t count, std::uint32_t first, FloatErrors& found) {
  for (std::size_t i = 0; i < count; ++i) {
    const float value = floats.out[i];
    const auto at = first + static_cast<std::uint32_t>(i);
    if (std::isnan(value)) {
      ++found.nans;
      continue;
    }
    found.above_one += value > 1 ? 1 : 0;
    found.below_zero += value < 0 ? 1 : 0;
    const auto error = static_cast<float>(std::abs(static_cast<double>(value) - floats.truth[i]));
    const std::uint32_t steps = float_steps(value, static_cast<float>(floats.truth[i]));
    ++found.ulps[static_cast<std::size_t>(std::bit_width(steps))];
    keep_larger(found.max_abs_error, found.max_abs_error_at, error, at);
    keep_larger(found.max_ulps, found.max_ulps_at, steps, at);
  }
}

}  // namespace

std::uint64_t FloatErrors::count() const {
  return std::accumulate(ulps.begin(), ulps.end(), nans);
}

void include(FloatErrors& into, const FloatErrors& more) {
  keep_larger(into.max_abs_error, into.max_abs_error_at, more.max_abs_error, more.max_abs_error_at);
  keep_larger(into.max_ulps, into.max_ulps_at, more.max_ulps, more.max_ulps_at);
  for (std::size_t i = 0; i < into.ulps.size(); ++i) into.ulps[i] += more.ulps[i];
  into.nans += more.nans;
  into.above_one += more.above_one;
  into.below_zero += more.below_zero;
  into.beyond += more.beyond;
  std::array<std::uint32_t, 2 * std::tuple_size_v<decltype(into.beyond_at)>> places{};
  std::merge(into.beyond_at.begin(), into.beyond_at.end(), more.beyond_at.begin(), more.beyond_at.end(),
             places.begin());
  std::copy_n(places.begin(), into.beyond_at.size(), into.beyond_at.begin());
}

FloatErrors errors_on(const FloatSubject& subject, const Stretch& stretch) {
  Block floats;
  FloatErrors found;
  std::uint64_t left = stretch.size();
  for (std::uint32_t first = stretch.from; left > 0; first += block) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(block, left));
    // The last block is padded with its last float, because kernels have no remainder loop.
    for (std::size_t i = 0; i < block; ++i)
      floats.in[i] = std::bit_cast<float>(first + static_cast<std::uint32_t>(std::min(i, count - 1)));
    subject.form(floats.in.data(), floats.out.data(), block);
    subject.truth(floats.in.data(), floats.truth.data(), block);
    look_at(floats, count, first, found);
    if (subject.bound) {
      subject.bound(floats.in.data(), floats.middle.data(), floats.radius.data(), block);
      look_at_bound(floats, count, first, found);
    }
    left -= count;
  }
  return found;
}

FloatErrors errors_on(const FloatSubject& subject, const Stretch& stretch, unsigned threads) {
  if (subject.prepare) subject.prepare(stretch);
  const std::uint64_t parts = std::max(threads, 1U);
  const auto end_of = [&](std::uint64_t part) {
    return stretch.from + static_cast<std::uint32_t>(stretch.size() * part / parts);
  };
  std::vector<FloatErrors> found(parts);
  for_each_in_parallel(parts,
                       [&](std::size_t part, const Checkpoint&) {
                         found[part] = errors_on(subject, Stretch{end_of(part), end_of(part + 1)});
                       },
                       {.threads = threads});
  FloatErrors all;
  for (const FloatErrors& part : found) include(all, part);
  return all;
}

}  // namespace shadefit::bench
