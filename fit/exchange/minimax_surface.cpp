#include "fit/exchange/minimax_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fit/exchange/beyond_infinity.hpp"
#include "fit/exchange/curved_level.hpp"
#include "fit/exchange/linear_fit.hpp"
#include "fit/exchange/surface_programme.hpp"
#include "fit/squares/confirm_integrals.hpp"
#include "fit/squares/rules.hpp"
#include "fit/steps/digits.hpp"
#include "fit/steps/quadratic_programme.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

/// The exchange from one start.
class SurfaceExchange {
 public:
  SurfaceExchange(const ReadStudy& study, const StudyError& error, const SampledStudy<double>& sampled,
                  const std::vector<double>& start)
      : error_(error),
        study_(study),
        sampled_(sampled),
        parameters_(start),
        size_(parameters_.size()),
        edges_(edges_of(study)),
        tops_(study, edges_),
        places_(study) {}

  StudyFit solve(const Checkpoint& checkpoint) {
    level_ = look(parameters_);
    std::vector<double> base = parameters_;
    double scale = 1;
    for (int step = 0; step < most_steps; ++step) {
      checkpoint();
      const auto support = level_step(error_, places_.all(), base, sampled_.target_norm());
      if (!support) return failed(Status::degenerate, "the parameters do not move the error independently");
      support_ = *support;
      const double promised = support_.lowest.unknowns[size_];
      if (!(level_ > 1e-14 * sampled_.target_norm()))
        return failed(Status::degenerate,
                      "the largest error is down to the rounding of the form: it has no level");
      if (level_ - promised <= agree * level_ + support_.rounding) return checked(settled(base));
      for (std::size_t i = 0; i < size_; ++i) parameters_[i] = base[i] + scale * support_.lowest.unknowns[i];
      const double level = look(parameters_);
      if (level < level_) {
        level_ = level;
        base = parameters_;
        scale = 1;
        continue;
      }
      scale /= 2;
      if (scale < 1e-6) return checked(settled(base));
    }
    const auto fit = curved_level(study_, edges_, places_.all(), base, checkpoint);
    return fit ? *fit
               : failed(Status::not_converged, "fewer than " + std::to_string(size_ + 1) +
                                                   " tops of the error hold the level, about " +
                                                   decimal(level_, 4));
  }

  /// Where the exchange ended.
  const std::vector<double>& parameters() const { return parameters_; }

  /// Returns the largest error, infinite at a pole, and adds its tops to the set.
  double look(const std::vector<double>& parameters) {
    if (sampled_.has_pole(parameters)) return HUGE_VAL;
    double largest = 0;
    places_.look_again();
    for (const StudyExtremum& top : tops_.all(parameters)) {
      if (!std::isfinite(top.magnitude)) return HUGE_VAL;
      largest = std::max(largest, top.magnitude);
      places_.add(top.at);
    }
    return largest;
  }

 private:
  static constexpr int most_steps = 40;
  /// Newton's method starts when the programme and the search for tops agree on the level to this share of
  /// it.
  static constexpr double agree = 1e-10;
  /// A top within this share of the level is at the level. Newton's method moves tops outside the support by
  /// less.
  static constexpr double same_level = 1e-9;

  StudyFit failed(Status status, std::string why) const {
    StudyFit fit;
    fit.level = level_;
    fit.parameters = parameters_;
    fail(fit, status, std::move(why));
    return fit;
  }

  /// Checks that the error of a fit is nowhere larger than its level.
  StudyFit checked(StudyFit fit) {
    if (fit.status != Status::converged) return fit;
    // The place of a top on an edge has only half of the digits, so the level is checked to 8 digits.
    constexpr double held = 1e-8;
    const double largest = look(fit.parameters);
    if (largest <= *fit.level * (1 + held) + support_.rounding) return fit;
    fail(fit, Status::not_converged,
         "the error exceeds its level, " + decimal(*fit.level, 6) + ", by " +
             decimal(largest - *fit.level, 2));
    return fit;
  }

