#include "fit/exchange/linear_newton.hpp"

#include <algorithm>
#include <cmath>

#include "fit/steps/digits.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// A multiplier below this is the rounding of 0. Those of the level sum to 1.
constexpr double no_share = 1e-9;

}  // namespace

void LinearNewton::touch(const Cut& cut, double multiplier, double same_top) {
  if (!(multiplier > no_share)) return;
  LinearCurve& curve = cuts_.curves[cut.of.curve];
  Touching entering{cut.of, multiplier, curve.touch == Touch::exact};
  const auto& axes = cuts_.study.axes;
  if (!entering.is_held && cut.of.part == 0 && same_top > near_top) {
    constexpr double same_hill = 0.02;  // of the range
    const Place top = top_near(curve.parts, cut.of.place, cuts_.parameters, cuts_.edges);
    if (are_near(top, cut.of.place, axes, same_hill)) entering.of.place = top;
  }
  for (Touching& other : touching) {
    if (other.of.curve != cut.of.curve || other.of.part != cut.of.part ||
        !are_near(other.of.place, entering.of.place, axes, same_top))
      continue;
    if (!other.is_held) other.multiplier += multiplier;
    return;
  }
  touching.push_back(entering);
}

/// The axes along which the place of a condition moves with the parameters. A curve that is level there has
/// no top.
std::vector<Eigen::Index> LinearNewton::moving_axes(const Touching& t,
                                                    const std::vector<CurvePart>& parts) const {
  if (t.is_held || t.of.part != 0) return {};
  constexpr double is_level = 1e-5;  // of the curve's unit over the range
  std::vector<Eigen::Index> axes = free_axes(t.of.place, cuts_.edges);
  std::erase_if(axes, [&](Eigen::Index axis) {
    const double bend = curvature_along(parts, cuts_.edges.size(), {axis})(0, 0), width = cuts_.width(axis);
    return !(std::abs(bend) * width * width > is_level * std::abs(t.of.unit));
  });
  return axes;
}

LinearNewton::Moving LinearNewton::moving() {
  Moving result;
  for (const Touching& t : touching) {
    result.axes.push_back(moving_axes(t, cuts_.parts(t.of)));
    result.count += std::ssize(result.axes.back());
  }
  return result;
}

Wide LinearNewton::step(const Matrix& hessian, const Wide& gradient, bool has_level) {
  const Moving places = moving();
  const Eigen::Index n = cuts_.size(), first = n + (has_level ? 1 : 0);
  Eigen::Index place_row = first + std::ssize(touching);
  const Eigen::Index size = place_row + places.count;
  Matrix matrix = Matrix::Zero(size, size);
  matrix.topLeftCorner(n, n) = hessian;
  Wide lack = Wide::Zero(size);
  lack.head(n) = -gradient;
  if (has_level) lack[n] = -1;
  for (Eigen::Index row = first; const Touching& t : touching) {
    const std::vector<CurvePart> parts = cuts_.parts(t.of);
    const auto unit = static_cast<long double>(t.of.unit);
    const double share = cuts_.share_of(t.of);
    const Wide slope = cuts_.steps.transpose().cast<long double>() * parts[t.of.part].slope / unit;
    matrix.col(row).head(n) = slope.cast<double>();
    matrix.row(row).head(n) = slope.cast<double>().transpose();
    lack.head(n) -= static_cast<long double>(t.multiplier) * slope;
    lack[row] = static_cast<long double>(share * cuts_.level) - parts[t.of.part].value / unit;
    if (has_level) {
      matrix(n, row) = matrix(row, n) = -share;
      lack[n] += static_cast<long double>(share * t.multiplier);
    }
    const std::vector<Eigen::Index>& axes = places.axes[static_cast<std::size_t>(row - first)];
    const Matrix bend = curvature_along(parts, cuts_.edges.size(), axes);
    for (Eigen::Index i = 0; i < bend.cols(); ++i) {
      const Eigen::Index axis = axes[static_cast<std::size_t>(i)];
      const CurvePart& along = parts[1 + static_cast<std::size_t>(axis)];
      const double width = cuts_.width(axis);
      const Vector across = cuts_.along(along.slope) * width / t.of.unit;
      matrix.col(place_row + i).head(n) = t.multiplier * across;
      matrix.row(place_row + i).head(n) = across.transpose();
      matrix(row, place_row + i) = static_cast<double>(along.value) * width / t.of.unit;
      lack[place_row + i] = -along.value * static_cast<long double>(width) / unit;
      for (Eigen::Index j = 0; j < bend.cols(); ++j)
        matrix(place_row + i, place_row + j) =
            bend(i, j) * width * cuts_.width(axes[static_cast<std::size_t>(j)]) / t.of.unit;
    }
    place_row += bend.cols();
    ++row;
  }
  if (!matrix.allFinite()) return Wide::Constant(cuts_.parameters.size(), NAN);
  constexpr double rounding = 1e-12;
  return take(shortest_solution(matrix, lack.cast<double>(), rounding), places, has_level);
}

