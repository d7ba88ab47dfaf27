#include "fit/study/search_starts.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "fit/scalars/integral.hpp"
#include "fit/scalars/likely_sizes.hpp"
#include "fit/study/study_nodes.hpp"

namespace shadefit {
namespace {

/// The distance of the largest of some numbers from 1, in octaves.
int octaves_from_one(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest == 0 ? 0 : static_cast<int>(std::ceil(std::abs(std::log2(largest))));
}

/// A parameter that is a frequency, and the argument of its wave.
struct Frequency {
  std::string parameter;
  Symbolic argument;
};

/// The parameters that `variable` multiplies in a formula: a of a x + b.
void collect(const Symbolic& formula, const std::string& variable, const Symbolic* argument,
             std::vector<Frequency>& found) {
  using Kind = Symbolic::Kind;
  const bool is_wave =
      formula.kind() == Kind::function && (formula.name() == "sin" || formula.name() == "cos");
  if (argument != nullptr && formula.kind() == Kind::multiply) {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (!free_variables(formula.part(1 - side)).contains(variable)) continue;
      for (const std::string& name : free_variables(formula.part(side)))
        if (name != variable) found.push_back({name, *argument});
    }
  }
  for (const Symbolic& part : formula.parts())
    collect(part, variable, is_wave ? &formula.part(0) : argument, found);
}

/// The angular frequencies at which values at even steps are strongest, strongest first. `length` is that of
/// the range.
std::vector<double> strongest(std::vector<double> values, double length, std::size_t most) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / count;
  // Hann's window: the ends of the range are no edges.
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        (values[i] - mean) * (1 - std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / count));
  // Half periods over the range, up to four samples a period.
  std::vector<double> power;
  for (std::size_t half_periods = 0; half_periods <= values.size() / 2; ++half_periods) {
    const auto turn = std::polar(1.0, std::numbers::pi * static_cast<double>(half_periods) / count);
    std::complex<double> sum = 0;
    for (const double value : values) sum = sum * turn + value;
    power.push_back(std::norm(sum));
  }
  std::vector<std::size_t> peaks;
  for (std::size_t i = 1; i + 1 < power.size(); ++i)
    if (power[i] > power[i - 1] && power[i] >= power[i + 1]) peaks.push_back(i);
  std::ranges::stable_sort(peaks, std::ranges::greater(), [&](std::size_t i) { return power[i]; });
  peaks.resize(std::min(peaks.size(), most));
  std::vector<double> frequencies;
  for (const std::size_t peak : peaks)
    frequencies.push_back(std::numbers::pi * static_cast<double>(peak) / length);
  return frequencies;
}

void find_positions(const Symbolic& formula, const ReadStudy& study,
                    std::vector<std::optional<std::array<double, 2>>>& ranges) {
  if (formula.kind() == Symbolic::Kind::subtract) {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      const auto axis = std::ranges::find(study.axes, formula.part(side).name(), &StudyAxis::variable);
      const auto parameter = std::ranges::find(study.parameters, formula.part(1 - side).name());
      if (axis != study.axes.end() && parameter != study.parameters.end())
        ranges[static_cast<std::size_t>(parameter - study.parameters.begin())] = {axis->lower, axis->upper};
    }
  }
  for (const Symbolic& part : formula.parts()) find_positions(part, study, ranges);
}

/// The range of a variable for each parameter that is subtracted from it, as d of (x - d)^2. Empty if the
/// form has none.
std::vector<std::optional<std::array<double, 2>>> positions_of(const ReadStudy& study) {
  std::vector<std::optional<std::array<double, 2>>> ranges(study.parameters.size());
  find_positions(study.form, study, ranges);
  const bool has_any = std::ranges::any_of(ranges, [](const auto& range) { return range.has_value(); });
  return has_any ? ranges : std::vector<std::optional<std::array<double, 2>>>{};
}

/// A start for each of the frequencies at which the target is strongest: each parameter that a variable
/// multiplies inside a sine or cosine gets one of them, all others are 1. Empty if the form has none, or the
/// target no finite values.
std::vector<std::vector<double>> wave_starts(const ReadStudy& study) {
  if (study.rows || study.axes.size() != 1) return {};
  const StudyAxis& axis = study.axes.front();
  std::vector<Frequency> found;
  collect(study.form, axis.variable, nullptr, found);
  std::erase_if(found,
                [&](const Frequency& f) { return !std::ranges::count(study.parameters, f.parameter); });
  if (found.empty()) return {};

  constexpr std::size_t samples = 1024, most = 4;
  StudyNodes nodes{{{}}, std::vector<long double>(samples, 1.0L / samples), 1};
  const double length = axis.upper - axis.lower;
  for (std::size_t i = 0; i < samples; ++i)
    nodes.coordinates.front().push_back(axis.lower + length * (static_cast<double>(i) + 0.5) / samples);
  const std::vector<double> values = values_at_nodes(study, study.target, nodes);
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) return {};
  const std::vector<double> frequencies = strongest(values, length, most);

  std::vector<std::vector<double>> starts(frequencies.size(),
                                          std::vector<double>(study.parameters.size(), 1));
  for (std::size_t i = 0; i < found.size(); ++i) {
    // The argument may have a factor, as in sin(2 pi a x): its slope by x where all parameters are 1.
    const auto at = [&](double x) {
      return evaluate<double>(found[i].argument,
                              [&](const std::string& name) { return name == axis.variable ? x : 1.0; });
    };
    const double slope = (at(axis.upper) - at(axis.lower)) / length;
    const auto parameter = std::ranges::find(study.parameters, found[i].parameter) - study.parameters.begin();
    for (std::size_t k = 0; k < starts.size(); ++k)
      starts[k][static_cast<std::size_t>(parameter)] = frequencies[(k + i) % frequencies.size()] / slope;
  }
  return starts;
}

