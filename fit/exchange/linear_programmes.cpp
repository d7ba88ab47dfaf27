#include "fit/exchange/linear_programmes.hpp"

#include <algorithm>
#include <span>

#include "fit/exchange/surface_programme.hpp"
#include "fit/squares/rules.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// A reference of the error alone. Its cuts are the first ones, and those of its negative follow.
std::optional<LowestLevel> first_vertex(const LinearCuts& cuts) {
  const auto rows =
      std::count_if(cuts.cuts.begin(), cuts.cuts.end(), [](const Cut& cut) { return cut.of.curve == 0; });
  Vector errors(rows);
  Matrix slopes(rows, cuts.size());
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Condition& condition = cuts.cuts[static_cast<std::size_t>(i)].condition;
    errors[i] = -condition.bound;
    slopes.row(i) = Eigen::Map<const Vector>(condition.slope.data(), cuts.size());
  }
  const auto step = level_step(errors, slopes, least_excess);
  if (!step) return std::nullopt;
  LowestLevel lowest = step->lowest;
  for (std::size_t i = 0; i < step->places.size(); ++i)
    lowest.reference[i] = step->places[i] + (step->signs[i] > 0 ? 0 : static_cast<std::size_t>(rows));
  return lowest;
}

/// Whether a place is so near one that is held that its condition says the same.
bool is_held_at(const LinearCuts& cuts, const std::vector<Touching>& held, const Cut& cut) {
  constexpr double same = 1e-3;  // of the range
  return std::any_of(held.begin(), held.end(), [&](const Touching& t) {
    return t.of.curve == cut.of.curve && t.of.part == 0 && cut.of.part == 0 &&
           are_near(t.of.place, cut.of.place, cuts.study.axes, same);
  });
}

}  // namespace

std::optional<LeastLevel> least_level(LinearCuts& cuts) {
  const auto n = static_cast<std::size_t>(cuts.size());
  const auto ended = [&](Status status, const char* why) {
    fail(cuts.fit, status, why);
    return std::nullopt;
  };
  std::optional<LowestLevel> lowest = first_vertex(cuts);
  if (!lowest) return ended(Status::degenerate, "the parameters do not move the error independently");
  double rounding = least_excess / 10;
  for (std::size_t known = 0; known != cuts.cuts.size();) {
    std::vector<Condition> conditions;
    for (const Cut& cut : cuts.cuts) conditions.push_back(cut.condition);
    const LowestLevel next =
        lowest_level(conditions, n + 1, std::span(lowest->reference).first(n + 1), rounding);
    if (next.ending == LowestLevel::Ending::infeasible) {
      cuts.end_violated();
      return std::nullopt;
    }
    if (next.ending != LowestLevel::Ending::found) {
      // Cuts of one top that are close to each other round more. Newton's method finds the digits.
      constexpr double most_rounding = 1e-6;
      if (rounding > most_rounding) break;
      rounding *= 10;
      continue;
    }
    known = cuts.cuts.size();
    lowest = next;
    cuts.level = lowest->unknowns[n];
    cuts.step_to(Eigen::Map<const Vector>(lowest->unknowns.data(), cuts.size()));
    cuts.add_tops();
  }
  cuts.fit.parameters = cuts.rounded();
  if (!(cuts.level * cuts.unit > 1e-14 * cuts.sampled.target_norm()))
    return ended(Status::degenerate,
                 "the largest error is down to the rounding of the form: it has no level");
  return LeastLevel{*lowest, rounding};
}

LeastSquare::LeastSquare(LinearCuts& cuts) : cuts_(cuts) {
  const SampledStudy<double> sampled(cuts.error,
                                     nodes_of(cuts.study, cuts.edges, fit_rules[search_rule(cuts.study)]));
  const auto sums = sampled.derivatives(cuts.free);
  raw_hessian_ = sums.hessian;
  hessian_ = cuts.steps.transpose() * sums.hessian * cuts.steps / (cuts.unit * cuts.unit);
  gradient_ = cuts.steps.transpose() * sums.gradient / (cuts.unit * cuts.unit);
}

/// The step with the least square under the conditions so far, and the cut of each; null for what is held.
std::optional<QuadraticAnswer> LeastSquare::step(double slack, const std::vector<Touching>& held,
                                                 std::size_t before, std::vector<const Cut*>& of) const {
  std::vector<Condition> all;
  of.assign(held.size(), nullptr);
  for (const Touching& t : held) {
    all.push_back(cuts_.condition(t.of));
    all.back().bound += cuts_.share_of(t.of) * cuts_.level;
    all.back().is_equation = true;
  }
  for (std::size_t i = 0; i < cuts_.cuts.size(); ++i) {
    const Cut& cut = cuts_.cuts[i];
    if (i < before && is_held_at(cuts_, held, cut)) continue;
    all.push_back(cut.condition);
    all.back().bound += cuts_.share_of(cut.of) * cuts_.level + slack;
    of.push_back(&cut);
  }
  const auto answer = least_step(hessian_, gradient_, all);
  return answer && answer->step.allFinite() ? answer : std::nullopt;
}

bool LeastSquare::centre(double slack) {
  for (std::size_t known = 0; known != cuts_.cuts.size();) {
    known = cuts_.cuts.size();
    std::vector<const Cut*> of;
    const auto answer = step(slack, {}, 0, of);
    if (!answer) return false;
    cuts_.step_to(answer->step);
    if (cuts_.add_tops() < slack) break;
  }
  return true;
}

bool LeastSquare::lower(LinearNewton& newton, std::size_t before) {
  const std::vector<Touching> held = newton.touching;
  double slack = least_excess / 10;
  for (std::size_t known = 0; known != cuts_.cuts.size();) {
    std::vector<const Cut*> of;
    const auto answer = step(slack, held, before, of);
    if (!answer) {
      // The conditions at a level leave no room: up to rounding they contradict each other.
      constexpr double most_slack = 1e-7;
      if (slack <= most_slack) {
        slack *= 10;
        continue;
      }
      return held.empty()
                 ? cuts_.end_violated()
                 : fail(cuts_.fit, Status::not_converged, "the programme has no answer up to its rounding");
    }
    known = cuts_.cuts.size();
    cuts_.step_to(answer->step);
    newton.touching = held;
    for (const ActiveCondition& active : answer->active) {
      if (of[active.condition] == nullptr) {
        newton.touching[active.condition].multiplier = active.multiplier;
      } else {
        newton.touch(*of[active.condition], active.multiplier);
      }
    }
    cuts_.add_tops();
  }
  return true;
}

}  // namespace shadefit
