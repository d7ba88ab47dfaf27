#include "fit/better/sampled_curve.hpp"

#include <array>

#include "fit/study/measured_rows.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

std::vector<std::vector<double>> even_places(const std::vector<StudyAxis>& axes) {
  constexpr std::array<int, most_axes> steps_in{1000, 48, 12};  // in one, two and three variables
  const int steps = steps_in[axes.size() - 1];
  std::vector<std::vector<double>> places{{}};
  for (const StudyAxis& axis : axes) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& place : places) {
      for (int i = 0; i <= steps; ++i) {
        longer.push_back(place);
        // The last place is the upper end itself.
        longer.back().push_back(i == steps ? axis.upper : axis.lower + (axis.upper - axis.lower) * i / steps);
      }
    }
    places = longer;
  }
  return places;
}

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

}  // namespace

SampledCurve sample_curve(const ReadStudy& study, const std::vector<double>& parameters) {
  SampledCurve curve;
  curve.places = study.rows ? places_of(*study.rows) : even_places(study.axes);
  curve.target = study.rows ? study.rows->value : values_at(study, study.target, parameters, curve.places);
  curve.form = values_at(study, study.form, parameters, curve.places);
  return curve;
}

SampledCurve sample_place(const ReadStudy& study, const std::vector<double>& parameters,
                          const std::vector<double>& place) {
  SampledCurve curve;
  curve.places = {place};
  curve.target = values_at(study, study.target, parameters, curve.places);
  curve.form = values_at(study, study.form, parameters, curve.places);
  return curve;
}

std::vector<double> form_at(const ReadStudy& study, const std::vector<double>& parameters,
                            const std::vector<std::vector<double>>& places) {
  return values_at(study, study.form, parameters, places);
}

}  // namespace shadefit
