#include "fit/verdicts/study_objectives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <set>
#include <span>
#include <utility>

#include "fit/catalogue/bounded_study.hpp"
#include "fit/exchange/minimax_study.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/panels/features.hpp"
#include "fit/panels/limits.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/squares/rules.hpp"
#include "fit/squares/solve_in_units.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/verdicts/verdict.hpp"

namespace shadefit {
namespace {

constexpr std::array both_errors{Error::absolute, Error::relative};

/// The objective of a study with this error.
StudyObjective with_error(Study study, Norm norm, Error error, const Constraints& constraints = {}) {
  study.error = error;
  return objective_of(study, norm, constraints);
}

/// Evenly spaced samples of a range: at shares i/(count - 1) of it, or at the middles (i + 1/2)/count.
struct Samples {
  int count;
  bool has_ends;
};

/// The target at evenly spaced samples of each variable; null if one of its values is not finite.
std::shared_ptr<const MeasuredRows> sampled(const std::vector<StudyAxis>& axes, const Tape& target,
                                            const Samples& samples) {
  TapeProgram<double> program(target, {});
  auto rows = std::make_shared<MeasuredRows>();
  rows->places.resize(axes.size());
  std::vector<int> index(axes.size(), 0);
  std::vector<double> place(axes.size());
  while (index.back() < samples.count) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double share = samples.has_ends ? static_cast<double>(index[i]) / (samples.count - 1)
                                            : (index[i] + 0.5) / samples.count;
      place[i] = axes[i].lower + (axes[i].upper - axes[i].lower) * share;
      rows->places[i].push_back(place[i]);
    }
    program.run(place);
    if (!std::isfinite(program.output(0))) return nullptr;
    rows->value.push_back(program.output(0));
    ++index.front();
    for (std::size_t i = 0; i + 1 < axes.size() && index[i] == samples.count; ++i) {
      index[i] = 0;
      ++index[i + 1];
    }
  }
  return rows;
}

bool is_in_unit(const StudyAxis& axis) {
  return 0 <= axis.lower && axis.upper <= 1;
}

/// The samples that scripts usually take: a round number with the ends, a round step, the texels of a table.
std::vector<Samples> usual_samples(const StudyAxis& axis) {
  std::set<int> with_ends{10,  11,  16,  20,  21,  32,  50,  51,   64,   100,  101,
                          128, 200, 201, 256, 257, 500, 501, 1000, 1001, 1024, 4096};
  for (const double per_unit : {10, 20, 50, 100, 200, 1000}) {
    const double steps = (axis.upper - axis.lower) * per_unit;
    const bool is_whole = std::abs(steps - std::round(steps)) < 1e-9;
    if (is_whole && 5 <= steps && steps <= 2000) with_ends.insert(static_cast<int>(std::round(steps)) + 1);
  }
  std::vector<Samples> samples;
  for (const int count : with_ends) samples.push_back({count, true});
  for (const int count : {32, 64, 100, 128, 256, 512, 1000, 1024}) samples.push_back({count, false});
  return samples;
}

/// The same for each of two variables: tables of textures and of scripts.
constexpr std::array usual_grids{Samples{16, true},  Samples{32, true},  Samples{64, true},
                                 Samples{16, false}, Samples{32, false}, Samples{64, false}};

/// "32 even samples", "32 x 32 midpoints"
std::string words_of(const Samples& samples, std::size_t variables) {
  std::string words;
  for (std::size_t i = 0; i < variables; ++i) words += (i == 0 ? "" : " x ") + std::to_string(samples.count);
  return words + (samples.has_ends ? " even samples" : " midpoints");
}

/// The ranges of samples: for a table those of its rows. Midpoints are texels; if the rows come near to 0 and
/// 1, the texels have all of that range.
std::vector<StudyAxis> ranges_of(const ReadStudy& read, const Samples& samples) {
  constexpr double near = 1.0 / 64;
  std::vector<StudyAxis> axes = read.axes;
  for (StudyAxis& axis : axes) {
    if (!read.rows || samples.has_ends || !is_in_unit(axis)) continue;
    if (axis.lower > near || axis.upper < 1 - near) continue;
    axis.lower = 0;
    axis.upper = 1;
  }
  return axes;
}

/// Appends least squares on evenly spaced samples of a target.
void append_samples(const StudyObjective& asked, const ReadStudy& read, const Symbolic& target,
                    std::span<const Samples> usual, std::vector<StudyObjective>& objectives) {
  const std::vector<std::string> variables = variables_of(read.axes);
  const Tape tape = tape_of(target, variables);
  for (const Samples& samples : usual) {
    const auto rows = sampled(ranges_of(read, samples), tape, samples);
    if (!rows || rows->value.size() <= read.parameters.size()) continue;
    Study study = asked.study;
    study.rows = rows;
    study.over.clear();
    for (const std::string& variable : variables) study.over.push_back({variable, "", ""});
    for (const Error error : both_errors)
      objectives.emplace_back(with_error(study, Norm::least_squares, error)).words +=
          ", " + words_of(samples, variables.size());
  }
}

