#include "fit/steps/quadratic_programme.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// The rounding of a condition, relative to the sizes of its terms.
constexpr double rounding_of_condition = 1e-13;
/// The active conditions determine another one if they leave less of its slope than this share.
constexpr double across = 1e-10;
/// A share of a multiplier that is the rounding of 0.
constexpr double no_share = 1e-12;

class DualMethod {
 public:
  /// In units in which the Hessian's diagonal is 1.
  DualMethod(const Matrix& hessian, const Vector& gradient, std::span<const Condition> conditions)
      : conditions_(conditions),
        units_(hessian.diagonal().cwiseSqrt().cwiseInverse()),
        factors_(units_.asDiagonal() * hessian * units_.asDiagonal()),
        step_(-factors_.solve(Vector(units_.cwiseProduct(gradient)))),
        slopes_(units_.size(), static_cast<Eigen::Index>(conditions.size())) {
    for (Eigen::Index k = 0; k < slopes_.cols(); ++k) {
      for (Eigen::Index i = 0; i < slopes_.rows(); ++i)
        slopes_(i, k) =
            conditions[static_cast<std::size_t>(k)].slope[static_cast<std::size_t>(i)] * units_[i];
    }
  }

  std::optional<QuadraticAnswer> solve() {
    // Each pass meets a condition. A cycle comes from rounding: then there is no answer.
    for (std::size_t pass = 0; pass < 10 * (conditions_.size() + 1); ++pass) {
      const auto worst = most_violated();
      if (!worst) return QuadraticAnswer{units_.cwiseProduct(step_), active_};
      if (!meet(*worst)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  auto slope(std::size_t condition) const { return slopes_.col(static_cast<Eigen::Index>(condition)); }

  double excess(std::size_t condition) const {
    return slope(condition).dot(step_) - conditions_[condition].bound;
  }

  bool is_active(std::size_t condition) const {
    return std::ranges::any_of(active_, [&](const ActiveCondition& a) { return a.condition == condition; });
  }

  /// Equations come first, so that they are never dropped.
  std::optional<std::size_t> most_violated() const {
    std::optional<std::size_t> worst;
    double most = 0;
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
      if (is_active(i)) continue;
      if (conditions_[i].is_equation) return i;
      const double over = excess(i);
      if (!(over > most)) continue;
      const double size = std::abs(conditions_[i].bound) + slope(i).cwiseAbs().dot(step_.cwiseAbs());
      if (!(over > rounding_of_condition * size)) continue;
      most = over;
      worst = i;
    }
    return worst;
  }

  /// Moves the step until a condition is met. False if it contradicts those that are met already.
  bool meet(std::size_t entering) {
    const double sign = conditions_[entering].is_equation && excess(entering) < 0 ? -1 : 1;
    const Vector normal = sign * slope(entering);
    double multiplier = 0;
    for (;;) {
      const auto count = static_cast<Eigen::Index>(active_.size());
      Matrix normals(normal.size(), count);
      for (Eigen::Index i = 0; i < count; ++i)
        normals.col(i) = slope(active_[static_cast<std::size_t>(i)].condition);
      // In coordinates where the Hessian is 1. The products of the normals would have the square of their
      // condition number.
      const Matrix met = factors_.matrixL().solve(normals);
      const Vector direct = factors_.matrixL().solve(normal);
      const Vector shares = count == 0 ? Vector() : solution(pivoted_qr(met), direct);
      const Vector rest = count == 0 ? direct : Vector(direct - met * shares);
      const Vector direction = factors_.matrixU().solve(rest);
      const double gain = rest.squaredNorm();
      const bool is_across = !(rest.norm() > across * direct.norm()) || count == normal.size();

      double length = is_across ? HUGE_VAL : std::max(0.0, sign * excess(entering)) / gain;
      std::optional<std::size_t> leaving;
      for (std::size_t i = 0; i < active_.size(); ++i) {
        const double share = shares[static_cast<Eigen::Index>(i)];
        if (conditions_[active_[i].condition].is_equation || !(share > no_share)) continue;
        if (active_[i].multiplier / share < length) {
          length = std::max(0.0, active_[i].multiplier) / share;
          leaving = i;
        }
      }
      if (length == HUGE_VAL) return is_met_anyway(entering);
      if (!is_across) step_ -= length * direction;
      for (std::size_t i = 0; i < active_.size(); ++i)
        active_[i].multiplier -= length * shares[static_cast<Eigen::Index>(i)];
      multiplier += length;
      if (!leaving) {
        active_.push_back({entering, sign * multiplier});
        return true;
      }
      active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(*leaving));
    }
  }

  /// Two equations may be equivalent.
  bool is_met_anyway(std::size_t condition) {
    const double size =
        std::abs(conditions_[condition].bound) + slope(condition).cwiseAbs().dot(step_.cwiseAbs());
    if (!conditions_[condition].is_equation || std::abs(excess(condition)) > 1e-9 * size) return false;
    active_.push_back({condition, 0});
    return true;
  }

  std::span<const Condition> conditions_;
  Vector units_;
  Eigen::LLT<Matrix> factors_;
  Vector step_;
  Matrix slopes_;  ///< of a condition in each column
  std::vector<ActiveCondition> active_ = {};
};

}  // namespace

std::optional<QuadraticAnswer> least_step(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                          std::span<const Condition> conditions) {
  return DualMethod(hessian, gradient, conditions).solve();
}

bool has_way_on(std::span<const Condition> conditions, Eigen::Index unknowns) {
  constexpr double rounding = 1e-6;
  for (Eigen::Index i = 0; i < 2 * unknowns; ++i) {
    const Vector towards = Vector::Unit(unknowns, i / 2) * (i % 2 == 0 ? 1 : -1);
    const auto nearest = least_step(Matrix::Identity(unknowns, unknowns), -towards, conditions);
    if (!nearest || nearest->step.norm() > rounding) return true;
  }
  return false;
}

}  // namespace shadefit