Wide LinearNewton::take(Vector step, const Moving& places, bool has_level) {
  const Eigen::Index n = cuts_.size(), first = n + (has_level ? 1 : 0);
  constexpr double most_move = 0.02;  // of the range: a place stays on its hill
  const double move = places.count > 0 ? step.tail(places.count).cwiseAbs().maxCoeff() : 0;
  if (move > most_move) step *= most_move / move;
  const Wide moved = cuts_.steps.cast<long double>() * step.head(n).cast<long double>();
  cuts_.parameters += moved;
  if (has_level) cuts_.level += step[n];
  Eigen::Index next = first + std::ssize(touching);
  for (std::size_t i = 0; i < touching.size(); ++i) {
    Touching& t = touching[i];
    for (const Eigen::Index axis : places.axes[i]) {
      const auto& edges = cuts_.edges[static_cast<std::size_t>(axis)];
      double& x = t.of.place[static_cast<std::size_t>(axis)];
      x = std::clamp(x + step[next++] * cuts_.width(axis), edges.front().at, edges.back().at);
    }
    t.multiplier += step[first + static_cast<Eigen::Index>(i)];
  }
  return moved;
}

/// The largest step relative to its parameter. One that is nearly 0 counts as what moves the error by a
/// thousandth of the level.
long double LinearNewton::relative(const Wide& step) const {
  const VectorOf<double> least = 1e-3 * cuts_.level * cuts_.steps.cwiseAbs().rowwise().maxCoeff();
  return step.cwiseQuotient(cuts_.parameters.cwiseAbs().cwiseMax(least.cast<long double>()))
      .cwiseAbs()
      .maxCoeff();
}

bool LinearNewton::settle_level() {
  constexpr int most_passes = 40;
  // A curvature that holds the parameters where the places of the level leave them open.
  constexpr double least_bend = 1e-6;
  const Matrix held = least_bend * Matrix::Identity(cuts_.size(), cuts_.size());
  const Wide no_gradient = Wide::Zero(cuts_.size());
  long double size = HUGE_VALL;
  for (int pass = 0; pass < most_passes; ++pass) {
    const long double before = size;
    size = relative(step(held, no_gradient, true));
    if (!std::isfinite(size)) break;
    if (size < 1e-17L || (size < 1e-10L && !(size < before / 2))) break;
  }
  // Newton's method settles on the errors as they are rounded.
  const Wide by_rounding = cuts_.rounding() * cuts_.steps.rowwise().norm().cast<long double>();
  cuts_.fit.digits = correct_digits(std::max(size, relative(by_rounding)));
  return cuts_.fit.digits >= least_study_digits && has_signs();
}

bool LinearNewton::has_signs() const {
  constexpr double rounding = 1e-7;  // of the largest
  double largest = 0, least = 0;
  for (const Touching& t : touching) {
    largest = std::max(largest, std::abs(t.multiplier));
    if (!t.is_held) least = std::min(least, t.multiplier);
  }
  return least >= -rounding * largest;
}

bool LinearNewton::hold_level() {
  std::vector<Touching> held = touching;
  for (const Touching& t : touching)
    if (!t.is_held) hold_slopes(t, held);
  touching.clear();
  Matrix chosen(cuts_.size(), 0);
  for (const Touching& t : held) {
    const Vector slope = cuts_.along(cuts_.parts(t.of)[t.of.part].slope) / t.of.unit;
    Matrix longer(chosen.rows(), chosen.cols() + 1);
    longer << chosen, slope.normalized();
    constexpr double rounding = 1e-8;  // the places have half of the digits
    if (!slope.allFinite() || pivoted_qr(longer, rounding).rank() < longer.cols()) continue;
    chosen = longer;
    touching.push_back({t.of, 0, true});
  }
  return chosen.cols() == cuts_.size();
}

void LinearNewton::hold_slopes(const Touching& t, std::vector<Touching>& held) {
  const std::vector<Eigen::Index> free = free_axes(t.of.place, cuts_.edges);
  for (std::size_t axis = 0; axis < cuts_.edges.size(); ++axis) {
    const double lower = cuts_.edges[axis].front().at, upper = cuts_.edges[axis].back().at;
    const bool is_lower = t.of.place[axis] == lower, is_upper = t.of.place[axis] == upper;
    Bounded slope{t.of.curve, t.of.place, 1 + axis};
    const auto size = [&] { return cuts_.along(cuts_.parts(slope)[slope.part].slope).norm(); };
    // At an end with a root the slope is infinite. Beside it the other terms are a rounding.
    constexpr double beside = 1e-13;  // of the range
    if (!std::isfinite(size())) slope.place[axis] += (is_lower ? beside : -beside) * (upper - lower);
    slope.unit = is_upper ? -size() : size();
    if (slope.unit == 0 || !std::isfinite(slope.unit)) continue;
    if (is_lower || is_upper) {
      cuts_.cuts.push_back({slope, cuts_.condition(slope)});
    } else if (std::find(free.begin(), free.end(), static_cast<Eigen::Index>(axis)) != free.end()) {
      held.push_back({slope, 0, true});
    }
  }
}

}  // namespace shadefit
