#include "fit/study/likely_starts.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <set>
#include <string>

#include "fit/scalars/integral.hpp"
#include "fit/study/study_nodes.hpp"

namespace shadefit {
namespace {

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

}  // namespace

std::vector<std::optional<std::array<double, 2>>> positions_of(const ReadStudy& study) {
  std::vector<std::optional<std::array<double, 2>>> ranges(study.parameters.size());
  find_positions(study.form, study, ranges);
  const bool has_any = std::ranges::any_of(ranges, [](const auto& range) { return range.has_value(); });
  return has_any ? ranges : std::vector<std::optional<std::array<double, 2>>>{};
}

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

}  // namespace shadefit
