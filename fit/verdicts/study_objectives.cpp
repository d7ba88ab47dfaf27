#include "fit/verdicts/study_objectives.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

/// Evenly spaced samples of a range: at shares i/(count - 1) of it, or at the middles (i + 1/2)/count.
struct Samples {
  int count;
  bool has_ends;
};

/// The target at evenly spaced samples; null if one of its values is not finite.
std::shared_ptr<const MeasuredRows> sampled(const ReadStudy& study, const Tape& target,
                                            const Samples& samples) {
  const StudyAxis& axis = study.axes.front();
  TapeProgram<double> program(target, {});
  auto rows = std::make_shared<MeasuredRows>();
  rows->places.resize(1);
  for (int i = 0; i < samples.count; ++i) {
    const double share =
        samples.has_ends ? static_cast<double>(i) / (samples.count - 1) : (i + 0.5) / samples.count;
    const double x = axis.lower + (axis.upper - axis.lower) * share;
    program.run(std::span(&x, 1));
    if (!std::isfinite(program.output(0))) return nullptr;
    rows->places.front().push_back(x);
    rows->value.push_back(program.output(0));
  }
  return rows;
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

/// Appends least squares on evenly spaced samples.
void append_samples(const StudyObjective& asked, const ReadStudy& read,
                    std::vector<StudyObjective>& objectives) {
  const std::vector<std::string> variables{read.axes.front().variable};
  const Tape target = tape_of(read.target, variables);
  for (const Samples& samples : usual_samples(read.axes.front())) {
    if (static_cast<std::size_t>(samples.count) <= read.parameters.size()) continue;
    const auto rows = sampled(read, target, samples);
    if (!rows) continue;
    for (const Error error : {Error::absolute, Error::relative}) {
      Study study = asked.study;
      study.error = error;
      study.rows = rows;
      study.over = {{variables.front(), "", ""}};
      StudyObjective objective = objective_of(study, Norm::least_squares, {});
      objective.words +=
          ", " + std::to_string(samples.count) + (samples.has_ends ? " even samples" : " midpoints");
      objectives.push_back(std::move(objective));
    }
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

}  // namespace

StudyFit fit_study(const StudyObjective& objective, const Checkpoint& checkpoint) {
  const ReadStudy read = read_study(objective.study);
  return objective.norm == Norm::minimax
             ? solve_minimax_study(read, objective.constraints, objective.study.starts, checkpoint)
             : solve_constrained_study(read, objective.constraints, objective.study.starts, checkpoint);
}

StudyObjective objective_of(const Study& study, Norm norm, const Constraints& constraints) {
  StudyObjective objective{norm == Norm::minimax ? "minimax" : "least squares", study, norm, constraints};
  if (study.error == Error::relative) objective.words += ", relative error";
  const std::string& variable = study.over.front().variable;
  for (const double x : constraints.exact_at)
    objective.words += ", exact at " + variable + " = " + to_text(x);
  if (constraints.one_sided)
    objective.words += *constraints.one_sided == Side::above ? ", form >= target" : ", form <= target";
  if (constraints.at_most) objective.words += ", form <= " + to_text(*constraints.at_most);
  if (constraints.at_least) objective.words += ", form >= " + to_text(*constraints.at_least);
  if (constraints.monotone) objective.words += ", form " + std::string(name(*constraints.monotone));
  return objective;
}

StudyObjective holding(StudyObjective objective, const std::string& parameter, double value) {
  std::erase_if(objective.study.starts, [&](const Held& start) { return start.parameter == parameter; });
  objective.study.held.push_back({parameter, value});
  return objective;
}

std::vector<StudyObjective> other_objectives(const StudyObjective& asked) {
  std::vector<StudyObjective> objectives;
  const auto add = [&](StudyObjective objective, const std::string& more = "") {
    objective.words += more;
    if (objective.words != asked.words) objectives.push_back(std::move(objective));
  };
  const std::array errors{Error::absolute, Error::relative};
  std::vector<std::string> weights{asked.study.weight};
  if (weights.front() != "1") weights.emplace_back("1");
  for (const std::string& weight : weights) {
    for (const Error error : errors) {
      Study study = asked.study;
      study.error = error;
      study.weight = weight;
      const std::string words = weight == weights.front() ? "" : ", without the weight";
      add(objective_of(study, Norm::least_squares, {}), words);
      add(objective_of(study, Norm::minimax, {}), words);
    }
  }
  if (asked.study.rows || asked.study.over.size() > 1) return objectives;
  const ReadStudy read = read_study(asked.study);
  const StudyAxis& axis = read.axes.front();
  if (0 <= axis.lower && axis.upper <= 1) {
    for (const auto& [words, density] : usual_densities(axis.variable)) {
      for (const Error error : errors) {
        StudyObjective objective = asked;
        objective.study.error = error;
        objective = objective_of(objective.study, Norm::least_squares, {});
        objective.study.over.front().density = density;
        objective.words += ", " + words;
        add(std::move(objective));
      }
    }
  }
  for (const auto& ends :
       {std::vector{axis.lower}, std::vector{axis.upper}, std::vector{axis.lower, axis.upper}}) {
    for (const Error error : errors) {
      Study study = asked.study;
      study.error = error;
      add(objective_of(study, Norm::minimax, {.exact_at = ends}));
    }
  }
  append_samples(asked, read, objectives);
  return objectives;
}

}  // namespace shadefit
