#include "fit/better/sampled_curve.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "fit/formula/tape_program.hpp"
#include "fit/study/even_grid.hpp"
#include "fit/study/measured_rows.hpp"

namespace shadefit {
namespace {

/// Of the grid, in one, two and three variables.
constexpr std::array<int, most_axes> steps_of_samples{1000, 48, 12};

std::vector<std::vector<double>> places_of(const MeasuredRows& rows) {
  std::vector<std::vector<double>> places(rows.value.size());
  for (const std::vector<double>& column : rows.places)
    for (std::size_t i = 0; i < column.size(); ++i) places[i].push_back(column[i]);
  return places;
}

std::vector<double> values_at(const ReadStudy& study, const Symbolic& formula,
                              const std::vector<double>& parameters,
                              const std::vector<std::vector<double>>& places) {
  TapeProgram<double> program(tape_of(formula, formula_inputs(study)), parameters);
  std::vector<double> values;
  for (const std::vector<double>& place : places) {
    program.run(place);
    values.push_back(program.output(0));
  }
  return values;
}

SampledCurve curve_at(const ReadStudy& study, const std::vector<double>& parameters,
                      const std::vector<std::vector<double>>& places) {
  return {places, values_at(study, study.target, parameters, places),
          values_at(study, study.form, parameters, places)};
}

}  // namespace

SampledCurve sample_curve(const ReadStudy& study, const std::vector<double>& parameters) {
  if (!study.rows)
    return curve_at(study, parameters, even_grid(study.axes, steps_of_samples.at(study.axes.size() - 1)));
  const auto places = places_of(*study.rows);
  return {places, study.rows->value, values_at(study, study.form, parameters, places)};
}

SampledCurve sample_place(const ReadStudy& study, const std::vector<double>& parameters,
                          const std::vector<double>& place) {
  return curve_at(study, parameters, {place});
}

void append(SampledCurve& curve, SampledCurve other) {
  std::ranges::move(other.places, std::back_inserter(curve.places));
  std::ranges::copy(other.target, std::back_inserter(curve.target));
  std::ranges::copy(other.form, std::back_inserter(curve.form));
}

std::vector<double> form_at(const ReadStudy& study, const std::vector<double>& parameters,
                            const std::vector<std::vector<double>>& places) {
  return values_at(study, study.form, parameters, places);
}

}  // namespace shadefit
