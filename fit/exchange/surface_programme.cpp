#include "fit/exchange/surface_programme.hpp"

#include <algorithm>
#include <cmath>

#include "fit/study/even_grid.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {

StudyNodes nodes_at(const Places& places) {
  StudyNodes nodes;
  nodes.coordinates.resize(places.front().size());
  for (const auto& place : places) {
    for (std::size_t i = 0; i < place.size(); ++i) nodes.coordinates[i].push_back(place[i]);
  }
  nodes.weights.assign(places.size(), 1.0L / static_cast<long double>(places.size()));
  return nodes;
}

TopPlaces::TopPlaces(const ReadStudy& study) : places_(even_grid(study.axes, 6)) {
  for (const StudyAxis& axis : study.axes) widths_.push_back(axis.upper - axis.lower);
  looks_.assign(places_.size(), look_);
}

/// The largest share of a range between two places.
double TopPlaces::distance(const std::vector<double>& a, const std::vector<double>& b) const {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]) / widths_[i]);
  return largest;
}

void TopPlaces::add(const std::vector<double>& place) {
  constexpr double same_top = 0.01;  // a top closer than this share of the range is the same top
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

namespace {

/// error <= level, and -error <= level, for a step of the parameters from here.
Condition condition(double error, const VectorOf<double>& slope, double sign) {
  Condition result{{}, -sign * error};
  for (Eigen::Index i = 0; i < slope.size(); ++i) result.slope[static_cast<std::size_t>(i)] = sign * slope[i];
  result.slope[static_cast<std::size_t>(slope.size())] = -1;
  return result;
}

/// n places whose derivatives are independent, and the other place with the largest error. With these signs
/// a combination of their derivatives is 0: no step lowers all these errors together.
std::optional<std::vector<std::size_t>> first_reference(const VectorOf<double>& errors,
                                                        const MatrixOf<double>& slopes) {
  const Eigen::Index n = slopes.cols();
  if (errors.size() <= n) return std::nullopt;
  const VectorOf<double> scale = slopes.cwiseAbs().colwise().maxCoeff();
  if (!(scale.minCoeff() > 0)) return std::nullopt;
  const MatrixOf<double> columns = (slopes * scale.cwiseInverse().asDiagonal()).transpose();
  const PivotedQr qr = pivoted_qr(columns);
  const Eigen::VectorXi order = qr.colsPermutation().indices();
  if (qr.rank() < n) return std::nullopt;
  Eigen::Index extra = order[n];
  for (Eigen::Index i = n; i < order.size(); ++i) {
    if (std::abs(errors[order[i]]) > std::abs(errors[extra])) extra = order[i];
  }
  MatrixOf<double> chosen(n, n);
  for (Eigen::Index i = 0; i < n; ++i) chosen.col(i) = columns.col(order[i]);
  const VectorOf<double> shares = -solution(pivoted_qr(chosen), columns.col(extra));
  std::vector<std::size_t> reference;
  const auto refer = [&](Eigen::Index place, double share) {
    reference.push_back(2 * static_cast<std::size_t>(place) + (share < 0 ? 1 : 0));
  };
  for (Eigen::Index i = 0; i < n; ++i) refer(order[i], shares[i]);
  refer(extra, 1);
  return reference;
}

}  // namespace

std::optional<LevelStep> level_step(const StudyError& error, const Places& places,
                                    const std::vector<double>& parameters, double target_norm) {
  VectorOf<double> errors;
  MatrixOf<double> slopes;
  SampledStudy<double>(error, nodes_at(places)).errors(parameters, errors, &slopes);
  return level_step(errors, slopes, 2e-15 * std::max(target_norm, errors.cwiseAbs().maxCoeff()));
}

std::optional<LevelStep> level_step(const VectorOf<double>& errors, const MatrixOf<double>& slopes,
                                    double rounding) {
  std::vector<Condition> conditions;
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    for (const double sign : {1.0, -1.0}) conditions.push_back(condition(errors[i], slopes.row(i), sign));
  }
  const auto reference = first_reference(errors, slopes);
  if (!reference) return std::nullopt;
  const auto unknowns = static_cast<std::size_t>(slopes.cols()) + 1;
  LevelStep step{lowest_level(conditions, unknowns, *reference, rounding), {}, {}, rounding};
  if (step.lowest.ending != LowestLevel::Ending::found) return std::nullopt;
  for (std::size_t i = 0; i < unknowns; ++i) {
    step.places.push_back(step.lowest.reference[i] / 2);
    step.signs.push_back(step.lowest.reference[i] % 2 == 0 ? 1 : -1);
  }
  return step;
}

}  // namespace shadefit
