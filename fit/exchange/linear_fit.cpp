#include "fit/exchange/linear_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fit/exchange/constrained_study.hpp"
#include "fit/exchange/linear_programmes.hpp"
#include "fit/squares/row_descent.hpp"
#include "fit/squares/rules.hpp"
#include "fit/steps/digits.hpp"
#include "fit/steps/scaled_hessian.hpp"
#include "fit/study/search.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

/// From the programmes to the digits.
class LinearFit {
 public:
  explicit LinearFit(LinearCuts& cuts) : cuts_(cuts), square_(cuts), newton_(cuts) {}

  StudyFit solve() {
    if (cuts_.is_minimax ? lower_level() : lower_square(0)) finish();
    return std::move(cuts_.fit);
  }

 private:
  bool fails(std::string why) { return fail(cuts_.fit, Status::not_converged, std::move(why)); }

  bool lower_level() {
    const std::optional<LeastLevel> least = least_level(cuts_);
    if (!least || !settle_from(*least)) return false;
    const std::vector<Touching> support = newton_.touching;
    const std::size_t before = cuts_.cuts.size();
    if (newton_.hold_level()) {
      newton_.touching = support;
      return true;
    }
    level_support_ = support;
    if (!lower_square(before)) return false;
    cuts_.fit.is_unique = !has_free_step();
    return true;
  }

  /// Newton's method from the vertex of the programme; where few places hold the level, from the least square
  /// of those with nearly this level.
  bool settle_from(const LeastLevel& least) {
    const double promised = cuts_.level;
    const auto n = static_cast<std::size_t>(cuts_.size());
    for (const double slack : {0.0, 1e-6, 1e-4, 1e-2}) {
      cuts_.level = promised;
      if (slack > 0 && !square_.centre(slack)) continue;
      newton_.touching.clear();
      for (std::size_t i = 0; i <= n; ++i)
        newton_.touch(cuts_.cuts[least.vertex.reference[i]], least.vertex.multipliers[i],
                      std::max(near_top, std::sqrt(slack)));
      if (slack == 0 && newton_.touching.size() <= n) continue;
      // The programme's level is a lower bound, and nearly reached.
      constexpr double roundings = 100;
      if (newton_.settle_level() &&
          std::abs(cuts_.level - promised) <= roundings * (least.rounding + cuts_.rounding()))
        return true;
    }
    return fails("Newton's method does not settle at the level, about " + decimal(promised * cuts_.unit, 6));
  }

  bool lower_square(std::size_t before) { return square_.lower(newton_, before) && settle_square(); }

  /// One rule after the other, until the next one moves no digit.
  bool settle_square() {
    const ReadStudy& study = cuts_.study;
    const auto at = [&] {
      return std::vector<long double>(cuts_.parameters.begin(), cuts_.parameters.end());
    };
    long double size = HUGE_VALL;
    for (std::size_t rule = search_rule(study); rule <= Rules(study, cuts_.error).last() && size > settled;
         ++rule) {
      const SampledStudy<long double> wide(cuts_.error, nodes_of(study, cuts_.edges, fit_rules[rule]));
      const auto step = [&] {
        const auto sums = wide.gradient(at());
        const auto square = static_cast<long double>(cuts_.unit * cuts_.unit);
        return newton_.step(square_.hessian(),
                            cuts_.steps.transpose().cast<long double>() * sums.gradient / square, false);
      };
      size = relative_size(step(), cuts_.rounded(), square_.raw_hessian(),
                           static_cast<double>(wide.target_norm()));
      for (int pass = 0; pass < 3; ++pass) step();
      cuts_.fit.rms_error = std::sqrt(static_cast<double>(wide.square(at())));
    }
    cuts_.fit.digits = correct_digits(size);
    return (cuts_.fit.digits >= least_study_digits && newton_.has_signs()) ||
           fails("Newton's method does not settle in long double");
  }

