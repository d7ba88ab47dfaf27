#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/device/form_bound.hpp"
#include "bench/forms/catalogue.hpp"
#include "fit/formula/batch.hpp"
#include "fit/stress/numbers.hpp"

/// Arguments of forms, drawn in boxes, so that a bound of a box holds for all of its arguments.
namespace shadefit::device {

struct DrawnInputs {
  std::vector<float> arguments;            ///< those of one evaluation after the other
  std::vector<std::vector<Domain>> boxes;  ///< the sides of each
  std::vector<std::uint32_t> box_of;       ///< by evaluation
};

inline constexpr std::size_t drawn_count = 1U << 22;

/// Half of the cosines are drawn evenly in [0, 1], half evenly among the floats there. The boxes are the
/// panels.
inline DrawnInputs drawn_cosines() {
  Sequence sequence(1);
  std::vector<std::uint32_t> bits(drawn_count);
  const auto one = std::bit_cast<std::uint32_t>(1.0F);
  for (std::size_t i = 0; i < bits.size(); ++i)
    bits[i] = i % 2 == 0 ? std::bit_cast<std::uint32_t>(static_cast<float>(sequence.unit()))
                         : static_cast<std::uint32_t>(sequence.next() % (one + 1));
  bits[0] = 0;
  bits[1] = one;
  std::sort(bits.begin(), bits.end());  // those of floats that are not negative are in their order
  const std::vector<std::uint32_t> panels = unit_panels();
  DrawnInputs drawn;
  std::size_t panel = 0;
  for (const std::uint32_t c : bits) {
    while (panel + 1 < panels.size() && panels[panel + 1] <= c) ++panel;
    drawn.arguments.push_back(std::bit_cast<float>(c));
    drawn.box_of.push_back(static_cast<std::uint32_t>(panel));
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::uint32_t last = i + 1 < panels.size() ? panels[i + 1] - 1 : one;
    drawn.boxes.push_back({{std::bit_cast<float>(panels[i]), std::bit_cast<float>(last)}});
  }
  return drawn;
}

/// As many in each of some boxes; `box` draws one.
template <class Box>
DrawnInputs drawn_in(const Box& box, std::size_t count = drawn_count, std::uint32_t boxes = 1U << 12) {
  Sequence sequence(2);
  DrawnInputs drawn;
  for (std::uint32_t i = 0; i < boxes; ++i) {
    drawn.boxes.push_back(box(sequence));
    for (std::size_t k = 0; k < count / boxes; ++k) {
      for (const Domain& side : drawn.boxes.back()) {
        const auto x = static_cast<float>(sequence.between(side.lower, side.upper));
        drawn.arguments.push_back(
            std::clamp(x, static_cast<float>(side.lower), static_cast<float>(side.upper)));
      }
      drawn.box_of.push_back(i);
    }
  }
  return drawn;
}

/// From a float to another one. Not by two casts to float and back: GCC 12.2 leaves such a pair out at -O2.
inline Domain narrow_side(double lower, double width) {
  const auto to_float = [](double x) { return static_cast<double>(NarrowResult<FloatFormat>::rounded(x)); };
  return {to_float(lower), to_float(lower + width)};
}

/// The cosines and any of the 256 codes.
inline DrawnInputs drawn_cosines_and_codes() {
  return drawn_in([](Sequence& sequence) {
    const double rest = std::exp2(-24 * sequence.unit()), width = rest / 256;
    const bool is_near_peak = sequence.next() % 2 == 0;
    const Domain c = is_near_peak ? narrow_side(1 - rest, width) : narrow_side(rest - width, width);
    const auto code = static_cast<double>(sequence.next() % 256);
    return std::vector<Domain>{c, {code, code}};
  });
}

/// Normals: unit vectors, to 2^-13.
inline DrawnInputs drawn_normals() {
  return drawn_in([](Sequence& sequence) {
    const double z = sequence.between(-1, 1), angle = sequence.between(0, 6.28);
    const double r = std::sqrt(1 - z * z), width = 0x1p-13;
    return std::vector<Domain>{narrow_side(r * std::cos(angle), width),
                               narrow_side(r * std::sin(angle), width), narrow_side(z, width)};
  });
}

/// What a target reads.
inline DrawnInputs drawn_for(forms::Arguments arguments) {
  if (arguments == forms::Arguments::cosine_and_code) return drawn_cosines_and_codes();
  return arguments == forms::Arguments::cosine ? drawn_cosines() : drawn_normals();
}

/// The real value of each evaluation.
inline std::vector<double> values_at(const DrawnInputs& drawn, const ShaderFunction& function) {
  const Tape code = tape_of_code(function);
  const std::size_t n = function.arguments.size(), count = drawn.box_of.size();
  constexpr std::size_t most = 1024;
  std::vector<double> values;
  for (std::size_t from = 0; from < count; from += most) {
    std::vector<std::vector<double>> columns(n);
    for (std::size_t i = from; i < std::min(from + most, count); ++i) {
      for (std::size_t a = 0; a < n; ++a)
        columns[a].push_back(static_cast<double>(drawn.arguments[i * n + a]));
    }
    const std::vector<double> some = shadefit::values_at(code, columns, {});
    values.insert(values.end(), some.begin(), some.end());
  }
  return values;
}

/// The bound of each box.
inline std::vector<double> bounds_of(const DrawnInputs& drawn, const ShaderFunction& function,
                                     const GpuModel& gpu) {
  FormBound bound(function, gpu);
  std::vector<double> bounds;
  for (const auto& box : drawn.boxes) bounds.push_back(bound.on(box));
  return bounds;
}

}  // namespace shadefit::device
