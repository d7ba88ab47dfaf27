#include "fit/study/row_statistics.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/steps/levenberg.hpp"
#include "fit/steps/newton.hpp"
#include "fit/study/projection.hpp"
#include "fit/support/decompositions.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// Whether weight * sigma is 1 in every row.
bool is_inverse_sigma(const ReadStudy& study, const StudyNodes& nodes) {
  if (study.rows->sigma.empty() || study.error != Error::absolute) return false;
  const Symbolic product = study.weight * Symbolic::variable("sigma");
  constexpr double rounding = 1e-14;
  const std::vector<double> values = values_at_nodes(study, product, nodes);
  return std::ranges::all_of(values, [](double value) { return std::abs(value - 1) <= rounding; });
}

/// inverse(J^T J), by a QR decomposition of J with columns of length 1.
Matrix inverse_of_normal_matrix(const StudyError& error, const StudyNodes& nodes,
                                const std::vector<double>& parameters) {
  const SampledStudy<long double> sampled(error, nodes);
  const MatrixOf<long double> slopes =
      sampled.reduced(std::vector<long double>(parameters.begin(), parameters.end())).slopes;
  const VectorOf<long double> shrink = slopes.colwise().norm().cwiseInverse().transpose();
  const Eigen::HouseholderQR<MatrixOf<long double>> qr(slopes * shrink.asDiagonal());
  const auto n = slopes.cols();
  const MatrixOf<long double> inverse =
      qr.matrixQR().topRows(n).triangularView<Eigen::Upper>().solve(MatrixOf<long double>::Identity(n, n));
  return (shrink.asDiagonal() * (inverse * inverse.transpose()) * shrink.asDiagonal()).cast<double>();
}

/// The sum of squares with one parameter held, over the parameters that do not enter linearly. Its unknowns
/// are their distances from the optimum in standard errors, so all are of the size of 1.
class HeldSquare {
 public:
  HeldSquare(const StudyError& error, const SampledStudy<double>& sampled, const std::vector<double>& optimum,
             const std::vector<double>& standard_errors, std::size_t held)
      : sampled_(sampled),
        projection_(error, sampled, held),
        optimum_(optimum),
        units_(standard_errors),
        held_(held) {}

  const std::vector<std::size_t>& unknowns() const { return projection_.nonlinear(); }

  /// Moves unknowns to the lowest place. The square is flat at its minimum: a millionth of a standard error
  /// changes it by 1e-12.
  void minimise(Vector& q) const {
    const auto evaluate = [this](const double* at, double* r, double* columns) { (*this)(at, r, columns); };
    descend({projection_.residual_count(), evaluate}, {.last_step = 1e-6, .most_steps = 100}, q);
  }

  /// Holds the parameter at a distance from its optimum, in standard errors.
  void hold(double distance) { projection_.hold(optimum_[held_] + units_[held_] * distance); }

  void operator()(const double* q, double* residuals, double* jacobian) const {
    Vector place(projection_.unknown_count());
    for (Eigen::Index i = 0; i < place.size(); ++i) {
      const std::size_t unknown = unknowns()[static_cast<std::size_t>(i)];
      place[i] = optimum_[unknown] + units_[unknown] * q[i];
    }
    projection_(place.data(), residuals, jacobian);
    if (jacobian == nullptr) return;
    Eigen::Map<Matrix> columns(jacobian, projection_.residual_count(), place.size());
    for (Eigen::Index i = 0; i < place.size(); ++i)
      columns.col(i) *= units_[unknowns()[static_cast<std::size_t>(i)]];
  }

  /// The sum of squares at unknowns; infinite where the form has no value, and beyond a pole.
  double square(const Vector& q) const {
    Vector residuals(projection_.residual_count());
    (*this)(q.data(), residuals.data(), nullptr);
    const double square = residuals.squaredNorm() * static_cast<double>(sampled_.size());
    return std::isfinite(square) && !sampled_.has_pole(projection_.parameters()) ? square : HUGE_VAL;
  }

 private:
  const SampledStudy<double>& sampled_;
  Projection projection_;
  const std::vector<double>&optimum_, &units_;
  std::size_t held_;
};

/// The profile of one parameter.
class Profile {
 public:
  /// `tangent`: how the unknowns change with the parameter at the optimum, in standard errors.
  Profile(HeldSquare problem, Vector tangent, double growth)
      : problem_(std::move(problem)), tangent_(std::move(tangent)), growth_(growth) {
    problem_.hold(0);
    least_ = problem_.square(Vector::Zero(tangent_.size()));
  }

  /// The distance in standard errors where the sum of squares has grown by `growth`, in a direction 1 or -1.
  /// Empty if it has not at the furthest distance.
  std::optional<double> end(double direction) {
    constexpr double furthest = 1000;
    last_ = Vector::Zero(tangent_.size());
    const auto excess = [&](double distance) { return grown(direction * distance) - 1; };
    double inside = 0, outside = 1, excess_inside = -1, excess_outside = excess(outside);
    while (excess_outside <= 0) {
      if (outside >= furthest) return std::nullopt;
      inside = outside;
      excess_inside = excess_outside;
      outside = std::min(outside * 1.5, furthest);
      excess_outside = excess(outside);
    }
    if (excess_inside == 0) return direction * inside;
    // 30 bits of the distance, because an end is shown with six digits.
    return direction * root_between(excess, inside, outside, excess_inside, excess_outside, 30);
  }

