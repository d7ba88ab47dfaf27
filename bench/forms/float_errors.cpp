#include "bench/forms/float_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bench/forms/kernels.hpp"
#include "fit/support/parallel.hpp"

namespace shadefit::bench {
namespace {

/// Adds the errors on the next stretch.
void append(FloatErrors& into, const FloatErrors& more) {
  if (more.max_abs_error > into.max_abs_error) {
    into.max_abs_error = more.max_abs_error;
    into.max_abs_error_at = more.max_abs_error_at;
  }
  if (more.max_ulps > into.max_ulps) {
    into.max_ulps = more.max_ulps;
    into.max_ulps_at = more.max_ulps_at;
  }
  for (std::size_t i = 0; i < into.ulps.size(); ++i) into.ulps[i] += more.ulps[i];
  into.nans += more.nans;
  into.above_one += more.above_one;
  into.below_zero += more.below_zero;
  into.beyond += more.beyond;
  into.beyond_at.insert(into.beyond_at.end(), more.beyond_at.begin(), more.beyond_at.end());
  if (into.beyond_at.size() > FloatErrors::most_places) into.beyond_at.resize(FloatErrors::most_places);
}

/// A thousand floats, so that they, their values and the reference stay in the first cache.
struct Block {
  static constexpr std::size_t most = 1024;
  std::array<float, most> in, out;
  std::array<double, most> truth, middle, radius;
};

/// Notes a result that is a number.
void note(FloatErrors& found, std::uint32_t at, float value, double truth) {
  found.above_one += value > 1 ? 1 : 0;
  found.below_zero += value < 0 ? 1 : 0;
  const std::uint32_t steps = float_steps(value, static_cast<float>(truth));
  ++found.ulps[static_cast<std::size_t>(std::bit_width(steps))];
  const auto error = static_cast<float>(std::abs(static_cast<double>(value) - truth));
  if (error > found.max_abs_error) {
    found.max_abs_error = error;
    found.max_abs_error_at = at;
  }
  if (steps > found.max_ulps) {
    found.max_ulps = steps;
    found.max_ulps_at = at;
  }
}

/// The errors of one thread.
FloatErrors errors_of_piece(const FloatSubject& subject, const Stretch& piece) {
  Block floats;
  FloatErrors found;
  for (std::uint32_t first = piece.from; first < piece.to;) {
    const std::size_t count = std::min<std::size_t>(Block::most, piece.to - first);
    for (std::size_t i = 0; i < count; ++i)
      floats.in[i] = std::bit_cast<float>(first + static_cast<std::uint32_t>(i));
    subject.form(floats.in.data(), floats.out.data(), count);
    subject.truth(floats.in.data(), floats.truth.data(), count);
    if (subject.bound) subject.bound(floats.in.data(), floats.middle.data(), floats.radius.data(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t at = first + static_cast<std::uint32_t>(i);
      const float value = floats.out[i];
      if (std::isnan(value)) {
        ++found.nans;
      } else {
        note(found, at, value, floats.truth[i]);
      }
      const auto is_within = [&] {
        return std::abs(static_cast<double>(value) - floats.middle[i]) <= floats.radius[i];
      };
      if (!subject.bound || is_within()) continue;
      ++found.beyond;
      if (found.beyond_at.size() < FloatErrors::most_places) found.beyond_at.push_back(at);
    }
    first += static_cast<std::uint32_t>(count);
  }
  return found;
}

}  // namespace

std::uint64_t FloatErrors::count() const {
  return std::accumulate(ulps.begin(), ulps.end(), nans);
}

FloatSubject subject_of(const SweptForm& swept) {
  const forms::FormEntry& exact = swept.target->forms.front();
  const auto given = forms::parameters_of(*swept.target, *swept.constants);
  return {[form = forms::kernels_of(swept.form->id).front().in_float,
           parameters = std::vector<float>(given.begin(), given.end())](const float* in, float* out,
                                                                        std::size_t count) {
            std::ranges::copy(form({{in, in + count}}, parameters), out);
          },
          [truth = forms::kernels_of(exact.id).front().in_double,
           parameters = forms::parameters_of(*swept.target, exact.constants.front())](
              const float* in, double* out, std::size_t count) {
            std::ranges::copy(truth({{in, in + count}}, parameters), out);
          }};
}

FloatErrors errors_on(const FloatSubject& subject, const Stretch& stretch,
                      const std::function<void(double share)>& between) {
  constexpr std::uint32_t batch = 1U << 22, piece = 1U << 18;  // a batch takes about 50 ms on two threads
  FloatErrors all;
  for (std::uint32_t from = stretch.from; from < stretch.to;) {
    between(static_cast<double>(from - stretch.from) / static_cast<double>(stretch.size()));
    const Stretch some{from, from + std::min(batch, stretch.to - from)};
    if (subject.prepare) subject.prepare(some);
    std::vector<FloatErrors> found((some.size() + piece - 1) / piece);
    for_each_in_parallel(found.size(), [&](std::size_t part, const Checkpoint&) {
      const std::uint32_t first = some.from + static_cast<std::uint32_t>(part) * piece;
      found[part] = errors_of_piece(subject, {first, first + std::min(piece, some.to - first)});
    });
    for (const FloatErrors& part : found) append(all, part);
    from = some.to;
  }
  return all;
}

}  // namespace shadefit::bench
