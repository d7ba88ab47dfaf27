#include "fit/formula/hinge_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/rounded_interval.hpp"

namespace shadefit {
namespace {

/// Evenly spaced places, and powers of two towards both ends.
std::vector<double> places_on(double lower, double upper) {
  constexpr int count = 512, first_power = 10, last_power = 50;
  std::vector<double> places{lower};
  for (int i = last_power - 1; i >= first_power; --i)
    places.push_back(lower + (upper - lower) * std::ldexp(1.0, -i));
  for (int i = 1; i < count; ++i) places.push_back(lower + (upper - lower) * i / count);
  for (int i = first_power; i < last_power; ++i)
    places.push_back(upper - (upper - lower) * std::ldexp(1.0, -i));
  places.push_back(upper);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// The place between two neighbours where a predicate changes.
template <class Predicate>
double bisected(double low, double high, const Predicate& predicate) {
  const bool at_low = predicate(low);
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return high;
    (predicate(middle) == at_low ? low : high) = middle;
  }
}

}  // namespace

/// The formula in double, with its slope, and in enclosures.
struct HingeCurve::Programs {
  using Enclosure = RoundedInterval<OutwardArithmetic>;

  double value(double x) {
    values.front() = x;
    program.run(values);
    return program.output(0);
  }
  double slope(double x) {
    value(x);
    return program.output(1);
  }
  /// What enclosures tell of a range.
  struct Range {
    bool may_be_zero;  ///< whether some value is 0 or rounding
    bool is_monotone;  ///< certainly
  };
  Range range(double lower, double upper) {
    std::vector<Enclosure> inputs(values.begin(), values.end());
    inputs.front() = Enclosure(lower, upper);
    enclosed.run(inputs);
    const auto has_zero = [&](std::size_t i) {
      return enclosed.output(i).lower() <= 0 && 0 <= enclosed.output(i).upper();
    };
    return {has_zero(0), is_smooth && !has_zero(1)};
  }

  TapeProgram<double> program;
  TapeProgram<Enclosure> enclosed;
  std::vector<double> values;
  bool is_smooth;
};

HingeCurve::HingeCurve(Hinge hinge, std::span<const std::string> variables) : hinge_(std::move(hinge)) {
  const Tape tape = tape_of(hinge_.part, variables, 1);
  programs_.reset(new Programs{
      {tape, {}}, {tape, {}}, std::vector<double>(variables.size()), hinges_of(hinge_.part).empty()});
}

void HingeCurve::set_others(std::span<const long double> values) {
  std::copy(values.begin(), values.end(), programs_->values.begin() + 1);
}

bool HingeCurve::is_root_at(double x) {
  return hinge_.is_root && programs_->value(x) == 0;
}

void HingeCurve::append_zeros(double lower, double upper, std::vector<StudyEdge>& edges) {
  Programs& part = *programs_;
  const auto [may_be_zero, is_monotone] = part.range(lower, upper);
  if (!may_be_zero) return;
  // The sign of a monotone part at both ends tells whether it has a zero, and bisection finds it.
  const bool has_ends_only =
      is_monotone && std::isfinite(part.value(lower)) && std::isfinite(part.value(upper));
  const std::vector<double> places = has_ends_only ? std::vector{lower, upper} : places_on(lower, upper);
  std::vector<double> values;
  double largest = 0;
  for (const double x : places) {
    values.push_back(part.value(x));
    if (std::isfinite(values.back())) largest = std::max(largest, std::abs(values.back()));
  }
  const int smooth_in = hinge_.is_root ? power_at_root : 1;
  // The zero that is nearest by the slope is at the place, up to rounding: 1 + exp(x) is small beside its
  // largest value, but its zero is far.
  const double rounding = 1e-13 * (upper - lower);
  const auto is_zero = [&](std::size_t i) {
    const double v = std::abs(values[i]);
    return v == 0 || (v <= 1e-14 * largest && v <= rounding * std::abs(part.slope(places[i])));
  };
  if (std::ranges::all_of(values, [](double v) { return v == 0; })) return;
  const auto is_below = [&](double x) { return part.value(x) < 0; };
  const auto is_nothing = [&](double x) { return part.value(x) == 0; };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == places.size();
    // Where a part is 0 all over a range, as max(0, x) is, the ends of that range count.
    const bool is_before_range = i + 1 < places.size() && values[i] == 0 && values[i + 1] == 0;
    const bool is_after_range = i > 0 && values[i] == 0 && values[i - 1] == 0;
    if (is_before_range || is_after_range) {
      if (!is_after_range && i > 0)
        edges.push_back({bisected(places[i - 1], places[i], is_nothing), smooth_in, hinge_.is_jump});
      if (!is_before_range && !is_end)
        edges.push_back({bisected(places[i], places[i + 1], is_nothing), smooth_in, hinge_.is_jump});
      continue;
    }
    if (is_zero(i) && (hinge_.is_root || hinge_.is_jump || !is_end))
      edges.push_back({places[i], smooth_in, hinge_.is_jump});
    if (i == 0 || is_zero(i) || is_zero(i - 1)) continue;
    if ((values[i - 1] < 0) != (values[i] < 0)) {
      edges.push_back({bisected(places[i - 1], places[i], is_below), smooth_in, hinge_.is_jump});
    } else if (part.slope(places[i - 1]) * values[i - 1] < 0 && part.slope(places[i]) * values[i] > 0) {
      // an extremum between, which may touch zero
      const double x =
          bisected(places[i - 1], places[i], [&](double at) { return part.slope(at) * values[i - 1] < 0; });
      if (std::abs(part.value(x)) <= 1e-12 * largest && part.range(x, x).may_be_zero)
        edges.push_back({x, smooth_in});
    }
  }
}

}  // namespace shadefit
