#include "fit/study_exchange/minimax_surface.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "fit/least_squares/least_squares.hpp"
#include "fit/minimax/linear_programme.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/study_exchange/beyond_infinity.hpp"
#include "fit/study_exchange/determined.hpp"
#include "fit/study_exchange/least_at_level.hpp"
#include "fit/study_exchange/top_polish.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

using Places = std::vector<std::vector<double>>;

std::vector<std::vector<StudyEdge>> all_edges_of(const ReadStudy& study) {
  std::vector<std::vector<StudyEdge>> edges;
  for (std::size_t i = 0; i < study.axes.size(); ++i) edges.push_back(edges_of(study, i));
  return edges;
}

StudyNodes nodes_at(const Places& places) {
  StudyNodes nodes;
  nodes.coordinates.resize(places.front().size());
  for (const auto& place : places) {
    for (std::size_t i = 0; i < place.size(); ++i) nodes.coordinates[i].push_back(place[i]);
  }
  nodes.weights.assign(places.size(), 1.0L / static_cast<long double>(places.size()));
  return nodes;
}

/// error <= level, and -error <= level, for a step of the parameters from here.
Condition condition(double error, const VectorOf<double>& slope, double sign) {
  Condition result{{}, -sign * error};
  for (Eigen::Index i = 0; i < slope.size(); ++i) result.slope[static_cast<std::size_t>(i)] = sign * slope[i];
  result.slope[static_cast<std::size_t>(slope.size())] = -1;
  return result;
}

/// Where the error is at its level after a step of the linear programme.
struct Support {
  LowestLevel lowest;
  std::vector<std::size_t> places;  ///< indices in the set
  std::vector<double> signs;        ///< of the errors there
};

/// The exchange from one start.
class SurfaceExchange {
 public:
  SurfaceExchange(const ReadStudy& study, const StudyError& error, const SampledStudy<double>& sampled,
                  const std::vector<double>& start)
      : error_(error),
        study_(study),
        sampled_(sampled),
        start_(start),
        weighted_(weighted_error_of(study)),
        parameters_(start),
        size_(parameters_.size()),
        edges_(all_edges_of(study)),
        polish_(weighted_, edges_) {}

  StudyFit solve(const Checkpoint& checkpoint) {
    add_grid();
    level_ = look(parameters_);
    std::vector<double> base = parameters_;
    double scale = 1;
    int stays = 0;  // programmes since the level last rose
    for (int step = 0; step < most_steps; ++step) {
      checkpoint();
      const auto support = programme(base);
      if (!support) return failed(Status::degenerate, "the parameters do not move the error independently");
      support_ = *support;
      const double promised = support_.lowest.unknowns[size_];
      if (promised > promised_ * (1 + agree)) {
        promised_ = promised;
        highest_ = level_support();
        stays = 0;
      } else {
        ++stays;
      }
      if (!(level_ > 1e-14 * sampled_.target_norm()))
        return failed(Status::degenerate,
                      "the largest error is down to the rounding of the form: it has no level");
      if (level_ - promised <= agree * level_ + rounding_) return checked(settled(base));
      if (stays == enough_stays && leaves_open(highest_)) {
        if (const auto fit = least_of_many()) return *fit;
      }
      for (std::size_t i = 0; i < size_; ++i) parameters_[i] = base[i] + scale * support_.lowest.unknowns[i];
      const Places before = places_;
      const double level = look(parameters_);
      if (level < level_) {
        level_ = level;
        base = parameters_;
        scale = 1;
        continue;
      }
      // A linear form needs no smaller steps, only the new tops.
      if (!is_linear()) scale /= 2;
      if (is_linear() ? places_ == before : scale < 1e-6) return checked(settled(base));
    }
    const auto fit = least_of_many();
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
    ++look_;
    for (const StudyExtremum& top : tops_of_error(weighted_, edges_, parameters, 0.3)) {
      if (!std::isfinite(top.magnitude)) return HUGE_VAL;
      largest = std::max(largest, top.magnitude);
      add(polish_(top.at, parameters));
    }
    return largest;
  }

 private:
  static constexpr int most_steps = 40;
  /// After so many programmes of one level the tops of the error hardly change it.
  static constexpr int enough_stays = 3;
  /// Newton's method starts when the programme and the search for tops agree on the level to this share of
  /// it.
  static constexpr double agree = 1e-10;
  /// A top within this share of the level is at the level. Newton's method moves tops outside the support by
  /// less.
  static constexpr double same_level = 1e-9;
  /// A top closer than this share of the range to an earlier one is the same top.
  static constexpr double same_top = 0.01;

  bool is_linear() const {
    const auto& linear = error_.is_linear();
    return std::find(linear.begin(), linear.end(), false) == linear.end();
  }