/// Densities over a variable x in [0, 1], with their descriptions: for x as a cosine, and for x = r^2 with a
/// roughness r.
std::vector<std::pair<std::string, std::string>> usual_densities(const std::string& x) {
  return {{"measure angle", density_of("angle", x)},
          {"measure cosine-weighted", density_of("cosine-weighted", x)},
          {"even in the square root", "1/sqrt(" + x + ")"},
          {"even in the logarithm", "1/" + x}};
}

/// A density of one of two variables: as of a cosine, as of a roughness, or plain.
struct DensityOfTwo {
  enum class Kind { plain, cosine, roughness } kind;
  std::string words, density;
};

/// The even densities of a cosine and its angle, and of a roughness r, of alpha = r^2, and of r where the
/// variable is alpha.
std::vector<DensityOfTwo> densities_of_two(const StudyRange& range, const StudyAxis& axis) {
  using Density = DensityOfTwo::Kind;
  std::vector<DensityOfTwo> densities{{Density::plain, "", range.density}};
  if (!is_in_unit(axis)) return densities;
  const std::string& x = axis.variable;
  if (range.density != "1") densities.push_back({Density::plain, "even in " + x, "1"});
  densities.push_back({Density::cosine, "measure angle of " + x, density_of("angle", x)});
  densities.push_back({Density::roughness, "even in the square of " + x, x});
  densities.push_back({Density::roughness, "even in the square root of " + x, "1/sqrt(" + x + ")"});
  return densities;
}

/// Appends least squares under the usual densities of two variables, of which one may be a cosine and the
/// other one a roughness. A fit takes tenths of a second, so only the asked error is tried.
void append_densities_of_two(const StudyObjective& asked, const ReadStudy& read,
                             std::vector<StudyObjective>& objectives) {
  for (const DensityOfTwo& first : densities_of_two(asked.study.over[0], read.axes[0])) {
    for (const DensityOfTwo& second : densities_of_two(asked.study.over[1], read.axes[1])) {
      const bool is_asked = first.words.empty() && second.words.empty();
      const bool is_twice = first.kind == second.kind && first.kind != DensityOfTwo::Kind::plain;
      if (is_asked || is_twice) continue;
      Study study = asked.study;
      study.over[0].density = first.density;
      study.over[1].density = second.density;
      StudyObjective objective = objective_of(study, Norm::least_squares, {});
      for (const std::string& words : {first.words, second.words})
        if (!words.empty()) objective.words += ", " + words;
      objectives.push_back(std::move(objective));
    }
  }
}

/// Parts of a range that a fit may have used, as shares of it: a half, or all but 1 % or 5 % at its ends,
/// where a function may be steep.
constexpr std::array usual_parts{Domain{0.5, 1},  Domain{0, 0.5},     Domain{0.01, 1},
                                 Domain{0.05, 1}, Domain{0.01, 0.99}, Domain{0.05, 0.95}};

/// The study on the same part of the range of each variable.
StudyObjective on_part(const StudyObjective& asked, const ReadStudy& read, const Domain& part) {
  constexpr int digits = 6;  // of an end
  StudyObjective objective = asked;
  for (std::size_t i = 0; i < read.axes.size(); ++i) {
    const auto end = [&, lower = read.axes[i].lower, upper = read.axes[i].upper](double share) {
      return decimal(lower + (upper - lower) * share, digits);
    };
    StudyRange& range = objective.study.over[i];
    range.lower = end(part.lower);
    range.upper = end(part.upper);
    objective.words += ", " + range.variable + " in " + range.lower + ":" + range.upper;
  }
  return objective;
}

/// Appends fits to parts of the range. In two variables a fit takes tenths of a second: there only least
/// squares with the asked error is tried.
void append_parts(const StudyObjective& asked, const ReadStudy& read,
                  std::vector<StudyObjective>& objectives) {
  const bool is_of_one = read.axes.size() == 1;
  for (const Domain& part : usual_parts) {
    for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
      for (const Error error : both_errors) {
        if (!is_of_one && (norm == Norm::minimax || error != asked.study.error)) continue;
        objectives.push_back(on_part(with_error(asked.study, norm, error), read, part));
      }
    }
  }
}