 private:
  /// sqrt(growth of the sum of squares / `growth`): near the optimum the distance itself. 2 if the form has
  /// no value, so that such parameters are outside.
  double grown(double distance) {
    problem_.hold(distance);
    double least = HUGE_VAL;
    Vector best = last_;
    // The neighbour's answer is near; the tangent is better near the optimum.
    for (Vector q : {last_, Vector(distance * tangent_)}) {
      if (q.size() > 0 && std::isfinite(problem_.square(q))) problem_.minimise(q);
      const double square = problem_.square(q);
      if (square < least) {
        least = square;
        best = q;
      }
      if (q.size() == 0) break;
    }
    last_ = best;
    return std::isfinite(least) ? std::sqrt(std::max(0.0, least - least_) / growth_) : 2;
  }

  HeldSquare problem_;
  Vector tangent_, last_;
  double growth_, least_ = 0;
};

/// How unknowns follow a parameter: the regression of their errors on its error.
Vector tangent_of(const RowStatistics& statistics, const std::vector<std::size_t>& unknowns,
                  std::size_t held) {
  const std::vector<double>& errors = statistics.standard_errors;
  Vector tangent(static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    tangent[static_cast<Eigen::Index>(i)] =
        statistics.covariance[unknowns[i]][held] / (errors[unknowns[i]] * errors[held]);
  return tangent;
}

/// An end of a profile by Newton's method on its equations, for rows of which each pass takes long: the sum
/// of squares has grown from `least` by `growth`, and its derivatives by the other parameters are 0. Empty if
/// that does not settle near the standard error. Source: Venzon, Moolgavkar 1988, "A Method for Computing
/// Profile-Likelihood-Based Confidence Intervals", Applied Statistics 37.
std::optional<double> end_by_newton(const SampledStudy<double>& sampled, const RowStatistics& statistics,
                                    const std::vector<double>& optimum, double least, double growth,
                                    std::size_t parameter, double direction) {
  constexpr int most_steps = 8;
  constexpr double last_step = 1e-6, nearest = 0.5, furthest = 2;  // in standard errors
  const auto count = static_cast<Eigen::Index>(optimum.size()), held = static_cast<Eigen::Index>(parameter);
  const Vector units = vector_of(statistics.standard_errors);
  Vector at(count);
  for (Eigen::Index i = 0; i < count; ++i)
    at[i] =
        direction * statistics.covariance[parameter][static_cast<std::size_t>(i)] / (units[i] * units[held]);
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<double> place = moved_by<double>(at.cwiseProduct(units), optimum);
    const auto sums = sampled.derivatives(place);
    const double share = static_cast<double>(sampled.size()) / growth;
    Matrix equations = share * (units.asDiagonal() * sums.hessian * units.asDiagonal());
    Vector excess = share * units.cwiseProduct(sums.gradient);
    Matrix others = equations;
    others.row(held).setZero();
    others.col(held) = Vector::Unit(count, held);
    equations.row(held) = 2 * excess.transpose();
    excess[held] = share * sums.square - least / growth - 1;
    const Vector moved = shortest_solution(equations, excess);
    if (!moved.allFinite() || !is_minimum(others) || sampled.has_pole(place)) return std::nullopt;
    at -= moved;
    if (moved.cwiseAbs().maxCoeff() > last_step) continue;
    const double distance = direction * at[held];
    return nearest < distance && distance < furthest ? std::optional(at[held]) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RowStatistics> row_statistics(const ReadStudy& study, const StudyError& error,
                                            const SampledStudy<double>& sampled,
                                            const std::vector<double>& parameters) {
  const std::size_t rows = sampled.size(), count = parameters.size();
  if (rows == count) return std::nullopt;
  const StudyNodes nodes = nodes_of(study, {}, 1);
  RowStatistics result{rows - count, is_inverse_sigma(study, nodes), 0, {}, {}, {}};
  const double square = sampled.square(parameters);
  const double rounding = 1e-24 * sampled.target_norm() * sampled.target_norm();
  if (!result.is_absolute && square <= rounding) return std::nullopt;
  result.variance = square * static_cast<double>(rows) / static_cast<double>(result.freedom);

  const double growth = result.is_absolute ? 1 : result.variance;
  const Matrix covariance = growth * inverse_of_normal_matrix(error, nodes, parameters);
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    result.covariance.emplace_back(covariance.row(i).begin(), covariance.row(i).end());
    result.standard_errors.push_back(std::sqrt(covariance(i, i)));
  }
  constexpr double resolution = 1e-8;  // of the search for an end: a smaller one is 0
  for (std::size_t i = 0; i < count; ++i) {
    const HeldSquare problem(error, sampled, parameters, result.standard_errors, i);
    std::optional<Profile> profile;
    const auto end_towards = [&](double direction) {
      if (nodes.rows) {
        const double least = square * static_cast<double>(rows);
        if (const auto found = end_by_newton(sampled, result, parameters, least, growth, i, direction))
          return found;
      }
      if (!profile) profile.emplace(problem, tangent_of(result, problem.unknowns(), i), growth);
      return profile->end(direction);
    };
    ProfileInterval interval;
    const auto place = [&](double distance) {
      const double step = result.standard_errors[i] * distance, end = parameters[i] + step;
      return std::abs(end) <= resolution * std::abs(step) ? 0 : end;
    };
    if (const auto lower = end_towards(-1)) interval.lower = place(*lower);
    if (const auto upper = end_towards(1)) interval.upper = place(*upper);
    result.profiles.push_back(interval);
  }
  return result;
}

}  // namespace shadefit