/// The bounds of each parameter, infinite where it has none. Empty if none has any.
std::vector<std::array<double, 2>> bounds_of(const ReadStudy& study) {
  std::vector<std::array<double, 2>> result;
  if (!study.bounds.empty()) result.assign(study.parameters.size(), {-HUGE_VAL, HUGE_VAL});
  for (const ParameterBounds& bounds : study.bounds) {
    const auto found = std::ranges::find(study.parameters, bounds.parameter);
    result[static_cast<std::size_t>(found - study.parameters.begin())] = {bounds.lower, bounds.upper};
  }
  return result;
}

/// The size of each parameter, from the ranges of the variables and from the size of the values of the target
/// (fit/scalars/likely_sizes.hpp).
std::vector<double> sizes_of(const ReadStudy& study, const std::vector<double>& target) {
  std::map<std::string, double> sizes;
  for (const StudyAxis& axis : study.axes)
    sizes[axis.variable] = std::log2(std::max(std::abs(axis.lower), std::abs(axis.upper)));
  double largest = 0;
  for (const double value : target) largest = std::max(largest, std::abs(value));
  std::vector<double> units;
  for (const double octaves :
       likely_sizes(study.form, study.parameters, sizes, largest > 0 ? std::log2(largest) : 0))
    units.push_back(unit_of(std::exp2(octaves)));
  return units;
}

}  // namespace

double unit_of(double size) {
  constexpr double far = 4;  // octaves: the starts and the solver take less as it is
  const double octaves = std::round(std::log2(size));
  return std::isfinite(octaves) && std::abs(octaves) > far ? std::exp2(octaves) : 1;
}

double folded(double value, const std::array<double, 2>& bounds) {
  const auto [lower, upper] = bounds;
  if (lower <= value && value <= upper) return value;
  if (std::isinf(upper)) return lower + std::abs(value - lower);
  if (std::isinf(lower)) return upper - std::abs(value - upper);
  return lower + std::fmod(std::abs(value - lower), upper - lower);
}

std::vector<double> start_of(const ReadStudy& study, const std::vector<Held>& starts) {
  std::vector<double> result(study.parameters.size(), 1);
  for (const Held& start : starts) {
    const auto found = std::find(study.parameters.begin(), study.parameters.end(), start.parameter);
    result[static_cast<std::size_t>(found - study.parameters.begin())] = start.value;
  }
  const auto bounds = bounds_of(study);
  for (std::size_t i = 0; i < bounds.size(); ++i)
    result[i] = std::clamp(result[i], bounds[i][0], bounds[i][1]);
  return result;
}

SearchStarts starts_of(const ReadStudy& study, std::size_t nonlinear) {
  SearchStarts starts{
      nonlinear == 0 ? 1 : std::min(std::size_t{16} << nonlinear, std::size_t{96}), octaves_of_shading, {}};
  if (!study.rows || nonlinear == 0) return starts;
  // A rate is about as large as 1/x, a position as x, and a parameter of 1/(a + b x) as 1/value.
  int further = octaves_from_one(study.rows->value);
  for (const auto& places : study.rows->places) further = std::max(further, octaves_from_one(places));
  starts.octaves += further;
  constexpr std::size_t more = 4;
  if (further > 1) starts.count *= more;
  return starts;
}

SearchStarts search_starts(const ReadStudy& study, std::size_t nonlinear, const std::vector<double>& target,
                           const std::vector<Held>& given) {
  SearchStarts wanted = starts_of(study, nonlinear);
  if (!study.rows && nonlinear > 0) {
    wanted.units = sizes_of(study, target);
    if (std::ranges::all_of(wanted.units, [](double unit) { return unit == 1; })) wanted.units.clear();
  }
  wanted.bounds = bounds_of(study);
  if (!given.empty()) wanted.given.push_back(start_of(study, given));
  if (study.has_only_starts && nonlinear > 0) {
    wanted.count = 0;
  } else if (nonlinear > 0) {
    std::ranges::move(wave_starts(study), std::back_inserter(wanted.given));
    wanted.ranges = positions_of(study);
    if (!wanted.ranges.empty()) wanted.sizes = sizes_of(study, target);
  }
  for (std::vector<double>& start : wanted.given) {
    for (std::size_t i = 0; i < wanted.bounds.size(); ++i) start[i] = folded(start[i], wanted.bounds[i]);
  }
  return wanted;
}

}  // namespace shadefit
