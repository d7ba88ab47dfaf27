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

std::vector<SampledPlace> places_of(const MeasuredRows& rows) {
  std::vector<SampledPlace> places(rows.value.size());
  for (std::size_t k = 0; k < rows.places.size(); ++k)
    for (std::size_t i = 0; i < places.size(); ++i) places[i][k] = rows.places[k][i];
  return places;
}

SampledPlace place_of(const std::vector<double>& numbers) {
  SampledPlace place{};
  std::ranges::copy(numbers, place.begin());
  return place;
}

std::vector<SampledPlace> grid_of(const ReadStudy& study) {
  std::vector<SampledPlace> places;
  for (const auto& place : even_grid(study.axes, steps_of_samples.at(study.axes.size() - 1)))
    places.push_back(place_of(place));
  return places;
}

SampledCurve curve_at(const ReadStudy& study, const std::vector<double>& parameters,
                      const std::vector<SampledPlace>& places) {
  return {places, values_at(study, study.target, parameters, places),
          values_at(study, study.form, parameters, places)};
}

}  // namespace

SampledCurve sample_curve(const ReadStudy& study, const std::vector<double>& parameters) {
  if (!study.rows) return curve_at(study, parameters, grid_of(study));
  const auto places = places_of(*study.rows);
  return {places, study.rows->value, values_at(study, study.form, parameters, places)};
}

SampledCurve sample_place(const ReadStudy& study, const std::vector<double>& parameters,
                          const std::vector<double>& place) {
  return curve_at(study, parameters, {place_of(place)});
}

void append(SampledCurve& curve, SampledCurve other) {
  std::ranges::move(other.places, std::back_inserter(curve.places));
  std::ranges::copy(other.target, std::back_inserter(curve.target));
  std::ranges::copy(other.form, std::back_inserter(curve.form));
}

std::vector<double> values_at(const ReadStudy& study, const Symbolic& formula,
                              const std::vector<double>& parameters,
                              const std::vector<SampledPlace>& places) {
  TapeProgram<double> program(tape_of(formula, formula_inputs(study)), parameters);
  std::vector<double> values;
  const std::size_t axes = study.axes.size();
  for (const SampledPlace& place : places) {
    program.run(std::span(place).first(axes));
    values.push_back(program.output(0));
  }
  return values;
}

}  // namespace shadefit
