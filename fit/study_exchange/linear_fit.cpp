#include "fit/study_exchange/linear_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/minimax/contacts.hpp"
#include "fit/minimax/quadratic_programme.hpp"
#include "fit/study/even_grid.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study_exchange/linear_curves.hpp"
#include "fit/study_exchange/surface_programme.hpp"
#include "fit/study_rows/row_descent.hpp"
#include "fit/study_squares/equal_candidates.hpp"
#include "fit/study_squares/rules.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// What is bounded at a place: a curve, or a slope of it.
struct Bounded {
  std::size_t curve;
  Place place;
  std::size_t part = 0;  ///< of the curve, 0 for its value
  double unit = 1;       ///< it is divided by this, which has its sign
};

/// Its condition on a step from the start.
struct Cut {
  Bounded of;
  Condition condition;
};

/// One that holds with equality at the answer.
struct Touching {
  Bounded of;
  double multiplier;
  bool is_held;  ///< an equation: the place stays, and the multiplier may have either sign
};

class LinearFit {
 public:
  LinearFit(const ReadStudy& study, const StudyError& error, Norm norm, const Constraints& constraints,
            const std::vector<std::vector<StudyEdge>>& edges, const SampledStudy<double>& sampled,
            const std::vector<double>& start, const Checkpoint& checkpoint)
      : study_(study),
        error_(error),
        constraints_(constraints),
        edges_(edges),
        sampled_(sampled),
        checkpoint_(checkpoint),
        is_minimax_(norm == Norm::minimax),
        curves_(linear_curves(study, constraints)),
        start_(Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size()))),
        parameters_(start_.cast<long double>()) {}

  StudyFit solve() {
    if (!measure() || !cut_grid()) return std::move(fit_);
    // A step that meets the constraints may be far longer than one that changes the error by its size.
    double longest = 1;
    for (const Cut& cut : cuts_)
      if (share_of(cut.of) == 0) longest = std::max(longest, -cut.condition.bound);
    unit_ *= longest;
    steps_ *= longest;
    if (longest > 1 && !cut_grid()) return std::move(fit_);
    if (is_minimax_ ? least_level() : least_square()) finish();
    return std::move(fit_);
  }

  /// By how much the constraints are exceeded at some parameters, in units of the error at the start.
  double excess_at(const std::vector<double>& parameters) {
    if (!measure() || !cut_grid()) return HUGE_VAL;
    for (Eigen::Index i = 0; i < parameters_.size(); ++i)
      parameters_[i] = parameters[static_cast<std::size_t>(i)];
    return add_tops();
  }

 private:
  /// A multiplier below this is the rounding of 0. Those of the level sum to 1.
  static constexpr double no_share = 1e-9;
  /// A condition is in units of the level, or of what a step of that size changes. The tops that exceed their
  /// bounds by less are left to Newton's method.
  static constexpr double exceeds = 1e-10;
  /// The answer holds its conditions to this share: the place of a top in double has half of the digits.
  static constexpr double holds = 1e-9;

  /// Cuts that are this near, as a share of the range, stand for one top.
  static constexpr double near_top = 1e-3;

  bool fail(Status status, std::string why) {
    fit_.status = status;
    fit_.why = std::move(why);
    return false;
  }

  std::vector<double> rounded() const { return {parameters_.begin(), parameters_.end()}; }

  /// The units: a step of 1 along each of `steps_` changes the error by about `unit_`.
  bool measure() {
    const std::vector<double> at = rounded();
    Vector errors;
    Matrix slopes;
    sampled_.errors(at, errors, &slopes);
    constexpr double least = 1e-3;  // of the target: constraints alone move an exact form
    unit_ = errors.cwiseAbs().maxCoeff();
    const bool is_exact = unit_ <= 1e-14 * sampled_.target_norm();
    if (is_exact) unit_ = least * sampled_.target_norm();
    if (!(unit_ > 0) || !errors.allFinite())
      return fail(Status::not_finite, "the error at the start is not finite");
    steps_ = row_directions(slopes, unit_);
    if (steps_.cols() == slopes.cols()) return true;
    const std::string names = flat_direction(study_, sampled_, at);
    return fail(Status::degenerate,
                names.empty() ? "the parameters do not move the error independently" : names);
  }

  std::size_t level() const { return static_cast<std::size_t>(steps_.cols()); }

  /// Adds the condition of a curve at a place. False if no parameter moves it there and it is violated.
  bool cut(std::size_t curve, const Place& place) {
    const double share = curves_[curve].share;
    const CurvePart part = curves_[curve].at(place, start_.cast<long double>()).front();
    const double slope = Vector(steps_.transpose() * part.slope.cast<double>()).norm();
    if (!std::isfinite(slope) || !std::isfinite(part.value)) return true;
    largest_[curve] = std::max(largest_[curve], slope);
    constexpr double unmoved = 1e-13;  // of the largest slope of the curve
    if (share == 0 && !(slope > unmoved * largest_[curve])) {
      const double rounding = 1e-12 * std::max(sampled_.target_norm(), largest_[curve]);
      return part.value <= rounding || impossible(curve, place);
    }
    const Bounded of{curve, place, 0, share > 0 ? unit_ : slope};
    cuts_.push_back({of, condition(of)});
    return true;
  }

  Condition condition(const Bounded& of) {
    const CurvePart part = curves_[of.curve].at(of.place, start_.cast<long double>())[of.part];
    Condition result{{}, -static_cast<double>(part.value / static_cast<long double>(of.unit))};
    const Vector slope = steps_.transpose() * part.slope.cast<double>() / of.unit;
    std::copy(slope.begin(), slope.end(), result.slope.begin());
    result.slope[level()] = -share_of(of);
    return result;
  }

  double share_of(const Bounded& of) const { return of.part == 0 ? curves_[of.curve].share : 0; }

  bool impossible(std::size_t curve, const Place& place) {
    const Touch touch = curves_[curve].touch;
    const std::string bound = touch == Touch::at_most    ? to_text(*constraints_.at_most)
                              : touch == Touch::at_least ? to_text(*constraints_.at_least)
                                                         : "target";
    const std::string what = touch == Touch::falls   ? "falling"
                             : touch == Touch::rises ? "rising"
                             : sign_of(touch) > 0    ? "<= " + bound
                                                     : ">= " + bound;
    return fail(Status::infeasible,
                (touch == Touch::exact ? "the form cannot be exact" : "no parameters keep the form " + what) +
                    " at " + study_.axes.front().variable + " = " + to_text(place.front()));
  }

  bool is_searched(std::size_t curve) const {
    return curves_[curve].touch != Touch::exact && (is_minimax_ || curves_[curve].share == 0);
  }

  /// The first places, so many that they determine the parameters.
  bool cut_grid() {
    constexpr std::array grid_steps{64, 10, 5};
    cuts_.clear();
    largest_.assign(curves_.size(), 0);
    for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
      if (!is_searched(curve)) continue;
      for (const Place& place : even_grid(study_.axes, grid_steps[study_.axes.size() - 1])) {
        if (!cut(curve, place)) return false;
      }
    }
    for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
      if (curves_[curve].touch != Touch::exact) continue;
      for (const double x : constraints_.exact_at) {
        if (!cut(curve, {x})) return false;
      }
    }
    return true;
  }

  std::vector<Condition> conditions() const {
    std::vector<Condition> result;
    for (const Cut& cut : cuts_) result.push_back(cut.condition);
    return result;
  }

  /// By how much a curve exceeds its bound at a place, in the units of its condition.
  double excess(std::size_t curve, const CurvePart& part) const {
    const LinearCurve& of = curves_[curve];
    const double unit = of.share > 0 ? unit_ : Vector(steps_.transpose() * part.slope.cast<double>()).norm();
    return static_cast<double>(part.value / static_cast<long double>(unit)) - of.share * level_;
  }

  /// The tops of a curve, at least those near its bound or above.
  std::vector<Place> tops(std::size_t curve) {
    // Between places of a grid a constraint may be violated by little, where both are below its bound.
    const double ground = curves_[curve].share > 0 ? 0 : -largest_[curve];
    const double share = curves_[curve].share > 0 ? 0.9 : 0.3;  // of the highest
    std::vector<Place> result;
    for (const StudyExtremum& found : tops_of(curves_[curve].heights(), ground, edges_, rounded(), share))
      result.push_back(top_near(curves_[curve], found.at, parameters_, edges_));
    return result;
  }

  /// Adds the tops that exceed their bounds. Returns by how much the highest does.
  double add_tops() {
    checkpoint_();
    double highest = 0;
    for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
      if (!is_searched(curve)) continue;
      for (const Place& place : tops(curve)) {
        const CurvePart part = curves_[curve].at(place, parameters_).front();
        const double over = excess(curve, part);
        if (!(over > exceeds) || !part.slope.allFinite()) continue;
        highest = std::max(highest, over);
        if (!is_known(curve, place)) cut(curve, place);
      }
    }
    return highest;
  }

  bool is_known(std::size_t curve, const Place& place) const {
    return std::any_of(cuts_.begin(), cuts_.end(), [&](const Cut& cut) {
      return cut.of.curve == curve && are_near(cut.of.place, place, 1e-12);
    });
  }

  bool are_near(const Place& a, const Place& b, double share) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::abs(a[i] - b[i]) > share * (study_.axes[i].upper - study_.axes[i].lower)) return false;
    }
    return true;
  }

  void step_to(const Vector& step) {
    parameters_ = start_.cast<long double>() + (steps_ * step).cast<long double>();
  }

  /// The least level: the linear programme, then Newton's method, then the least square if many have it.
  bool least_level() {
    std::optional<LowestLevel> lowest = first_level();
    if (!lowest) return fail(Status::degenerate, "the parameters do not move the error independently");
    const std::size_t unknowns = level() + 1;
    for (std::size_t known = 0; known != cuts_.size();) {
      const LowestLevel next =
          lowest_level(conditions(), unknowns, std::span(lowest->reference).first(unknowns), rounding_);
      if (next.ending == LowestLevel::Ending::infeasible) return violated();
      if (next.ending != LowestLevel::Ending::found) {
        // Cuts of one top that are close to each other round more. Newton's method finds the digits.
        constexpr double most_rounding = 1e-6;
        if (rounding_ > most_rounding) break;
        rounding_ *= 10;
        continue;
      }
      known = cuts_.size();
      lowest = next;
      level_ = lowest->unknowns[level()];
      step_to(Eigen::Map<const Vector>(lowest->unknowns.data(), steps_.cols()));
      add_tops();
    }
    if (!(level_ * unit_ > 1e-14 * sampled_.target_norm()))
      return fail(Status::degenerate,
                  "the largest error is down to the rounding of the form: it has no level");
    measure_square();
    return settle_from(*lowest) && (is_determined() || least_square());
  }

  /// Newton's method from the vertex of the programme; where few places hold the level, from the least square
  /// of those with nearly this level.
  bool settle_from(const LowestLevel& lowest) {
    const double promised = level_;
    for (const double slack : {0.0, 1e-6, 1e-4, 1e-2}) {
      level_ = promised;
      same_top_ = std::max(near_top, std::sqrt(slack));
      if (slack > 0 && !centre(slack)) continue;
      touching_.clear();
      for (std::size_t i = 0; i <= level(); ++i) touch(cuts_[lowest.reference[i]], lowest.multipliers[i]);
      if (slack == 0 && touching_.size() <= level()) continue;
      // The programme's level is a lower bound, and nearly reached.
      constexpr double roundings = 100;
      if (settle_level() && std::abs(level_ - promised) <= roundings * rounding_) return true;
    }
    return fail(Status::not_converged,
                "Newton's method does not settle at the level, about " + decimal(promised * unit_, 6));
  }

  /// A reference of the error alone.
  std::optional<LowestLevel> first_level() {
    std::vector<std::size_t> of_error;
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      if (cuts_[i].of.curve == 0) of_error.push_back(i);
    }
    const auto rows = static_cast<Eigen::Index>(of_error.size());
    Vector errors(rows);
    Matrix slopes(rows, steps_.cols());
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Condition& condition = cuts_[of_error[static_cast<std::size_t>(i)]].condition;
      errors[i] = -condition.bound;
      slopes.row(i) = Eigen::Map<const Vector>(condition.slope.data(), steps_.cols());
    }
    const auto step = level_step(errors, slopes, exceeds);
    if (!step) return std::nullopt;
    LowestLevel lowest = step->lowest;
    for (std::size_t i = 0; i <= level(); ++i) {
      const Place& place = cuts_[of_error[step->places[i]]].of.place;
      const std::size_t curve = step->signs[i] > 0 ? 0 : 1;
      const auto found = std::find_if(cuts_.begin(), cuts_.end(), [&](const Cut& cut) {
        return cut.of.curve == curve && cut.of.place == place;
      });
      lowest.reference[i] = static_cast<std::size_t>(found - cuts_.begin());
    }
    return lowest;
  }

  /// The constraint that is violated most at the last parameters.
  bool violated() {
    const Cut* worst = nullptr;
    double most = 0;
    for (const Cut& cut : cuts_) {
      if (curves_[cut.of.curve].share > 0) continue;
      const double over = excess(cut.of.curve, curves_[cut.of.curve].at(cut.of.place, parameters_).front());
      if (!(over > most)) continue;
      most = over;
      worst = &cut;
    }
    if (worst == nullptr || !touching_.empty())
      return fail(Status::not_converged, "the programme has no answer up to its rounding");
    return impossible(worst->of.curve, worst->of.place);
  }

  /// Adds a condition that touches if it has a multiplier. Several cuts may stand for one top.
  void touch(const Cut& cut, double multiplier) {
    if (!(multiplier > no_share)) return;
    Touching entering{cut.of, multiplier, curves_[cut.of.curve].touch == Touch::exact};
    if (!entering.is_held && cut.of.part == 0 && same_top_ > near_top) {
      constexpr double same_hill = 0.02;  // of the range
      const Place top = top_near(curves_[cut.of.curve], cut.of.place, parameters_, edges_);
      if (are_near(top, cut.of.place, same_hill)) entering.of.place = top;
    }
    for (Touching& other : touching_) {
      if (other.of.curve != cut.of.curve || other.of.part != cut.of.part ||
          !are_near(other.of.place, entering.of.place, same_top_))
        continue;
      if (!other.is_held) other.multiplier += multiplier;
      return;
    }
    touching_.push_back(entering);
  }

  Vector slope_of(const Touching& t, const std::vector<CurvePart>& parts) const {
    return steps_.transpose() * parts[t.of.part].slope.cast<double>() / t.of.unit;
  }

  /// How the slope of a top's height changes with the parameters while its place moves along.
  Matrix bend_of(const Touching& t, const std::vector<CurvePart>& parts) const {
    const std::vector<Eigen::Index> axes = moving_axes(t, parts);
    Matrix across(steps_.cols(), static_cast<Eigen::Index>(axes.size()));
    for (Eigen::Index i = 0; i < across.cols(); ++i)
      across.col(i) =
          steps_.transpose() *
          parts[1 + static_cast<std::size_t>(axes[static_cast<std::size_t>(i)])].slope.cast<double>() /
          t.of.unit;
    const Matrix along = curvature_along(parts, t.of.place.size(), axes) / t.of.unit;
    Matrix bend = Matrix::Zero(steps_.cols(), steps_.cols());
    if (axes.empty() || !along.allFinite()) return bend;
    for (Eigen::Index i = 0; i < bend.cols(); ++i)
      bend.col(i) = -across * solution(pivoted_qr(along), across.row(i).transpose());
    return (bend + bend.transpose()) / 2;
  }

  /// The axes along which the place of a condition moves with the parameters. A curve that is level there has
  /// no top.
  std::vector<Eigen::Index> moving_axes(const Touching& t, const std::vector<CurvePart>& parts) const {
    if (t.is_held || t.of.part != 0) return {};
    constexpr double is_level = 1e-5;  // of the curve's unit over the range
    std::vector<Eigen::Index> axes = free_axes(t.of.place, edges_);
    std::erase_if(axes, [&](Eigen::Index axis) {
      const double bend = curvature_along(parts, edges_.size(), {axis})(0, 0);
      return !(std::abs(bend) * width(axis) * width(axis) > is_level * std::abs(t.of.unit));
    });
    return axes;
  }

  double width(Eigen::Index axis) const {
    const StudyAxis& of = study_.axes[static_cast<std::size_t>(axis)];
    return of.upper - of.lower;
  }

  /// Takes Newton's step on the equations of Karush, Kuhn and Tucker. The unknowns are the parameters along
  /// the steps, the level if it is not given, the multipliers, and the places that move, where their curves
  /// have a top. `gradient` is that of what is minimised. Returns the step of the parameters.
  Wide newton(const Matrix& hessian, const Wide& gradient, bool has_level) {
    const Eigen::Index n = steps_.cols(), first = n + (has_level ? 1 : 0);
    Eigen::Index place_row = first + static_cast<Eigen::Index>(touching_.size()), size = place_row;
    std::vector<std::vector<Eigen::Index>> moving;
    for (const Touching& t : touching_) {
      moving.push_back(moving_axes(t, curves_[t.of.curve].at(t.of.place, parameters_)));
      size += static_cast<Eigen::Index>(moving.back().size());
    }
    Matrix matrix = Matrix::Zero(size, size);
    matrix.topLeftCorner(n, n) = hessian;
    Wide lack = Wide::Zero(size);
    lack.head(n) = -gradient;
    if (has_level) lack[n] = -1;
    for (Eigen::Index row = first; const Touching& t : touching_) {
      const std::vector<CurvePart> parts = curves_[t.of.curve].at(t.of.place, parameters_);
      const auto unit = static_cast<long double>(t.of.unit);
      const Wide slope = steps_.transpose().cast<long double>() * parts[t.of.part].slope / unit;
      matrix.col(row).head(n) = slope.cast<double>();
      matrix.row(row).head(n) = slope.cast<double>().transpose();
      lack.head(n) -= static_cast<long double>(t.multiplier) * slope;
      lack[row] = static_cast<long double>(share_of(t.of) * level_) - parts[t.of.part].value / unit;
      if (has_level) {
        matrix(n, row) = matrix(row, n) = -share_of(t.of);
        lack[n] += static_cast<long double>(share_of(t.of) * t.multiplier);
      }
      const std::vector<Eigen::Index>& axes = moving[static_cast<std::size_t>(row - first)];
      const Matrix bend = curvature_along(parts, edges_.size(), axes);
      for (Eigen::Index i = 0; i < bend.cols(); ++i) {
        const Eigen::Index axis = axes[static_cast<std::size_t>(i)];
        const CurvePart& along = parts[1 + static_cast<std::size_t>(axis)];
        const Vector across = steps_.transpose() * along.slope.cast<double>() * width(axis) / t.of.unit;
        matrix.col(place_row + i).head(n) = t.multiplier * across;
        matrix.row(place_row + i).head(n) = across.transpose();
        matrix(row, place_row + i) = static_cast<double>(along.value) * width(axis) / t.of.unit;
        lack[place_row + i] = -along.value * static_cast<long double>(width(axis)) / unit;
        for (Eigen::Index j = 0; j < bend.cols(); ++j)
          matrix(place_row + i, place_row + j) =
              bend(i, j) * width(axis) * width(axes[static_cast<std::size_t>(j)]) / t.of.unit;
      }
      place_row += bend.cols();
      ++row;
    }
    if (!matrix.allFinite()) return Wide::Constant(parameters_.size(), NAN);
    constexpr double rounding = 1e-12;
    return take(shortest_solution(matrix, lack.cast<double>(), rounding), moving, has_level);
  }

  Wide take(Vector step, const std::vector<std::vector<Eigen::Index>>& moving, bool has_level) {
    const Eigen::Index n = steps_.cols(), first = n + (has_level ? 1 : 0),
                       places = first + static_cast<Eigen::Index>(touching_.size());
    constexpr double most_move = 0.02;  // of the range: a place stays on its hill
    const double move = step.size() > places ? step.tail(step.size() - places).cwiseAbs().maxCoeff() : 0;
    if (move > most_move) step *= most_move / move;
    const Wide moved = steps_.cast<long double>() * step.head(n).cast<long double>();
    parameters_ += moved;
    if (has_level) level_ += step[n];
    Eigen::Index next = places;
    for (std::size_t i = 0; i < touching_.size(); ++i) {
      Touching& t = touching_[i];
      for (const Eigen::Index axis : moving[i]) {
        const auto& edges = edges_[static_cast<std::size_t>(axis)];
        double& x = t.of.place[static_cast<std::size_t>(axis)];
        x = std::clamp(x + step[next++] * width(axis), edges.front().at, edges.back().at);
      }
      t.multiplier += step[first + static_cast<Eigen::Index>(i)];
    }
    return moved;
  }

  /// The largest step relative to its parameter. One that is nearly 0 counts as what moves the error by a
  /// thousandth of the level.
  long double relative(const Wide& step) const {
    constexpr double negligible_share = 1e-3;
    long double largest = 0;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
      const double least = negligible_share * level_ * steps_.row(j).cwiseAbs().maxCoeff();
      largest = std::max(
          largest, std::abs(step[j]) / std::max(std::abs(parameters_[j]), static_cast<long double>(least)));
    }
    return largest;
  }

  bool settle_level() {
    constexpr int most_passes = 40;
    // A curvature that holds the parameters where the places of the level leave them open.
    constexpr double least_bend = 1e-6;
    const Matrix held = least_bend * Matrix::Identity(steps_.cols(), steps_.cols());
    const Wide no_gradient = Wide::Zero(steps_.cols());
    long double size = HUGE_VALL;
    for (int pass = 0; pass < most_passes; ++pass) {
      const long double before = size;
      size = relative(newton(held, no_gradient, true));
      if (!std::isfinite(size)) break;
      if (size < 1e-17L || (size < 1e-10L && !(size < before / 2))) break;
    }
    fit_.digits = correct_digits(size);
    return fit_.digits >= least_study_digits && has_signs();
  }

  /// Whether no multiplier of an inequality is negative beyond rounding.
  bool has_signs() const {
    constexpr double rounding = 1e-7;  // of the largest
    double largest = 0, least = 0;
    for (const Touching& t : touching_) {
      largest = std::max(largest, std::abs(t.multiplier));
      if (!t.is_held) least = std::min(least, t.multiplier);
    }
    return least >= -rounding * largest;
  }

  /// Whether no other parameters have this level: the places, and how they move, determine them.
  bool is_determined() {
    Matrix slopes(0, steps_.cols()), bend = Matrix::Zero(steps_.cols(), steps_.cols());
    for (const Touching& t : touching_) {
      const std::vector<CurvePart> parts = curves_[t.of.curve].at(t.of.place, parameters_);
      bend += t.multiplier * bend_of(t, parts);
      slopes.conservativeResize(slopes.rows() + 1, Eigen::NoChange);
      slopes.bottomRows(1) = slope_of(t, parts).transpose();
    }
    constexpr double rounding = 1e-9, no_curvature = 1e-7;
    const PivotedQr qr = pivoted_qr(slopes.transpose(), rounding);
    const Eigen::Index open = steps_.cols() - qr.rank();
    if (open <= 0) return true;
    const Matrix along = basis(qr).rightCols(open);
    fit_.is_unique = eigen_of(along.transpose() * bend * along).eigenvalues()[0] > no_curvature;
    return fit_.is_unique;
  }

  /// Holds the places of the level: each answer has these errors. There they are stationary, or fall from an
  /// end of the range.
  void hold_level() {
    before_held_ = cuts_.size();
    level_support_ = touching_;
    std::vector<Touching> held = touching_;
    for (const Touching& t : touching_) {
      for (std::size_t axis = 0; axis < edges_.size(); ++axis) {
        const double lower = edges_[axis].front().at, upper = edges_[axis].back().at;
        const bool is_lower = t.of.place[axis] == lower, is_upper = t.of.place[axis] == upper;
        Bounded slope{t.of.curve, t.of.place, 1 + axis};
        const auto size = [&] {
          const std::vector<CurvePart> parts = curves_[slope.curve].at(slope.place, parameters_);
          return Vector(steps_.transpose() * parts[slope.part].slope.cast<double>()).norm();
        };
        // At an end with a root the slope is infinite. Beside it the other terms are a rounding.
        constexpr double beside = 1e-13;  // of the range
        if (!std::isfinite(size())) slope.place[axis] += (is_lower ? beside : -beside) * (upper - lower);
        slope.unit = is_upper ? -size() : size();
        if (slope.unit == 0 || !std::isfinite(slope.unit)) continue;
        const std::vector<Eigen::Index> free = free_axes(t.of.place, edges_);
        if (is_lower || is_upper) {
          cuts_.push_back({slope, condition(slope)});
        } else if (std::find(free.begin(), free.end(), static_cast<Eigen::Index>(axis)) != free.end()) {
          held.push_back({slope, 0, true});
        }
      }
    }
    touching_.clear();
    Matrix chosen(steps_.cols(), 0);
    for (Touching& t : held) {
      const Vector slope = slope_of(t, curves_[t.of.curve].at(t.of.place, parameters_));
      Matrix longer(chosen.rows(), chosen.cols() + 1);
      longer << chosen, slope.normalized();
      constexpr double rounding = 1e-8;  // the places have half of the digits
      if (!slope.allFinite() || pivoted_qr(longer, rounding).rank() < longer.cols()) continue;
      chosen = longer;
      touching_.push_back({t.of, 0, true});
    }
  }

  /// The square near the start, along the steps and in units of the level's.
  void measure_square() {
    const SampledStudy<double> sampled(error_, nodes_of(study_, edges_, fit_rules[search_rule(study_)]));
    const auto sums = sampled.derivatives(std::vector<double>(start_.begin(), start_.end()));
    raw_hessian_ = sums.hessian;
    hessian_ = steps_.transpose() * sums.hessian * steps_ / (unit_ * unit_);
    gradient_ = steps_.transpose() * sums.gradient / (unit_ * unit_);
  }

  /// The step with the least square under the conditions so far at a level, and what is held.
  std::optional<QuadraticAnswer> square_step(double level, double slack, const std::vector<Touching>& held,
                                             std::vector<const Cut*>& of) {
    std::vector<Condition> all;
    of.assign(held.size(), nullptr);
    for (const Touching& t : held) {
      all.push_back(condition(t.of));
      all.back().bound += share_of(t.of) * level;
      all.back().is_equation = true;
    }
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const Cut& cut = cuts_[i];
      if (i < before_held_ && is_held_at(held, cut)) continue;
      all.push_back(cut.condition);
      all.back().bound += share_of(cut.of) * level + slack;
      of.push_back(&cut);
    }
    const auto answer = least_step(hessian_, gradient_, all);
    return answer && answer->step.allFinite() ? answer : std::nullopt;
  }

  /// Of the parameters with nearly the least level those with the least square: a vertex of the programme is
  /// far from them where few places hold the level.
  bool centre(double slack) {
    for (std::size_t known = 0; known != cuts_.size();) {
      known = cuts_.size();
      std::vector<const Cut*> of;
      const auto answer = square_step(level_, slack, {}, of);
      if (!answer) return false;
      step_to(answer->step);
      if (add_tops() < slack) return true;
    }
    return true;
  }

  /// The least square under the conditions, with the level as it is.
  bool least_square() {
    if (is_minimax_) {
      hold_level();
    } else {
      measure_square();
    }
    const std::vector<Touching> held = touching_;
    double slack = exceeds / 10;
    for (std::size_t known = 0; known != cuts_.size();) {
      std::vector<const Cut*> of;
      const auto answer = square_step(level_, slack, held, of);
      if (!answer) {
        // The conditions at a level leave no room: up to rounding they contradict each other.
        constexpr double most_slack = 1e-7;
        if (slack > most_slack) return violated();
        slack *= 10;
        continue;
      }
      known = cuts_.size();
      step_to(answer->step);
      touching_ = held;
      for (const ActiveCondition& active : answer->active) {
        if (of[active.condition] == nullptr) {
          touching_[active.condition].multiplier = active.multiplier;
        } else {
          touch(*of[active.condition], active.multiplier);
        }
      }
      add_tops();
    }
    if (!settle_square()) return false;
    if (is_minimax_) fit_.is_unique = !has_way();
    return true;
  }

  /// Whether a place is so near one that is held that its condition says the same.
  bool is_held_at(const std::vector<Touching>& held, const Cut& cut) const {
    constexpr double same = 1e-3;  // of the range
    return std::any_of(held.begin(), held.end(), [&](const Touching& t) {
      return t.of.curve == cut.of.curve && t.of.part == 0 && cut.of.part == 0 &&
             are_near(t.of.place, cut.of.place, same);
    });
  }

  /// Whether a step from the answer raises no top that is at its bound: the nearest of those to each
  /// coordinate step is not 0.
  bool has_way() {
    constexpr double at_bound = 1e-7, no_step = 1e-6;
    std::vector<Condition> conditions;
    for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
      if (!is_searched(curve)) continue;
      for (const Place& place : tops(curve)) {
        const CurvePart part = curves_[curve].at(place, parameters_).front();
        if (!(excess(curve, part) > -at_bound) || !part.slope.allFinite()) continue;
        const Vector slope = steps_.transpose() * part.slope.cast<double>();
        std::copy(slope.begin(), slope.end(), conditions.emplace_back().slope.begin());
      }
    }
    const Eigen::Index n = steps_.cols();
    for (Eigen::Index i = 0; i < 2 * n; ++i) {
      const Vector towards = Vector::Unit(n, i / 2) * (i % 2 == 0 ? 1 : -1);
      const auto nearest = least_step(Matrix::Identity(n, n), -towards, conditions);
      if (!nearest || nearest->step.norm() > no_step) return true;
    }
    return false;
  }

  /// One rule after the other, until the next one moves no digit.
  bool settle_square() {
    long double size = HUGE_VALL;
    for (std::size_t rule = search_rule(study_); rule <= Rules(study_, error_).last() && size > settled;
         ++rule) {
      const SampledStudy<long double> wide(error_, nodes_of(study_, edges_, fit_rules[rule]));
      const auto step = [&] {
        const auto sums = wide.gradient(std::vector<long double>(parameters_.begin(), parameters_.end()));
        const auto square = static_cast<long double>(unit_ * unit_);
        return newton(hessian_, steps_.transpose().cast<long double>() * sums.gradient / square, false);
      };
      size = relative_size(step(), rounded(), raw_hessian_, static_cast<double>(wide.target_norm()));
      for (int pass = 0; pass < 3; ++pass) step();
      fit_.rms_error = std::sqrt(
          static_cast<double>(wide.square(std::vector<long double>(parameters_.begin(), parameters_.end()))));
    }
    fit_.digits = correct_digits(size);
    return (fit_.digits >= least_study_digits && has_signs()) ||
           fail(Status::not_converged, "Newton's method does not settle in long double");
  }

  /// Rounds the answer, checks its conditions, and says where it touches.
  void finish() {
    fit_.parameters = rounded();
    clear_rounding(fit_.parameters, raw_hessian_, sampled_.target_norm());
    if (!parameters_.allFinite()) {
      fail(Status::not_finite, "a parameter is not finite");
      return;
    }
    parameters_ = Eigen::Map<const Vector>(fit_.parameters.data(), parameters_.size()).cast<long double>();
    const double rounding = 1e-14 * sampled_.target_norm() / unit_;
    if (const double over = add_tops(); !(over <= holds * std::max(level_, 1e-3) + rounding)) {
      fail(Status::not_converged, "a condition is exceeded by " + decimal(over * unit_, 2));
      return;
    }
    if (is_minimax_) fit_.level = level_ * unit_;
    const double of_square = is_minimax_ && fit_.is_unique ? 1 : unit_;
    std::erase_if(touching_, [&](const Touching& t) { return t.is_held && !level_support_.empty(); });
    touching_.insert(touching_.end(), level_support_.begin(), level_support_.end());
    for (const Touching& t : touching_) {
      if (t.of.part != 0) continue;
      const Place& place = t.of.place;
      const double error = static_cast<double>(curves_.front().at(place, parameters_).front().value);
      if (study_.axes.size() > 1) {
        fit_.touching.push_back({place, error});
      } else {
        const Touch touch = curves_[t.of.curve].touch;
        const double multiplier =
            share_of(t.of) > 0 ? t.multiplier : t.multiplier * unit_ * of_square / t.of.unit;
        fit_.alternation.push_back({touch, false, {place.front(), 1 - place.front()}, error, multiplier});
      }
    }
    std::ranges::sort(fit_.touching, {}, &StudyContact::at);
    std::ranges::sort(fit_.alternation, {}, [](const AlternationPoint& point) { return point.at.cos_theta; });
    fit_.status = Status::converged;
  }

  const ReadStudy& study_;
  const StudyError& error_;
  const Constraints& constraints_;
  const std::vector<std::vector<StudyEdge>>& edges_;
  const SampledStudy<double>& sampled_;
  const Checkpoint& checkpoint_;
  bool is_minimax_;
  std::vector<LinearCurve> curves_;
  Vector start_;
  Wide parameters_;
  double unit_ = 0, level_ = 0;     ///< the level in units
  double rounding_ = exceeds / 10;  ///< of the linear programme
  double same_top_ = near_top;      ///< of the range: how near cuts are that stand for one top
  Matrix steps_ = {}, raw_hessian_ = {};
  Matrix hessian_ = {};               ///< of half the square at the start, along the steps, and
  Vector gradient_ = {};              ///< its gradient
  std::vector<double> largest_ = {};  ///< slope of each curve
  std::vector<Cut> cuts_ = {};
  std::size_t before_held_ = 0;  ///< how many cuts there were when the places of the level were held
  std::vector<Touching> touching_ = {};
  std::vector<Touching> level_support_ = {};  ///< the places of the level, where they leave parameters open
  StudyFit fit_ = {};
};

}  // namespace

bool are_dependent(const SampledStudy<double>& sampled, const std::vector<double>& parameters) {
  Vector errors;
  Matrix slopes;
  sampled.errors(parameters, errors, &slopes);
  return row_directions(slopes, 1).cols() < slopes.cols();
}

bool keeps_constraints(const ReadStudy& study, const StudyError& error, const Constraints& constraints,
                       const std::vector<std::vector<StudyEdge>>& edges, const SampledStudy<double>& sampled,
                       const std::vector<double>& start, const std::vector<double>& parameters) {
  constexpr double same = 1e-6;
  return LinearFit(study, error, Norm::least_squares, constraints, edges, sampled, start, keep_going)
             .excess_at(parameters) <= same;
}

StudyFit solve_linear_fit(const ReadStudy& study, const StudyError& error, Norm norm,
                          const Constraints& constraints, const std::vector<std::vector<StudyEdge>>& edges,
                          const SampledStudy<double>& sampled, const std::vector<double>& start,
                          const Checkpoint& checkpoint) {
  return LinearFit(study, error, norm, constraints, edges, sampled, start, checkpoint).solve();
}

}  // namespace shadefit
