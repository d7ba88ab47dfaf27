#include "fit/study_exchange/least_at_level.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/minimax/quadratic_programme.hpp"
#include "fit/quadrature/rule_choice.hpp"
#include "fit/study/search.hpp"
#include "fit/support/decompositions.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

using Wide = VectorOf<long double>;
using Place = std::vector<double>;

/// A multiplier below this is the rounding of 0.
constexpr double no_share = 1e-9;

/// slope . parameters + value, in long double: an error at a place, or the error's slope along an axis.
struct LinearPart {
  Wide slope;
  long double value;
};

/// The error and its slopes along the axes, as linear functions of the parameters.
class LinearParts {
 public:
  explicit LinearParts(const ReadStudy& weighted)
      : size_(weighted.parameters.size()),
        program_(tape_of(weighted.form, formula_inputs(weighted), weighted.axes.size()), {}) {}

  /// Output 0 is the error, output 1 + i its slope along axis i.
  LinearPart operator()(const Place& place, std::size_t output) {
    std::vector<long double> inputs(place.begin(), place.end());
    inputs.resize(place.size() + size_, 0);
    const auto run = [&] {
      program_.run(inputs);
      return program_.output(output);
    };
    LinearPart part{Wide(static_cast<Eigen::Index>(size_)), run()};
    for (std::size_t i = 0; i < size_; ++i) {
      inputs[place.size() + i] = 1;
      part.slope[static_cast<Eigen::Index>(i)] = run() - part.value;
      inputs[place.size() + i] = 0;
    }
    return part;
  }

 private:
  std::size_t size_;
  TapeProgram<long double> program_;
};

/// slope . parameters <= bound, or = bound.
struct WideCondition {
  Wide slope;
  long double bound;
  bool is_equation;
  std::optional<StudyContact> contact = std::nullopt;  ///< of a top, where the error is at its level
};

class LeastAtLevel {
 public:
  LeastAtLevel(const LinearSurface& surface, const LevelSupport& support, const std::vector<double>& start)
      : surface_(surface), errors_(surface.weighted), start_(start), parameters_(start) {
    hold(support);
  }

  std::optional<StudyFit> solve(const TopsOfError& tops) {
    constexpr int most_passes = 40;
    const SampledStudy<double> sampled(surface_.error, nodes(search_rule(surface_.study)));
    hessian_ = sampled.derivatives(start_).hessian;
    for (int pass = 0; pass < most_passes; ++pass) {
      if (!step()) return std::nullopt;
      if (!add_tops(tops(parameters_))) return settled_fit();
    }
    return std::nullopt;
  }

 private:
  StudyNodes nodes(std::size_t rule) const {
    return nodes_of(surface_.study, surface_.edges, fit_rules[rule]);
  }

  long double error_at(const LinearPart& part) const {
    long double value = part.value;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      value += part.slope[static_cast<Eigen::Index>(i)] * static_cast<long double>(parameters_[i]);
    return value;
  }

  /// The conditions of the support. Its errors depend on each other, so that some of them make the others
  /// equal to the level too.
  void hold(const LevelSupport& support) {
    std::vector<std::pair<LinearPart, std::size_t>> held;
    for (std::size_t i = 0; i < support.places.size(); ++i) {
      if (!(support.multipliers[i] > no_share)) continue;
      held.emplace_back(errors_(support.places[i], 0), i);
      level_ +=
          static_cast<long double>(support.multipliers[i] * support.signs[i]) * error_at(held.back().first);
    }
    MatrixOf<double> chosen(static_cast<Eigen::Index>(start_.size()), 0);
    for (const auto& [part, i] : held) {
      const Place& place = support.places[i];
      const auto sign = static_cast<long double>(support.signs[i]);
      contacts_.push_back({place, static_cast<double>(sign * level_)});
      add_falling(place, sign);
      MatrixOf<double> longer(chosen.rows(), chosen.cols() + 1);
      longer << chosen, part.slope.cast<double>();
      constexpr double rounding = 1e-9;  // up to which the multipliers make one slope a sum of the others
      if (pivoted_qr(longer, rounding).rank() < longer.cols()) continue;
      chosen = longer;
      conditions_.push_back({sign * part.slope, level_ - sign * part.value, true});
    }
  }

