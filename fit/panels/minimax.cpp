#include "fit/panels/minimax.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/panels/contacts.hpp"
#include "fit/panels/panel_curve.hpp"
#include "fit/steps/digits.hpp"

namespace shadefit {
namespace {

/// A step of this size, relative, is Newton's last: the next would be its square.
constexpr double last_step = 1e-7;
/// A multiplier below this counts as zero.
constexpr double no_multiplier = 1e-9;

/// If errors in double differ from those in wider arithmetic by this share of the level, the alternation
/// cannot be seen in double.
constexpr double largest_rounding = 0.1;

/// From a start to the settled alternation.
class RemezExchange {
 public:
  RemezExchange(const MinimaxProblem& problem, const MinimaxParameters& start)
      : problem_(problem), here_(problem, start), counted_(start.size()) {
    result_.level = 0;
  }

  StudyFit solve() {
    const std::string why = here_.hold_exact();
    here_.find_tangents();
    if (why.empty() ? descend() : fail(Status::infeasible, why)) settle();
    result_.parameters = here_.parameters;
    return std::move(result_);
  }

 private:
  bool fail(Status status, std::string why) { return shadefit::fail(result_, status, std::move(why)); }

  /// The programme has no answer. That is a proof if its conditions are those of the constraints, or if the
  /// parameters do not move the violated ones.
  bool fail_to_satisfy() {
    if (problem_.is_linear || here_.is_violation_fixed())
      return fail(Status::infeasible, "no parameters " + here_.most_violated());
    return fail(Status::not_converged,
                "no step from least squares leads to parameters that " + here_.most_violated());
  }

  /// The level, plus a penalty for violated constraints that is larger than the level they could gain.
  double merit() const { return here_.level() + penalty_ * here_.violation(); }

  /// Finds the extrema, takes the step of their linear programme, and repeats until the step is negligible. A
  /// step that does not lower the merit is halved.
  bool descend() {
    MinimaxParameters base = here_.parameters, step(problem_.size);
    double best = HUGE_VAL, scale = 1, size = 1;
    for (int pass = 0; pass < most_steps; ++pass) {
      here_.look();
      if (pass == 0 && here_.is_impossible()) return fail_to_satisfy();
      if (!(merit() < best)) {
        if (pass == 0) return fail(Status::not_finite, "the error at the start is not finite");
        scale /= 2;
        if (scale < 1e-3) return stall(best, size) && go_to(base, step);
        for (std::size_t i = 0; i < problem_.size; ++i) here_.parameters[i] = base[i] + scale * step[i];
        continue;
      }
      Few<Condition> conditions;
      for (const Contact& c : here_.all()) conditions.push_back(here_.condition(c));
      std::array<std::size_t, most_unknowns> reference{};
      LowestLevel lowest{.ending = LowestLevel::Ending::degenerate};
      if (here_.first_reference(conditions, reference))
        lowest = lowest_level({conditions.data(), conditions.size()}, here_.unknowns(),
                              {reference.data(), here_.unknowns()});
      if (lowest.ending == LowestLevel::Ending::infeasible) return fail_to_satisfy();
      if (lowest.ending == LowestLevel::Ending::degenerate)
        return fail(Status::degenerate,
                    "the parameters do not move the error independently where it is largest");
      if (lowest.ending == LowestLevel::Ending::unfinished)
        return fail(Status::not_converged, "the exchange of the reference goes round in circles");

      count_parameters();
      reference_.clear();
      double held_up = 0;
      for (std::size_t i = 0; i < here_.unknowns(); ++i) {
        reference_.push_back(here_.all()[lowest.reference[i]]);
        multipliers_[i] = lowest.multipliers[i];
        if (here_.share_of_level(reference_.back()) == 0) held_up += std::abs(multipliers_[i]);
      }
      penalty_ = std::max(penalty_, 2 * held_up + 1);
      base = here_.parameters;
      best = merit();
      scale = 1;
      size = 0;
      for (std::size_t i = 0; i < problem_.size; ++i) {
        step[i] = lowest.unknowns[i];
        if (!std::isfinite(step[i])) return fail(Status::not_finite, "a step is not finite");
        size = std::max(size, std::abs(step[i]) / counted_[i]);
      }
      expected_ = lowest.unknowns[problem_.size];
      go_to(base, step);
      leads_out_ = !problem_.is_admissible(here_.parameters);
      while (!problem_.is_admissible(here_.parameters)) {
        for (double& part : step) part /= 2;
        size /= 2;
        go_to(base, step);
      }
      // A step that is small beside a parameter may be large beside what the error sees of it: 4 + 1e-8 for
      // the lobe of k = 1e8. Then the programme still promises a lower level.
      constexpr double same_level = 1e-6, roundings = 1e-15;
      if (size < last_step && (size < roundings || best - expected_ < same_level * best))
        return !leads_out_ || stop_at_border();
    }
    if (leads_out_) return stop_at_border();
    return fail(Status::not_converged,
                "the alternation did not settle in " + std::to_string(most_steps) + " exchanges");
  }