/// Appends least squares under the usual densities of a variable in [0, 1].
void append_densities(const StudyObjective& asked, const StudyAxis& axis,
                      std::vector<StudyObjective>& objectives) {
  if (!is_in_unit(axis)) return;
  for (const auto& [words, density] : usual_densities(axis.variable)) {
    for (const Error error : both_errors) {
      StudyObjective& objective =
          objectives.emplace_back(with_error(asked.study, Norm::least_squares, error));
      objective.study.over.front().density = density;
      objective.words += ", " + words;
    }
  }
}

/// One end of a range, the other, and both.
std::vector<std::vector<double>> choices_of_ends(const StudyAxis& axis) {
  return {{axis.lower}, {axis.upper}, {axis.lower, axis.upper}};
}

/// Appends fits that are exact at these places.
void append_exact_at(const StudyObjective& asked, Norm norm, const std::vector<double>& places,
                     std::vector<StudyObjective>& objectives) {
  for (const Error error : both_errors) {
    StudyObjective objective = with_error(asked.study, norm, error, {.exact_at = places});
    if (objective.words != asked.words) objectives.push_back(std::move(objective));
  }
}

/// Whether a form is its target at a place with these printed constants, as nearly as their last digits
/// allow. It has to depend on them there.
bool is_exact_at(const ReadStudy& study, const std::vector<std::string>& printed, double place) {
  const auto form_with = [&](std::size_t moved) {
    return evaluate<double>(study.form, [&](const std::string& name) {
      const auto i =
          static_cast<std::size_t>(std::ranges::find(study.parameters, name) - study.parameters.begin());
      if (i == printed.size()) return place;
      return constant<double>(printed[i]) + (i == moved ? last_unit(printed[i]) : 0);
    });
  };
  const double form = form_with(printed.size());
  double rounding = 0;
  for (std::size_t i = 0; i < printed.size(); ++i) rounding += std::abs(form_with(i) - form);
  const double target = evaluate<double>(study.target, [&](const std::string&) { return place; });
  return rounding > 0 && std::abs(form - target) <= rounding;
}

}  // namespace

StudyObjective objective_of(const Study& study, Norm norm, const Constraints& constraints) {
  StudyObjective objective{norm == Norm::minimax ? "minimax" : "least squares", study, norm, constraints};
  if (study.error == Error::relative) objective.words += ", relative error";
  objective.words += describe(constraints, study.over.front().variable);
  return objective;
}

StudyObjective holding(StudyObjective objective, const std::string& parameter, double value) {
  std::erase_if(objective.study.starts, [&](const Held& start) { return start.parameter == parameter; });
  objective.study.held.push_back({parameter, value});
  return objective;
}

std::vector<StudyObjective> plain_objectives(const StudyObjective& asked) {
  std::vector<StudyObjective> objectives;
  std::vector<std::string> weights{asked.study.weight};
  if (weights.front() != "1") weights.emplace_back("1");
  for (const std::string& weight : weights) {
    Study study = asked.study;
    study.weight = weight;
    for (const Error error : both_errors) {
      for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
        StudyObjective objective = with_error(study, norm, error);
        if (weight != weights.front()) objective.words += ", without the weight";
        if (objective.words != asked.words) objectives.push_back(std::move(objective));
      }
    }
  }
  return objectives;
}

std::vector<StudyObjective> other_objectives(const StudyObjective& asked) {
  std::vector<StudyObjective> objectives = plain_objectives(asked);
  const ReadStudy read = read_study(asked.study);
  const std::size_t variables = read.axes.size();
  if (variables == 2 && asked.recompute)
    append_samples(asked, read, read_recompute(asked.study, *asked.recompute), usual_grids, objectives);
  if (asked.study.rows || variables > 2) return objectives;
  if (variables == 1) {
    append_densities(asked, read.axes.front(), objectives);
    for (const auto& ends : choices_of_ends(read.axes.front()))
      append_exact_at(asked, Norm::minimax, ends, objectives);
    append_samples(asked, read, read.target, usual_samples(read.axes.front()), objectives);
  } else {
    append_densities_of_two(asked, read, objectives);
    append_samples(asked, read, read.target, usual_grids, objectives);
  }
  append_parts(asked, read, objectives);
  return objectives;
}

std::vector<StudyObjective> exact_least_squares(const StudyObjective& asked,
                                                const std::vector<std::string>& printed) {
  std::vector<StudyObjective> objectives;
  const ReadStudy read = read_study(asked.study);
  if (asked.study.rows || read.axes.size() > 1) return objectives;
  for (const auto& ends : choices_of_ends(read.axes.front())) {
    if (std::ranges::all_of(ends, [&](double end) { return is_exact_at(read, printed, end); }))
      append_exact_at(asked, Norm::least_squares, ends, objectives);
  }
  return objectives;
}

}  // namespace shadefit
