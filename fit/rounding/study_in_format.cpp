#include "fit/rounding/study_in_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "fit/rounding/lattice.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

std::vector<std::string> inputs_of_form(const ReadStudy& study) {
  std::vector<std::string> names = variables_of(study.axes);
  names.insert(names.end(), study.parameters.begin(), study.parameters.end());
  return names;
}

template <class Format>
double rounded_to(double x) {
  return static_cast<double>(NarrowResult<Format>::rounded(x));
}

/// The values of `node_variables` at every number of the range.
template <class Format>
std::vector<std::vector<double>> number_nodes(const ReadStudy& study) {
  if (study.axes.size() > 1) throw std::logic_error("the numbers of two ranges are too many");
  const BinaryLattice<Format> lattice;
  std::vector<std::vector<double>> nodes;
  std::int64_t i = lattice.nearest(study.axes.front().lower);
  if (lattice.value(i) < study.axes.front().lower) ++i;
  for (; i <= lattice.last() && lattice.value(i) <= study.axes.front().upper; ++i)
    nodes.push_back({lattice.value(i)});
  return nodes;
}

/// The values of `node_variables` at every row.
std::vector<std::vector<double>> row_nodes(const ReadStudy& study) {
  const MeasuredRows& rows = *study.rows;
  std::vector<std::vector<double>> nodes;
  for (std::size_t row = 0; row < rows.value.size(); ++row) {
    std::vector<double> node;
    for (const auto& column : rows.places) node.push_back(column[row]);
    node.push_back(rows.value[row]);
    if (!rows.sigma.empty()) node.push_back(rows.sigma[row]);
    nodes.push_back(std::move(node));
  }
  return nodes;
}

/// The factor of form - target in the error by which the sets of a study are compared. The weight 1/sigma of
/// rows comes with their table.
Symbolic factor_of_sets(const ReadStudy& study) {
  const std::string weight = to_text(study.weight);
  const bool is_residual = study.rows && (weight == "1" || weight == "1/sigma");
  return is_residual ? Symbolic::number("1") : error_factor(study);
}

}  // namespace

template <class Format>
StudyInFormat<Format>::StudyInFormat(const ReadStudy& study, const Checkpoint& checkpoint)
    : places_(places_of(study, checkpoint)),
      order_(places_.size()),
      form_(tape_of(study.form, inputs_of_form(study)), {}) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
}

template <class Format>
auto StudyInFormat<Format>::places_of(const ReadStudy& study, const Checkpoint& checkpoint)
    -> std::vector<Sample> {
  const std::vector<std::string> variables = node_variables(study);
  TapeProgram<double> target(tape_of(study.target, variables), {}),
      factor(tape_of(factor_of_sets(study), variables), {});
  std::vector<Sample> places;
  for (const std::vector<double>& node : study.rows ? row_nodes(study) : number_nodes<Format>(study)) {
    checkpoint();
    target.run(node);
    factor.run(node);
    Sample place{{}, target.output(0), factor.output(0)};
    for (std::size_t i = 0; i < study.axes.size(); ++i)
      place.variables.push_back(rounded_to<Format>(node[i]));
    places.push_back(std::move(place));
  }
  return places;
}

template <class Format>
double StudyInFormat<Format>::error_at(const Sample& place, std::span<const double> constants) {
  inputs_.clear();
  for (const double x : place.variables) inputs_.emplace_back(x);
  for (const double x : constants) inputs_.emplace_back(x);
  form_.run(inputs_);
  const double error = std::abs((static_cast<double>(form_.output(0)) - place.target) * place.scale);
  return std::isnan(error) ? HUGE_VAL : error;
}

template <class Format>
ErrorInFormat StudyInFormat<Format>::largest_error(std::span<const double> constants, double enough) {
  ErrorInFormat largest;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < order_.size() && largest.magnitude < enough; ++i) {
    const Sample& place = places_[order_[i]];
    const double error = error_at(place, constants);
    if (i > 0 && error <= largest.magnitude) continue;
    largest = {error, place.variables};
    worst = i;
  }
  const auto first = order_.begin();
  if (worst > 0)
    std::rotate(first, first + static_cast<std::ptrdiff_t>(worst),
                first + static_cast<std::ptrdiff_t>(worst) + 1);
  return largest;
}

template <class Format>
double StudyInFormat<Format>::error_from(double x, std::span<const double> constants) {
  const auto place = std::ranges::find_if(places_, [&](const Sample& p) { return p.variables.front() >= x; });
  return place == places_.end() ? 0 : error_at(*place, constants);
}

template class StudyInFormat<HalfFormat>;
template class StudyInFormat<FloatFormat>;

std::vector<double> moved_constants(StudyInFormat<HalfFormat>& study, std::vector<double> constants,
                                    std::span<const double> kept, const Checkpoint& checkpoint) {
  const BinaryLattice<HalfFormat> lattice;
  constexpr double smaller = 1 - 1e-9;  // equal errors of two curves differ by rounding of the target
  constexpr int farthest = 64;
  const auto errors_at_kept = [&](std::span<const double> values) {
    std::vector<double> errors;
    for (const double x : kept) errors.push_back(study.error_from(x, values));
    return errors;
  };
  const std::vector<double> allowed = errors_at_kept(constants);
  const auto keeps = [&](std::span<const double> values) {
    const std::vector<double> errors = errors_at_kept(values);
    return std::equal(errors.begin(), errors.end(), allowed.begin(),
                      [](double a, double b) { return a <= b; });
  };
  double best = study.largest_error(constants).magnitude;
  const auto moved_by = [&](std::vector<double> values, std::size_t i, std::int64_t steps) {
    const std::int64_t index = lattice.nearest(values[i]) + steps;
    values[i] = lattice.value(std::clamp(index, -lattice.last(), lattice.last()));
    return values;
  };
  const auto takes = [&](const std::vector<double>& moved) {
    const double enough = best * smaller;
    const double error = study.largest_error(moved, enough).magnitude;
    if (!(error < enough) || !keeps(moved)) return false;
    constants = moved;
    best = error;
    return true;
  };
  std::vector<std::int64_t> moves;
  for (std::int64_t steps = 1; steps <= farthest; steps *= 2) moves.insert(moves.end(), {steps, -steps});
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    for (std::size_t i = 0; i < constants.size(); ++i) {
      checkpoint();
      for (const std::int64_t steps : moves) has_moved = takes(moved_by(constants, i, steps)) || has_moved;
      for (std::size_t j = 0; j < i; ++j) {
        for (const std::int64_t a : moves) {
          for (const std::int64_t b : moves)
            has_moved = takes(moved_by(moved_by(constants, i, a), j, b)) || has_moved;
        }
      }
    }
  }
  return constants;
}

}  // namespace shadefit
