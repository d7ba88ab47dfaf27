#include "fit/study/row_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "fit/steps/levenberg.hpp"
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
  // Long double takes four times as long.
  MatrixOf<long double> slopes;
  if (nodes.rows) {
    slopes = SampledStudy<double>(error, nodes).reduced(parameters).slopes.cast<long double>();
  } else {
    const std::vector<long double> wide(parameters.begin(), parameters.end());
    slopes = SampledStudy<long double>(error, nodes).reduced(wide).slopes;
  }
  const VectorOf<long double> shrink = slopes.colwise().norm().cwiseInverse().transpose();
  const MatrixOf<long double> packed = packed_qr(LongMatrix(slopes * shrink.asDiagonal()));
  const auto n = slopes.cols();
  const MatrixOf<long double> inverse =
      packed.topRows(n).triangularView<Eigen::Upper>().solve(MatrixOf<long double>::Identity(n, n));
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

/// Ends of profiles by Newton's method on their equations, for rows of which each pass takes long: the sum of
/// squares has grown by `growth`, and its derivatives by the other parameters are 0. The Hessian is that at
/// the optimum, which a standard error away has hardly changed. Source: Venzon, Moolgavkar 1988, "A Method
/// for Computing Profile-Likelihood-Based Confidence Intervals", Applied Statistics 37.
class NewtonEnds {
 public:
  /// Keeps references. Everything is in units of the standard errors and of the growth.
  NewtonEnds(const SampledStudy<double>& sampled, const RowStatistics& statistics,
             const std::vector<double>& optimum, double growth)
      : sampled_(sampled),
        optimum_(optimum),
        units_(vector_of(statistics.standard_errors)),
        share_(static_cast<double>(sampled.size()) / growth) {
    const auto sums = sampled.derivatives(optimum);
    least_ = share_ * sums.square;
    hessian_ = share_ * (units_.asDiagonal() * sums.hessian * units_.asDiagonal());
    for (Eigen::Index i = 0; i <= units_.size(); ++i) columns_.push_back(i);
  }

  /// The distance in standard errors, in a direction 1 or -1, if that settles near 1. `tangent`: how all
  /// parameters change with the one that is held.
  std::optional<double> end(std::size_t parameter, const Vector& tangent, double direction) const {
    constexpr int most_steps = 8;
    constexpr double last_step = 1e-6, nearest = 0.5, furthest = 2;
    const auto count = units_.size(), held = static_cast<Eigen::Index>(parameter);
    Vector at = direction * tangent;
    for (int step = 0; step < most_steps; ++step) {
      const std::vector<double> place = moved_by<double>(at.cwiseProduct(units_), optimum_);
      ProductMatrix<double> products;
      sampled_.products(place, columns_, products);
      Vector excess = share_ * units_.cwiseProduct(products.col(count).head(count));
      Matrix equations = hessian_;
      equations.row(held) = 2 * excess.transpose();
      excess[held] = share_ * products(count, count) - least_ - 1;
      const Vector moved = shortest_solution(equations, excess);
      at -= moved;
      if (!at.allFinite()) break;
      if (moved.cwiseAbs().maxCoeff() > last_step) continue;
      const double distance = direction * at[held];
      const bool is_near = nearest < distance && distance < furthest && !sampled_.has_pole(place);
      return is_near ? std::optional(at[held]) : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const SampledStudy<double>& sampled_;
  const std::vector<double>& optimum_;
  Vector units_;
  double share_, least_ = 0;
  Matrix hessian_;
  std::vector<Eigen::Index> columns_;
};

}  // namespace

std::optional<RowStatistics> row_statistics(const ReadStudy& study, const StudyError& error,
                                            const SampledStudy<double>& sampled,
                                            const std::vector<double>& parameters,
                                            const Checkpoint& checkpoint) {
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
  std::optional<NewtonEnds> newton;
  if (nodes.rows) newton.emplace(sampled, result, parameters, growth);
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  constexpr double resolution = 1e-8;  // of the search for an end: a smaller one is 0
  for (std::size_t i = 0; i < count; ++i) {
    const HeldSquare problem(error, sampled, parameters, result.standard_errors, i);
    std::optional<Profile> profile;
    const auto end_towards = [&](double direction) {
      checkpoint();
      std::optional<double> end;
      if (newton) end = newton->end(i, tangent_of(result, all, i), direction);
      if (end) return end;
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