  /// The places of the last programme.
  LevelSupport level_support() const {
    LevelSupport result{{}, support_.signs, {}};
    for (std::size_t i = 0; i <= size_; ++i) {
      result.places.push_back(places_[support_.places[i]]);
      result.multipliers.push_back(support_.lowest.multipliers[i]);
    }
    return result;
  }

  /// Whether a support has fewer places with a multiplier than determine the parameters.
  bool leaves_open(const LevelSupport& support) const {
    const auto count = std::count_if(support.multipliers.begin(), support.multipliers.end(),
                                     [](double multiplier) { return multiplier > 1e-9; });
    return static_cast<std::size_t>(count) <= size_;
  }

  /// If the form is linear, and many parameters have the least level, those with the least mean square.
  std::optional<StudyFit> least_of_many() {
    if (!is_linear()) return std::nullopt;
    const auto tops = [&](const std::vector<double>& parameters) {
      Places places;
      for (const StudyExtremum& top : tops_of_error(weighted_, edges_, parameters, 0.3))
        places.push_back(polish_(top.at, parameters));
      return places;
    };
    const auto fit = least_at_level({study_, weighted_, error_, edges_}, highest_, start_, tops);
    if (!fit) return std::nullopt;
    StudyFit result = checked(*fit);
    if (result.status != Status::converged) return std::nullopt;
    return result;
  }

  StudyFit failed(Status status, std::string why) const {
    StudyFit fit;
    fit.status = status;
    fit.why = std::move(why);
    fit.level = level_;
    return fit;
  }

  /// Adds a coarse grid, so that all parameters are determined from the start.
  void add_grid() {
    constexpr int count = 6;
    Places places{{}};
    for (const StudyAxis& axis : weighted_.axes) {
      Places longer;
      for (const auto& place : places) {
        for (int i = 0; i <= count; ++i) {
          longer.push_back(place);
          longer.back().push_back(axis.lower + (axis.upper - axis.lower) * i / count);
        }
      }
      places = std::move(longer);
    }
    places_ = places;
    looks_.assign(places_.size(), look_);
  }