  /// Rounds the answer, checks its conditions, and says where it touches.
  bool finish() {
    // The answer holds its conditions to this share: the place of a top in double has half of the digits.
    constexpr double holds = 1e-9;
    StudyFit& fit = cuts_.fit;
    Wide& parameters = cuts_.parameters;
    fit.parameters = cuts_.rounded();
    const double target = cuts_.sampled.target_norm();
    clear_rounding(fit.parameters, square_.raw_hessian(), target);
    if (!parameters.allFinite()) return fail(fit, Status::not_finite, "a parameter is not finite");
    parameters = wide(fit.parameters);
    const double over = cuts_.add_tops();
    if (!(over <= holds * std::max(cuts_.level, 1e-3) + 1e-14 * target / cuts_.unit))
      return fails("a condition is exceeded by " + decimal(over * cuts_.unit, 2));
    if (cuts_.is_minimax) fit.level = cuts_.level * cuts_.unit;
    tell_touching();
    fit.status = Status::converged;
    return true;
  }

  /// Whether a step from the answer raises no top that is at its bound.
  bool has_free_step() {
    constexpr double at_bound = 1e-7;
    std::vector<Condition> conditions;
    for (std::size_t curve = 0; curve < cuts_.curves.size(); ++curve) {
      if (!cuts_.is_searched(curve)) continue;
      for (const Place& place : cuts_.tops(curve)) {
        const CurvePart part = cuts_.parts({curve, place}).front();
        if (!(cuts_.excess(curve, part) > -at_bound) || !part.slope.allFinite()) continue;
        const VectorOf<double> slope = cuts_.along(part.slope);
        std::copy(slope.begin(), slope.end(), conditions.emplace_back().slope.begin());
      }
    }
    return has_way_on(conditions, cuts_.size());
  }

  void tell_touching() {
    StudyFit& fit = cuts_.fit;
    const double of_square = cuts_.is_minimax && fit.is_unique ? 1 : cuts_.unit;
    std::vector<Touching> all = newton_.touching;
    std::erase_if(all, [&](const Touching& t) { return t.is_held && !level_support_.empty(); });
    all.insert(all.end(), level_support_.begin(), level_support_.end());
    for (const Touching& t : all) {
      if (t.of.part != 0) continue;
      const Place& place = t.of.place;
      const auto error = static_cast<double>(cuts_.parts({0, place}).front().value);
      if (cuts_.study.axes.size() > 1) {
        fit.touching.push_back({place, error});
      } else {
        const double multiplier =
            cuts_.share_of(t.of) > 0 ? t.multiplier : t.multiplier * cuts_.unit * of_square / t.of.unit;
        fit.alternation.push_back(
            {cuts_.curves[t.of.curve].touch, false, {place.front(), 1 - place.front()}, error, multiplier});
      }
    }
    std::ranges::sort(fit.touching, {}, &StudyContact::at);
    std::ranges::sort(fit.alternation, {}, [](const AlternationPoint& point) { return point.at.cos_theta; });
  }

  LinearCuts& cuts_;
  LeastSquare square_;
  LinearNewton newton_;
  std::vector<Touching> level_support_ = {};  ///< the places of the level, where they leave parameters open
};

}  // namespace

bool are_dependent(const SampledStudy<double>& sampled, const std::vector<double>& parameters) {
  VectorOf<double> errors;
  MatrixOf<double> slopes;
  sampled.errors(parameters, errors, &slopes);
  return row_directions(slopes, 1).cols() < slopes.cols();
}

bool keeps_constraints(const LinearProblem& problem, const std::vector<double>& parameters) {
  constexpr double same = 1e-6;
  LinearProblem of_constraints = problem;
  of_constraints.norm = Norm::least_squares;
  LinearCuts cuts(of_constraints);
  if (!cuts.begin(false)) return false;
  cuts.parameters = wide(parameters);
  return cuts.add_tops() <= same;
}

StudyFit solve_linear_fit(const LinearProblem& problem) {
  LinearCuts cuts(problem);
  return cuts.begin(true) ? LinearFit(cuts).solve() : std::move(cuts.fit);
}

}  // namespace shadefit