  /// The sizes to which steps are compared: those of the parameters. One that is 0, as the odd ones of an
  /// even function, counts as what moves the error by a thousandth of the level.
  void count_parameters() {
    constexpr double negligible = 1e-3;
    for (std::size_t i = 0; i < problem_.size; ++i) {
      counted_[i] = std::abs(here_.parameters[i]);
      if (steepest(i) > 0) counted_[i] = std::max(counted_[i], negligible * here_.level() / steepest(i));
    }
  }

  /// How far a parameter moves the error, for a step of 1, where it moves it most.
  double steepest(std::size_t parameter) const {
    double slope = 0;
    for (const Contact& c : here_.all()) slope = std::max(slope, std::abs(c.gradient[parameter]));
    return slope;
  }

  bool go_to(const MinimaxParameters& base, const MinimaxParameters& step) {
    for (std::size_t i = 0; i < problem_.size; ++i) here_.parameters[i] = base[i] + step[i];
    return true;
  }

  /// The programme's step still leaves the admissible parameters, after steps that each took at least half of
  /// the way to their border. If a constraint is violated there by more than such a rest, no admissible
  /// parameters satisfy it.
  bool stop_at_border() {
    constexpr double rest = 1e-6;
    here_.look();
    if (here_.violation() > rest * here_.level())
      return fail(Status::infeasible, "no admissible parameters near least squares " + here_.most_violated());
    return fail(Status::at_border, "the way down leads to a pole of the form");
  }

  /// The line search failed. If the programme still promises a lower level, the exchange has not converged.
  /// If it does not, a short step means that the level has reached its rounding, and Newton finishes. A long
  /// step means that the level does not determine the parameters.
  bool stall(double best, double size) {
    if (best - expected_ >= 1e-9 * best && size >= last_step)
      return fail(Status::not_converged, "no part of the exchange's step lowers the largest error");
    // With 15 parameters rounding alone makes steps of 1.4e-4. A level that does not determine a parameter
    // allows steps of its own size.
    constexpr double rounding_step = 1e-3;
    if (size < rounding_step) return true;
    return fail(Status::degenerate, "the level is as low as it gets, but fewer than " +
                                        std::to_string(here_.unknowns()) +
                                        " places hold it there: the parameters are not determined");
  }