  /// Newton's method in long double: the errors of the support are plus or minus the level.
  StudyFit settled(const std::vector<double>& base) {
    const std::size_t unknowns = size_ + 1;
    Places support;
    for (const std::size_t place : support_.places) support.push_back(places_.all()[place]);
    StudyFit fit;
    fit.parameters = base;
    const SampledStudy<double> sampled(error_, nodes_at(support));
    const SampledStudy<long double> wide(error_, nodes_at(support));
    for (int pass = 0; pass < 3; ++pass) {
      VectorOf<double> errors;
      MatrixOf<double> slopes;
      sampled.errors(fit.parameters, errors, &slopes);
      SmallMatrix matrix{}, inverse{};
      for (std::size_t i = 0; i < unknowns; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        for (std::size_t j = 0; j < size_; ++j) matrix[i][j] = slopes(k, static_cast<Eigen::Index>(j));
        matrix[i][size_] = -support_.signs[i];
      }
      if (!invert(matrix, unknowns, inverse))
        return failed(Status::degenerate, "the equations of the places at the level are not independent");
      VectorOf<long double> values;
      const std::vector<long double> at(fit.parameters.begin(), fit.parameters.end());
      wide.errors(at, values, nullptr);
      long double size = 0;
      for (std::size_t j = 0; j <= size_; ++j) {
        long double next = 0;
        for (std::size_t i = 0; i < unknowns; ++i)
          next -= static_cast<long double>(inverse[j][i]) * values[static_cast<Eigen::Index>(i)];
        if (j == size_) {
          fit.level = static_cast<double>(next);
          continue;
        }
        const double steepest = slopes.col(static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
        size =
            std::max(size, std::abs(next) / std::max(std::abs(fit.parameters[j]), 1e-3 * level_ / steepest));
        fit.parameters[j] = static_cast<double>(at[j] + next);
        if (std::abs(fit.parameters[j]) * steepest <= support_.rounding) fit.parameters[j] = 0;
      }
      fit.digits = correct_digits(size);
    }
    for (std::size_t i = 0; i < unknowns; ++i)
      fit.touching.push_back({support[i], support_.signs[i] * *fit.level});
    std::ranges::sort(fit.touching, {}, &StudyContact::at);
    fit.status = fit.digits < least_study_digits ? Status::not_converged : Status::converged;
    fit.why = fit.status == Status::converged ? "" : "Newton's method does not settle in long double";
    if (!is_determined(fit)) {
      fail(fit, Status::degenerate,
           "the level, " + decimal(*fit.level, 10) + ", is the least, but other parameters have it too");
    }
    return fit;
  }

  /// Whether no other parameters have this level: each step raises an error that is at it.
  bool is_determined(const StudyFit& fit) const {
    VectorOf<double> errors;
    MatrixOf<double> slopes;
    SampledStudy<double>(error_, nodes_at(places_.all())).errors(fit.parameters, errors, &slopes);
    const VectorOf<double> scale = slopes.cwiseAbs().colwise().maxCoeff();
    std::vector<Condition> touching;
    constexpr double rounding = 1e-12;
    for (Eigen::Index row = 0; row < errors.size(); ++row) {
      if (std::abs(errors[row]) < *fit.level * (1 - same_level) - support_.rounding) continue;
      const double sign = errors[row] < 0 ? -1 : 1;
      const VectorOf<double> slope = sign * slopes.row(row).transpose().cwiseQuotient(scale);
      std::copy(slope.begin(), slope.end(), touching.emplace_back(Condition{{}, rounding}).slope.begin());
    }
    return !has_way_on(touching, slopes.cols());
  }

  const StudyError& error_;
  const ReadStudy& study_;
  const SampledStudy<double>& sampled_;  ///< detects poles
  std::vector<double> parameters_;
  std::size_t size_;
  Edges edges_;
  ErrorTops tops_;
  TopPlaces places_;
  LevelStep support_ = {};
  double level_ = 0;
};

}  // namespace

StudyFit solve_minimax_surface(const ReadStudy& study, const std::vector<Held>& starts,
                               const Checkpoint& checkpoint) {
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, edges_of(study), starts, checkpoint);

  std::optional<StudyFit> lowest;
  // Returns where to go on: on the other side of infinity, if the lowest exchange so far ran there.
  const auto exchange_from = [&](const std::vector<double>& start) -> std::optional<std::vector<double>> {
    SurfaceExchange exchange(study, error, searched.sampled, start);
    StudyFit fit = exchange.solve(checkpoint);
    const bool is_better = !lowest || (fit.level && (!lowest->level || *fit.level < *lowest->level));
    if (!is_better) return std::nullopt;
    lowest = std::move(fit);
    if (lowest->status == Status::converged) return std::nullopt;
    const std::vector<double> end = exchange.parameters();
    return beyond_infinity(start, end, [&](const std::vector<double>& at) { return exchange.look(at); });
  };
  if (searched.is_linear)
    lowest = solve_linear_fit({study,
                               error,
                               Norm::minimax,
                               {},
                               edges_of(study),
                               searched.sampled,
                               searched.candidates.front().parameters,
                               checkpoint});
  for (const StudyCandidate& candidate : lowest_basins(searched)) {
    if (searched.is_linear) break;
    if (const auto other_side = exchange_from(candidate.parameters)) exchange_from(*other_side);
  }
  StudyFit best = std::move(*lowest);
  best.names = study.parameters;
  best.starts = searched.starts;
  best.is_global = searched.is_linear;
  if (best.status != Status::converged) return best;
  best.rms_error = rms_error(study, error, best.parameters);
  best.max_abs_error = largest_error(study, best.parameters);
  confirm_integrals(study, best);
  return best;
}

}  // namespace shadefit
