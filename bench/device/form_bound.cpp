#include "bench/device/form_bound.hpp"

#include <algorithm>
#include <bit>
#include <set>
#include <type_traits>

#include "fit/support/parallel.hpp"

namespace shadefit::device {
namespace {

template <class Format>
constexpr ShaderPrecision shader_precision =
    std::is_same_v<Format, HalfFormat> ? ShaderPrecision::float16 : ShaderPrecision::float32;

}  // namespace

Tape tape_of_code(const ShaderFunction& function, ShaderPrecision precision) {
  return tape_of(as_generated(function.result, precision), function.arguments);
}

template <class Format>
FormBound<Format>::FormBound(const ShaderFunction& function, const GpuModel& gpu)
    : gpu_(gpu), program_(tape_of_code(function, shader_precision<Format>), {}) {}

template <class Format>
double FormBound<Format>::on(std::span<const Domain> box) {
  std::vector<RunningNarrow<Format>> arguments;
  for (const Domain& side : box)
    arguments.push_back(RunningNarrow<Format>::exact(span_of(side.lower, side.upper), &gpu_));
  program_.run(arguments);
  const RunningNarrow<Format>& form = program_.output(0);
  // The value in double is off by about 2^-50 of itself, or by 2^-45 at an exponent of a hundred. That is far
  // below an ulp of a float, 2^-23, but an enclosure may know the rounding of a single float exactly.
  constexpr double slack = 0x1p-40;
  return form.error + slack * largest_magnitude_in(form.computed);
}

template class FormBound<FloatFormat>;
template class FormBound<HalfFormat>;

std::vector<std::uint32_t> unit_panels() {
  constexpr std::uint32_t per_binade = 64, fraction_bits = 23, sharp_binades = 12;
  std::set<std::uint32_t> firsts{0, 1};
  for (std::uint32_t exponent = 1; exponent <= 126; ++exponent) {
    const std::uint32_t pieces = exponent + sharp_binades > 126 ? per_binade : 1;
    for (std::uint32_t i = 0; i < pieces; ++i)
      firsts.insert((exponent << fraction_bits) + ((i << fraction_bits) / pieces));
  }
  // From 1/2 on 1 - c is exact: a whole number of steps of 2^-24.
  const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0F);
  for (std::uint32_t power = 1; power < 1U << fraction_bits; power *= 2) {
    for (std::uint32_t i = 0; i < std::min(power, per_binade); ++i)
      firsts.insert(one - (power + i * std::max(power / per_binade, 1U)));
  }
  firsts.insert(one);
  return {firsts.begin(), firsts.end()};
}

std::vector<double> bounds_on(std::span<const std::uint32_t> panels, const ShaderFunction& function,
                              const GpuModel& gpu) {
  constexpr std::size_t piece = 128;
  std::vector<double> bounds(panels.size());
  for_each_in_parallel((panels.size() + piece - 1) / piece, [&](std::size_t part, const Checkpoint&) {
    FormBound<> bound(function, gpu);
    for (std::size_t i = part * piece; i < std::min(panels.size(), (part + 1) * piece); ++i) {
      const std::uint32_t last =
          i + 1 < panels.size() ? panels[i + 1] - 1 : std::bit_cast<std::uint32_t>(1.0F);
      const Domain box{std::bit_cast<float>(panels[i]), std::bit_cast<float>(last)};
      bounds[i] = bound.on(std::span(&box, 1));
    }
  });
  return bounds;
}

}  // namespace shadefit::device