  /// Newton on the equations of the reference, with residuals in long double, until the step is negligible.
  void settle() {
    for (std::size_t i = 0; i < here_.unknowns(); ++i) {
      if (reference_[i].touch != Touch::exact && !(multipliers_[i] > no_multiplier)) {
        fail(Status::degenerate, "the alternation is degenerate: of its " + std::to_string(here_.unknowns()) +
                                     " places that at " + here_.place_text(reference_[i].place) +
                                     " holds nothing up");
        return;
      }
    }
    long double size = 0;
    // One pass is usual, and a second confirms it.
    for (int pass = 0; pass < 5; ++pass) {
      SmallMatrix matrix{}, inverse{};
      const WideParameters wide(here_.parameters.begin(), here_.parameters.end());
      std::array<long double, most_unknowns> values{};
      long double level = 0;
      for (std::size_t i = 0; i < here_.unknowns(); ++i) {
        Contact& c = reference_[i];
        c = here_.moved(c);
        matrix[i] = here_.condition(c).slope;
        values[i] = here_.curve_of(c.touch).wide(c.place, wide, c.is_tangent);
        level += static_cast<long double>(multipliers_[i] * here_.share_of_level(c) * sign_of(c.touch)) *
                 values[i];
      }
      if (!invert(matrix, here_.unknowns(), inverse)) {
        fail(Status::degenerate, "the equations of the alternation are not independent");
        return;
      }
      // The residual of each equation at this level.
      std::array<long double, most_unknowns> lack{};
      for (std::size_t i = 0; i < here_.unknowns(); ++i) {
        Contact& c = reference_[i];
        const auto sign = static_cast<long double>(sign_of(c.touch));
        const long double bound = c.is_tangent ? 0 : here_.bound_of(c.touch);
        lack[i] = sign * (bound - values[i]) + static_cast<long double>(here_.share_of_level(c)) * level;
        const bool is_error = here_.share_of_level(c) > 0;
        if (is_error) rounding_ = std::max(rounding_, std::abs(c.value - static_cast<double>(values[i])));
        c.value = static_cast<double>(is_error ? values[i] : problem_.error->wide(c.place, wide));
      }
      std::array<long double, most_unknowns> step{};
      for (std::size_t i = 0; i < here_.unknowns(); ++i) {
        for (std::size_t j = 0; j < here_.unknowns(); ++j)
          step[i] += static_cast<long double>(inverse[i][j]) * lack[j];
      }
      result_.level = static_cast<double>(level + step[problem_.size]);
      if (!(rounding_ < largest_rounding * *result_.level)) {
        fail(Status::degenerate,
             "the largest error is down to the rounding of the form: it has no alternation");
        return;
      }
      size = 0;
      for (std::size_t i = 0; i < problem_.size; ++i) {
        size = std::max(size, std::abs(step[i]) / static_cast<long double>(counted_[i]));
      }
      result_.digits = correct_digits(size);
      // Half a unit in the last place of a double is 1.1e-16; a step of more than a few of these is taken
      // once.
      if (size <= static_cast<long double>(pass == 0 ? 3e-16 : settled)) return record();
      for (std::size_t i = 0; i < problem_.size; ++i)
        here_.parameters[i] = static_cast<double>(wide[i] + step[i]);
    }
    // The text of a form may cancel digits. Then fewer digits are right, as in least squares.
    constexpr long double largest_step = 1e-6L;
    if (size <= largest_step) return record();
    fail(Status::not_converged, "Newton's last step is still " + to_text(static_cast<double>(size)) +
                                    " of a parameter: the problem has no 14 digits in this arithmetic");
  }

  void record() {
    result_.status = Status::converged;
    // What moves the error by no more than its rounding in double is the rounding of 0.
    for (std::size_t i = 0; i < problem_.size; ++i) {
      if (std::abs(here_.parameters[i]) * steepest(i) <= rounding_) here_.parameters[i] = 0;
    }
    for (std::size_t i = 0; i < here_.unknowns(); ++i) {
      const Contact& c = reference_[i];
      result_.alternation.push_back(
          {c.touch, c.is_tangent, problem_.cosine_at(c.place), c.value, multipliers_[i]});
    }
    std::ranges::sort(result_.alternation, {},
                      [](const AlternationPoint& point) { return point.at.one_minus_cos; });
  }

  const MinimaxProblem& problem_;
  StudyFit result_;
  Contacts here_;
  Few<Contact> reference_;
  Unknowns multipliers_{};
  MinimaxParameters counted_;
  double penalty_ = 1;
  double rounding_ = 0;     ///< the largest error of double where the error alternates
  double expected_ = 0;     ///< the level promised by the last programme
  bool leads_out_ = false;  ///< whether its step left the admissible parameters, and was cut
};

}  // namespace

StudyFit solve_minimax(const MinimaxProblem& problem, const MinimaxParameters& start) {
  return RemezExchange(problem, start).solve();
}

}  // namespace shadefit
