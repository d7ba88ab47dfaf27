#include "fit/exchange/curved_level.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "fit/squares/level_polish.hpp"
#include "fit/squares/row_descent.hpp"

namespace shadefit {
namespace {

/// The error of a study, and how its tops are found.
struct CurvedSurface {
  const ReadStudy& study;
  StudyError error;
  ErrorTops top;

  CurvedSurface(const ReadStudy& of, const Edges& edges) : study(of), error(of), top(of, edges) {}

  Places tops(const std::vector<double>& parameters) {
    Places places;
    for (const StudyExtremum& found : top.all(parameters)) places.push_back(found.at);
    return places;
  }
};

/// Places that hold the level, with the signs of their errors and their multipliers.
struct HeldTops {
  Places places;
  std::vector<LevelRow> rows;  ///< row i is place i
};

/// The slopes of the errors at tops, and how they change with the parameters while the tops move along: by
/// central differences, which are exact enough for Newton's method.
class MovingTops {
 public:
  MovingTops(CurvedSurface& surface, Places tops) : surface_(&surface), tops_(std::move(tops)) {}

  const Places& at(std::span<const double> parameters) {
    const std::vector<double> there(parameters.begin(), parameters.end());
    for (auto& place : tops_) place = surface_->top.near(place, there);
    return tops_;
  }

  template <class T>
  void errors(std::span<const T> parameters, VectorOf<T>& errors, MatrixOf<T>& slopes) {
    const std::vector<double> in_double(parameters.begin(), parameters.end());
    SampledStudy<T>(surface_->error, nodes_at(at(in_double))).errors(parameters, errors, &slopes);
  }

  MatrixOf<double> curvature(std::span<const double> parameters, std::span<const double> shares,
                             const MatrixOf<double>& steps) {
    constexpr double h = 1e-6;  // a step of 1 changes the errors by about the level
    const Places before = tops_;
    MatrixOf<double> result(steps.cols(), steps.cols());
    for (Eigen::Index k = 0; k < steps.cols(); ++k) {
      VectorOf<double> change = VectorOf<double>::Zero(steps.rows());
      for (const double side : {h, -h}) {
        const std::vector<double> moved =
            moved_by<double>(side * steps.col(k), {parameters.begin(), parameters.end()});
        VectorOf<double> heights;
        MatrixOf<double> slopes;
        errors<double>(moved, heights, slopes);
        for (std::size_t i = 0; i < shares.size(); ++i)
          change += shares[i] * slopes.row(static_cast<Eigen::Index>(i)).transpose() / (2 * side);
        tops_ = before;
      }
      result.col(k) = steps.transpose() * change;
    }
    return (result + result.transpose()) / 2;
  }

 private:
  CurvedSurface* surface_;
  Places tops_;
};

LevelPoints points_of_tops(CurvedSurface& surface, const Places& tops) {
  const auto moving = std::make_shared<MovingTops>(surface, tops);
  return {[moving](std::span<const double> parameters, VectorOf<double>& errors, MatrixOf<double>& slopes) {
            moving->errors(parameters, errors, slopes);
          },
          [moving](std::span<const long double> parameters, VectorOf<long double>& errors,
                   MatrixOf<long double>& slopes) { moving->errors(parameters, errors, slopes); },
          [moving](std::span<const double> parameters, std::span<const double> shares,
                   const MatrixOf<double>& steps) { return moving->curvature(parameters, shares, steps); }};
}

double largest_at(const CurvedSurface& surface, const Places& places, const std::vector<double>& parameters) {
  VectorOf<double> errors;
  SampledStudy<double>(surface.error, nodes_at(places)).errors(parameters, errors, nullptr);
  return errors.allFinite() ? errors.cwiseAbs().maxCoeff() : HUGE_VAL;
}

/// The tops on which the places at a level lie: several places may stand for one that moves.
HeldTops held_by(CurvedSurface& surface, const PolishedLevel& level, const Places& places) {
  constexpr double same_top = 0.05;  // of the range
  HeldTops held;
  for (const LevelRow& row : level.rows) {
    const std::vector<double> top = surface.top.near(places[row.row], level.parameters);
    const auto same = std::find_if(held.rows.begin(), held.rows.end(), [&](const LevelRow& other) {
      return other.sign == row.sign && are_near(held.places[other.row], top, surface.study.axes, same_top);
    });
    if (same != held.rows.end()) {
      same->multiplier += row.multiplier;
    } else {
      held.rows.push_back({held.places.size(), row.sign, row.multiplier});
      held.places.push_back(top);
    }
  }
  return held;
}

/// Newton's method on the tops of a level of places. Empty if a top is above the new level.
std::optional<StudyFit> settled_on_tops(CurvedSurface& surface, const PolishedLevel& level,
                                        const Places& places, const MatrixOf<double>& steps) {
  constexpr double same_level = 1e-8;  // the place of a top has half of the digits
  const HeldTops held = held_by(surface, level, places);
  const auto found =
      polish_level(points_of_tops(surface, held.places), steps, level.parameters, level.level, held.rows);
  if (!found || !(found->bend > no_bend)) return std::nullopt;
  const double largest = largest_at(surface, surface.tops(found->parameters), found->parameters);
  if (!(largest <= found->level * (1 + same_level)) || found->digits < least_study_digits)
    return std::nullopt;
  StudyFit fit;
  fit.status = Status::converged;
  fit.parameters = found->parameters;
  fit.digits = found->digits;
  fit.level = found->level;
  for (const LevelRow& row : found->rows)
    fit.touching.push_back({surface.top.near(held.places[row.row], fit.parameters), row.sign * *fit.level});
  std::ranges::sort(fit.touching, {}, &StudyContact::at);
  return fit;
}

}  // namespace

std::optional<StudyFit> curved_level(const ReadStudy& study, const Edges& edges, Places places,
                                     const std::vector<double>& start, const Checkpoint& checkpoint) {
  constexpr int most_rounds = 20;
  constexpr double near = 0.01;  // Newton's method starts when no top is higher by this share
  CurvedSurface surface(study, edges);
  std::vector<double> parameters = start;
  // The tops of the last two results: those of more lie so close together that they differ by rounding.
  const std::size_t first = places.size();
  Places before;
  for (int round = 0; round < most_rounds; ++round) {
    const StudyNodes nodes = nodes_at(places);
    const SampledStudy<double> sampled(surface.error, nodes);
    const RowStage stage{std::vector<double>(places.size(), HUGE_VAL), {}};
    const DescentEnd end = RowDescent(surface.error, nodes, sampled)(parameters, stage, checkpoint);
    if (!end.answer) return std::nullopt;
    parameters = end.answer->parameters;
    const Places tops = surface.tops(parameters);
    if (largest_at(surface, tops, parameters) <= end.answer->level * (1 + near)) {
      const MatrixOf<double> steps = row_directions(end.at.slopes, end.answer->level);
      if (auto fit = settled_on_tops(surface, *end.answer, places, steps)) return fit;
    }
    places.resize(first);
    places.insert(places.end(), before.begin(), before.end());
    places.insert(places.end(), tops.begin(), tops.end());
    before = tops;
  }
  return std::nullopt;
}

}  // namespace shadefit
