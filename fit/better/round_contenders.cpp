#include "fit/better/round_contenders.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "fit/better/prove_contenders.hpp"
#include "fit/bounds/rounding_bound.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/rounding/study_in_format.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

using Evidence = ContenderInFormat::Evidence;

/// The numbers of a format as text, or which one overflows.
template <class Format>
ContenderInFormat described(const Constants& constants, const std::vector<double>& numbers) {
  ContenderInFormat result{.format = Format::name};
  const BinaryLattice<Format> lattice;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i]))
      return {.format = Format::name,
              .reason = constants[i].first + " overflows: the largest is " + largest_text(lattice)};
    result.constants.emplace_back(constants[i].first, shortest(lattice, lattice.nearest(numbers[i])));
  }
  return result;
}

template <class Format>
std::vector<double> rounded(std::vector<double> values) {
  for (double& value : values) value = static_cast<double>(NarrowResult<Format>::rounded(value));
  return values;
}

/// The error at every place of a study.
template <class Format>
void evaluate(const ReadStudy& read, StudyInFormat<Format>& study, const std::vector<double>& numbers,
              ContenderInFormat& result) {
  const ErrorInFormat largest = study.largest_error(numbers);
  if (std::isfinite(largest.magnitude)) {
    result.bound = largest.magnitude;
    result.evidence = read.rows ? Evidence::every_row : Evidence::every_number;
    return;
  }
  std::string place;
  for (std::size_t i = 0; i < largest.at.size(); ++i)
    place += (i == 0 ? "" : ", ") + read.axes[i].variable + " = " + decimal(largest.at[i], 6);
  result.reason = "overflows or is not a number at " + place;
}

/// A contender in a format, and the study to evaluate other constants in.
template <class Format>
struct RoundedContender {
  ContenderInFormat rounded;
  std::vector<double> numbers;
  std::optional<StudyInFormat<Format>> study = {};  ///< none if a constant overflows, and after a proof
};

/// In float and in two variables by proof: a bound of the error in real numbers, plus a bound of what
/// rounding adds. Otherwise, and for rows, by evaluation; empty if the range holds no number of the format.
template <class Format>
std::optional<RoundedContender<Format>> rounded_to(const StudySubject& subject,
                                                   const StudyContender& contender,
                                                   const std::vector<double>& values,
                                                   const Checkpoint& checkpoint) {
  const ReadStudy read = read_formulas(subject.study);
  const std::vector<double> numbers = rounded<Format>(values);
  RoundedContender<Format> result{described<Format>(subject.parameters, numbers), numbers};
  ContenderInFormat& in_format = result.rounded;
  if (!in_format.reason.empty()) return result;
  if (read.rows || (std::same_as<Format, HalfFormat> && read.axes.size() == 1)) {
    result.study.emplace(read, checkpoint);
    if (result.study->places().empty()) return std::nullopt;
    evaluate(read, *result.study, numbers, in_format);
    return result;
  }
  const double rounding = contender.bound ? bound_of_rounding<Format>(subject, checkpoint) : HUGE_VAL;
  if (std::isfinite(rounding)) {
    in_format.bound = std::nextafter(*contender.bound + rounding, HUGE_VAL);
    in_format.evidence = Evidence::proven;
  } else {
    in_format.reason = "no bound proven";
  }
  return result;
}

/// The best that searches from each start find; empty if that gains no 1 % on the best start.
std::optional<ContenderInFormat> searched(const StudySubject& subject, const StudyContender& contender,
                                          StudyInFormat<HalfFormat>& study,
                                          const std::vector<std::vector<double>>& starts,
                                          const Checkpoint& checkpoint) {
  const std::vector<double> exact_at = constraints_of(contender.properties).exact_at;
  double before = HUGE_VAL, after = HUGE_VAL;
  std::vector<double> best;
  for (const std::vector<double>& start : starts) {
    before = std::min(before, study.largest_error(start).magnitude);
    const std::vector<double> moved = moved_constants(study, start, exact_at, checkpoint);
    const double error = study.largest_error(moved).magnitude;
    if (error < after) best = moved;
    after = std::min(after, error);
  }
  constexpr double worth = 0.99;
  if (!std::isfinite(after) || !(after < worth * before)) return std::nullopt;
  ContenderInFormat result = described<HalfFormat>(subject.parameters, best);
  result.is_moved = true;
  evaluate(read_formulas(subject.study), study, best, result);
  return result;
}

}  // namespace

void round_contenders(StudyComparison& comparison, const Checkpoint& checkpoint) {
  const StudyContender* first = first_published(comparison);
  if (first == nullptr) return;
  const StudyContender* best = better_at_the_same_cost(comparison, *first);
  std::vector<std::vector<double>> starts;
  for (StudyContender& contender : comparison.contenders) {  // published ones stand first
    if (&contender != first && &contender != best) continue;
    const StudySubject subject = subject_of(comparison.study, contender);
    if (!fault_of(subject).empty()) continue;
    std::vector<double> values = contender.values;
    for (const Held& held : comparison.study.held) values.push_back(held.value);
    contender.formats = {rounded_to<FloatFormat>(subject, contender, values, checkpoint)->rounded};
    auto half = rounded_to<HalfFormat>(subject, contender, values, checkpoint);
    if (!half) continue;
    contender.formats.push_back(half->rounded);
    if (!half->study) continue;
    if (contender.form != first->form) starts.clear();
    starts.push_back(half->numbers);
    if (&contender == first || !comparison.study.held.empty()) continue;
    if (const auto other = searched(subject, contender, *half->study, starts, checkpoint))
      contender.formats.push_back(*other);
  }
}

}  // namespace shadefit
