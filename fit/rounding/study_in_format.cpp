#include "fit/rounding/study_in_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>

#include "approx/encoding.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/scalars/rounded_interval.hpp"
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

/// No range of half or bfloat16 holds more numbers.
constexpr std::int64_t most_numbers = 1 << 16;

/// The indices of all numbers between two of a lattice. If these are too many: even steps in the list of all,
/// which is dense at 0, and even steps in the range.
template <class Format>
std::vector<std::int64_t> numbers_between(std::int64_t first, std::int64_t last) {
  constexpr std::int64_t steps = most_numbers / 8;
  const BinaryLattice<Format> lattice;
  std::vector<std::int64_t> numbers;
  if (last - first < most_numbers) {
    for (std::int64_t i = first; i <= last; ++i) numbers.push_back(i);
    return numbers;
  }
  const double lower = lattice.value(first), upper = lattice.value(last);
  for (std::int64_t k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    numbers.push_back(first + (last - first) / steps * k);
    numbers.push_back(std::clamp(lattice.nearest(lower * (1 - share) + upper * share), first, last));
  }
  numbers.push_back(last);
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// The values of `node_variables` at the numbers of the range.
template <class Format>
std::vector<std::vector<double>> number_nodes(const ReadStudy& study) {
  if (study.axes.size() > 1) throw std::logic_error("the numbers of two ranges are too many");
  const auto [first, last] = numbers_in<Format>(study.axes.front());
  std::vector<std::vector<double>> nodes;
  for (const std::int64_t i : numbers_between<Format>(first, last))
    nodes.push_back({BinaryLattice<Format>{}.value(i)});
  return nodes;
}

/// The values of `node_variables` at every row.
std::vector<std::vector<double>> row_nodes(const ReadStudy& study) {
  std::vector<std::vector<double>> nodes(study.rows->value.size());
  for (const std::vector<double>* column : columns_of(*study.rows))
    for (std::size_t row = 0; row < nodes.size(); ++row) nodes[row].push_back((*column)[row]);
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
    : target_(tape_of(study.target, node_variables(study)), {}),
      factor_(tape_of(factor_of_sets(study), node_variables(study)), {}),
      axes_(study.axes.size()),
      form_(tape_of(study.form, inputs_of_form(study)), {}) {
  for (const std::vector<double>& node : study.rows ? row_nodes(study) : number_nodes<Format>(study)) {
    checkpoint();
    places_.push_back(place_at(node));
  }
  order_.resize(places_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
}

template <class Format>
PlaceInFormat StudyInFormat<Format>::place_at(const std::vector<double>& node) {
  target_.run(node);
  factor_.run(node);
  PlaceInFormat place{{}, target_.output(0), factor_.output(0)};
  for (std::size_t i = 0; i < axes_; ++i) place.variables.push_back(rounded_to<Format>(node[i]));
  return place;
}

template <class Format>
void StudyInFormat<Format>::add(double x) {
  order_.insert(order_.begin(), places_.size());
  places_.push_back(place_at({x}));
}

template <class Format>
double StudyInFormat<Format>::form_at(const PlaceInFormat& place, std::span<const double> constants) {
  inputs_.clear();
  for (const double x : place.variables) inputs_.emplace_back(x);
  for (const double x : constants) inputs_.emplace_back(x);
  form_.run(inputs_);
  return static_cast<double>(form_.output(0));
}

template <class Format>
double StudyInFormat<Format>::error_at(const PlaceInFormat& place, std::span<const double> constants) {
  const double off = form_at(place, constants) - place.target;
  const double error = off == 0 ? 0 : std::abs(off * place.scale);
  return std::isnan(error) ? HUGE_VAL : error;
}

template <class Format>
ErrorInFormat StudyInFormat<Format>::largest_error(std::span<const double> constants, double enough) {
  ++tried_;
  ErrorInFormat largest;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < order_.size() && largest.magnitude < enough; ++i) {
    const PlaceInFormat& place = places_[order_[i]];
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
  const auto place =
      std::ranges::find_if(places_, [&](const PlaceInFormat& p) { return p.variables.front() >= x; });
  return place == places_.end() ? 0 : error_at(*place, constants);
}

template <class Format>
std::optional<double> StudyInFormat<Format>::srgb_codes(std::span<const double> constants) {
  double codes = 0;
  for (const PlaceInFormat& place : places_) {
    if (!(0 <= place.target && place.target <= 1)) return std::nullopt;
    codes = std::max(codes, std::abs(srgb_code(form_at(place, constants)) - srgb_code(place.target)));
  }
  return codes;
}

template <class Format>
double StudyInFormat<Format>::bound_on_gpu(std::span<const double> constants,
                                           const Checkpoint& checkpoint) const {
  using T = RoundedInterval<GpuArithmetic<Format>>;
  std::vector<T> numbers, variables;
  for (const double x : constants) numbers.push_back(T::number(x, x));
  TapeProgram<T> form(form_.tape(), numbers);
  double bound = 0;
  for (const PlaceInFormat& place : places_) {
    checkpoint();
    variables.clear();
    for (const double x : place.variables) variables.emplace_back(x);
    form.run(variables);
    const T& result = form.output(0);
    const double off = std::max(result.upper() - place.target, place.target - result.lower());
    const double error = off == 0 ? 0 : off * std::abs(place.scale);
    bound = std::max(bound, std::isnan(error) ? HUGE_VAL : error);
  }
  return bound;
}

template class StudyInFormat<HalfFormat>;
template class StudyInFormat<Bfloat16Format>;
template class StudyInFormat<FloatFormat>;

template <class Format>
std::vector<double> moved_constants(StudyInFormat<Format>& study, std::vector<double> constants,
                                    std::span<const double> kept, const Checkpoint& checkpoint) {
  const BinaryLattice<Format> lattice;
  constexpr double smaller = 1 - 1e-9;  // equal errors of two curves differ by rounding of the target
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
  for (std::int64_t steps = 1; steps <= farthest_move; steps *= 2) moves.insert(moves.end(), {steps, -steps});
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

template std::vector<double> moved_constants(StudyInFormat<HalfFormat>&, std::vector<double>,
                                             std::span<const double>, const Checkpoint&);
template std::vector<double> moved_constants(StudyInFormat<FloatFormat>&, std::vector<double>,
                                             std::span<const double>, const Checkpoint&);

}  // namespace shadefit