  /// The distance of two places: the largest share of a range between them.
  double distance(const std::vector<double>& a, const std::vector<double>& b) const {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const StudyAxis& axis = weighted_.axes[i];
      largest = std::max(largest, std::abs(a[i] - b[i]) / (axis.upper - axis.lower));
    }
    return largest;
  }

  /// A top near one of an earlier step is the same top, seen from better parameters, and replaces it. With
  /// both, the programme would have conditions that differ only by rounding.
  void add(const std::vector<double>& place) {
    std::size_t nearest = places_.size();
    double least = same_top;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double away = distance(places_[i], place);
      if (away < 1e-12 || (looks_[i] < look_ && away < least)) {
        nearest = i;
        least = away;
      }
    }
    if (nearest == places_.size()) {
      places_.push_back(place);
      looks_.push_back(look_);
    } else {
      places_[nearest] = place;
      looks_[nearest] = look_;
    }
  }

  /// The lowest level on the set, linearised at these parameters. Empty if n + 1 places do not determine it.
  std::optional<Support> programme(const std::vector<double>& base) {
    VectorOf<double> errors;
    MatrixOf<double> slopes;
    SampledStudy<double>(error_, nodes_at(places_)).errors(base, errors, &slopes);
    // The rounding of form and target in double.
    rounding_ = 2e-15 * std::max(sampled_.target_norm(), errors.cwiseAbs().maxCoeff());
    std::vector<Condition> conditions;
    for (Eigen::Index i = 0; i < errors.size(); ++i) {
      for (const double sign : {1.0, -1.0}) conditions.push_back(condition(errors[i], slopes.row(i), sign));
    }
    const auto reference = first_reference(errors, slopes);
    if (!reference) return std::nullopt;
    Support support{lowest_level(conditions, size_ + 1, *reference, rounding_), {}, {}};
    if (support.lowest.ending != LowestLevel::Ending::found) return std::nullopt;
    for (std::size_t i = 0; i <= size_; ++i) {
      support.places.push_back(support.lowest.reference[i] / 2);
      support.signs.push_back(support.lowest.reference[i] % 2 == 0 ? 1 : -1);
    }
    return support;
  }

  /// n places whose derivatives are independent, and the other place with the largest error. With these signs
  /// a combination of their derivatives is 0: no step lowers all these errors together.
  std::optional<std::vector<std::size_t>> first_reference(const VectorOf<double>& errors,
                                                          const MatrixOf<double>& slopes) const {
    const auto n = static_cast<Eigen::Index>(size_);
    if (errors.size() <= n) return std::nullopt;
    const VectorOf<double> scale = slopes.cwiseAbs().colwise().maxCoeff();
    if (!(scale.minCoeff() > 0)) return std::nullopt;
    const MatrixOf<double> columns = (slopes * scale.cwiseInverse().asDiagonal()).transpose();
    const Eigen::ColPivHouseholderQR<MatrixOf<double>> qr(columns);
    const Eigen::VectorXi order = qr.colsPermutation().indices();
    if (qr.rank() < n) return std::nullopt;
    Eigen::Index extra = order[n];
    for (Eigen::Index i = n; i < order.size(); ++i) {
      if (std::abs(errors[order[i]]) > std::abs(errors[extra])) extra = order[i];
    }
    MatrixOf<double> chosen(n, n);
    for (Eigen::Index i = 0; i < n; ++i) chosen.col(i) = columns.col(order[i]);
    const VectorOf<double> shares = -chosen.colPivHouseholderQr().solve(columns.col(extra));
    std::vector<std::size_t> reference;
    const auto refer = [&](Eigen::Index place, double share) {
      reference.push_back(2 * static_cast<std::size_t>(place) + (share < 0 ? 1 : 0));
    };
    for (Eigen::Index i = 0; i < n; ++i) refer(order[i], shares[i]);
    refer(extra, 1);
    return reference;
  }

  /// Checks that the error of a fit is nowhere larger than its level.
  StudyFit checked(StudyFit fit) {
    if (fit.status != Status::converged) return fit;
    // The place of a top on an edge has only half of the digits, so the level is checked to 8 digits.
    constexpr double held = 1e-8;
    const double largest = look(fit.parameters);
    if (largest <= *fit.level * (1 + held) + rounding_) return fit;
    fit.status = Status::not_converged;
    fit.why = "the error exceeds its level, " + to_text(*fit.level) + ", by " + to_text(largest - *fit.level);
    return fit;
  }

  /// Newton's method in long double: the errors of the support are plus or minus the level.
  StudyFit settled(const std::vector<double>& base) {
    const std::size_t unknowns = size_ + 1;
    Places support;
    for (const std::size_t place : support_.places) support.push_back(places_[place]);
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
        if (std::abs(fit.parameters[j]) * steepest <= rounding_) fit.parameters[j] = 0;
      }
      fit.digits = correct_digits(size);
    }
    for (std::size_t i = 0; i < unknowns; ++i)
      fit.touching.push_back({support[i], support_.signs[i] * *fit.level});
    std::sort(fit.touching.begin(), fit.touching.end(),
              [](const StudyContact& a, const StudyContact& b) { return a.at < b.at; });
    fit.status = fit.digits < least_study_digits ? Status::not_converged : Status::converged;
    fit.why = fit.status == Status::converged ? "" : "Newton's method does not settle in long double";
    if (!is_determined(fit)) {
      fit.status = Status::degenerate;
      fit.why = "the level, " + decimal(*fit.level, 10) + ", is the least, but other parameters have it too";
      return least_of_many().value_or(fit);
    }
    return fit;
  }

  /// Whether no other parameters have this level.
  bool is_determined(const StudyFit& fit) const {
    VectorOf<double> errors;
    MatrixOf<double> slopes;
    SampledStudy<double>(error_, nodes_at(places_)).errors(fit.parameters, errors, &slopes);
    std::vector<std::size_t> support(size_ + 1);
    std::vector<Eigen::Index> touching;
    for (std::size_t place = 0; place < places_.size(); ++place) {
      const auto row = static_cast<Eigen::Index>(place);
      const auto at = std::find(support_.places.begin(), support_.places.end(), place);
      const bool is_support = at != support_.places.end();
      if (!is_support && std::abs(errors[row]) < *fit.level * (1 - same_level) - rounding_) continue;
      if (is_support) support[static_cast<std::size_t>(at - support_.places.begin())] = touching.size();
      if (errors[row] < 0) slopes.row(row) *= -1;
      touching.push_back(row);
    }
    const auto& multipliers = support_.lowest.multipliers;
    return are_determined(slopes(touching, Eigen::all), support, std::span(multipliers).first(size_ + 1));
  }

  const StudyError& error_;
  const ReadStudy& study_;
  const SampledStudy<double>& sampled_;  ///< detects poles
  const std::vector<double> start_;
  ReadStudy weighted_;
  std::vector<double> parameters_;
  std::size_t size_;
  std::vector<std::vector<StudyEdge>> edges_;
  TopPolish polish_;
  Places places_ = {};
  std::vector<int> looks_ = {};  ///< the number of the look that found each place
  int look_ = 0;
  Support support_ = {};
  double level_ = 0, rounding_ = 0;
  double promised_ = 0;  ///< the highest level of a programme: of a linear form none is lower
  LevelSupport highest_ = {};
};

}  // namespace

StudyFit solve_minimax_surface(const ReadStudy& study, const std::vector<Held>& starts,
                               const Checkpoint& checkpoint) {
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, all_edges_of(study), starts, checkpoint);

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
  for (const StudyCandidate& candidate : lowest_basins(searched)) {
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