  /// At an end of the range |error| does not rise into it.
  void add_falling(const Place& place, long double sign) {
    const auto& axes = surface_.weighted.axes;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const bool is_lower = place[axis] == axes[axis].lower;
      if (!is_lower && place[axis] != axes[axis].upper) continue;
      const LinearPart slope = errors_(place, 1 + axis);
      const long double inward = is_lower ? sign : -sign;
      const bool is_open =
          slope.slope.cwiseAbs().maxCoeff() > 0 && slope.slope.allFinite() && std::isfinite(slope.value);
      if (is_open) conditions_.push_back({inward * slope.slope, -inward * slope.value, false});
    }
  }

  /// Finds the parameters with the least square under the conditions so far. Returns whether there are any.
  bool step() {
    std::vector<Condition> conditions;
    for (const WideCondition& wide : conditions_) {
      Condition& condition = conditions.emplace_back();
      condition.is_equation = wide.is_equation;
      long double bound = wide.bound;
      for (std::size_t i = 0; i < start_.size(); ++i) {
        const long double slope = wide.slope[static_cast<Eigen::Index>(i)];
        condition.slope[i] = static_cast<double>(slope);
        bound -= slope * static_cast<long double>(start_[i]);
      }
      condition.bound = static_cast<double>(bound);
    }
    const auto count = static_cast<Eigen::Index>(start_.size());
    const auto answer = least_step(hessian_, VectorOf<double>::Zero(count), conditions);
    if (!answer || !answer->step.allFinite()) return false;
    active_.clear();
    for (const ActiveCondition& active : answer->active) active_.push_back(active.condition);
    parameters_ = moved_by(answer->step, start_);
    return true;
  }

  /// Adds the tops that exceed the level. Returns whether there are any.
  bool add_tops(const std::vector<Place>& tops) {
    // The place of a top has half of the digits, and its height all of them.
    constexpr long double higher = 1e-12L;
    const std::size_t before = conditions_.size();
    for (const Place& place : tops) {
      const LinearPart part = errors_(place, 0);
      const long double error = error_at(part), sign = error > 0 ? 1 : -1;
      if (!(sign * error > level_ * (1 + higher))) continue;
      conditions_.push_back({sign * part.slope, level_ - sign * part.value, false,
                             StudyContact{place, static_cast<double>(sign * level_)}});
    }
    return conditions_.size() > before;
  }

  /// The step of the equations of Karush, Kuhn and Tucker from the parameters.
  Wide newton(const SampledStudy<long double>& sampled) const {
    const auto size = static_cast<Eigen::Index>(start_.size()),
               count = static_cast<Eigen::Index>(active_.size());
    MatrixOf<long double> matrix = MatrixOf<long double>::Zero(size + count, size + count);
    Wide lack(size + count);
    matrix.topLeftCorner(size, size) = hessian_.cast<long double>();
    const std::vector<long double> at(parameters_.begin(), parameters_.end());
    lack.head(size) = -sampled.gradient(at).gradient;
    for (Eigen::Index i = 0; i < count; ++i) {
      const WideCondition& active = conditions_[active_[static_cast<std::size_t>(i)]];
      matrix.col(size + i).head(size) = active.slope;
      matrix.row(size + i).head(size) = active.slope.transpose();
      lack[size + i] = active.bound - active.slope.dot(Eigen::Map<const Wide>(at.data(), size));
    }
    return matrix.fullPivLu().solve(lack).head(size);
  }

  /// One rule after the other, until the next one moves no digit.
  StudyFit settled_fit() {
    StudyFit fit;
    long double size = HUGE_VALL;
    for (std::size_t rule = search_rule(surface_.study); rule < fit_rules.size() && size > settled; ++rule) {
      const SampledStudy<long double> sampled(surface_.error, nodes(rule));
      const Wide first = newton(sampled);
      parameters_ = moved_by(first, parameters_);
      const auto target_norm = static_cast<double>(sampled.target_norm());
      size = relative_size(first, parameters_, hessian_, target_norm);
      parameters_ = moved_by(newton(sampled), parameters_);
      clear_rounding(parameters_, hessian_, target_norm);
    }
    fit.parameters = parameters_;
    fit.digits = correct_digits(size);
    fit.level = static_cast<double>(level_);
    fit.is_unique = false;
    fit.touching = contacts_;
    for (const std::size_t active : active_) {
      if (conditions_[active].contact) fit.touching.push_back(*conditions_[active].contact);
    }
    std::ranges::sort(fit.touching, {}, &StudyContact::at);
    const bool is_settled = fit.digits >= least_study_digits;
    fit.status = is_settled ? Status::converged : Status::not_converged;
    fit.why = is_settled ? "" : "the integral of the squared error does not converge";
    return fit;
  }

  const LinearSurface& surface_;
  LinearParts errors_;
  std::vector<double> start_, parameters_;
  long double level_ = 0;
  MatrixOf<double> hessian_;
  std::vector<WideCondition> conditions_ = {};
  std::vector<std::size_t> active_ = {};
  std::vector<StudyContact> contacts_ = {};
};

}  // namespace

std::optional<StudyFit> least_at_level(const LinearSurface& surface, const LevelSupport& support,
                                       const std::vector<double>& start, const TopsOfError& tops) {
  return LeastAtLevel(surface, support, start).solve(tops);
}

}  // namespace shadefit
