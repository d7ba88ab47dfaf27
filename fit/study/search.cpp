#include "fit/study/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

#include "fit/quadrature/fit_rules.hpp"
#include "fit/steps/levenberg.hpp"
#include "fit/study/projection.hpp"
#include "fit/study/require_values.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Of parameters: on the stack.
using Vector = ProductVector<double>;

/// The n-th number of van der Corput's sequence in a base: Halton's points have one for each coordinate.
double radical_inverse(std::uint64_t n, std::uint64_t base) {
  double result = 0, digit = 1;
  for (; n > 0; n /= base) {
    digit /= static_cast<double>(base);
    result += digit * static_cast<double>(n % base);
  }
  return result;
}

/// A start of a parameter from a number in [0, 1): of either sign, with as many in each octave. A descent may
/// leave this range.
double spread(double u, int octaves) {
  const double side = 2 * u - 1;
  return std::copysign(std::exp2(octaves * (2 * std::abs(side) - 1)), side);
}

/// The squares at the ends of descents in one basin differ by at most this share.
constexpr double same_square = 1e-6;

/// If there are more rows than this, only some take part in the first steps: they show the same basins.
constexpr std::size_t most_scanned = 2000;
/// And of rows without a copy only so many in all steps of the search.
constexpr std::size_t most_searched = 20000;

/// At most so many rows: at even steps through the list, or of rows without a copy one of each stretch.
StudyNodes thinned(ReadStudy study, std::size_t most) {
  const std::size_t size = study.rows->value.size(), step = (size + most - 1) / most;
  std::vector<std::size_t> rows;
  for (std::size_t n = 0; n < size; n += step) rows.push_back(n);
  if (size > most_copied_rows) rows = drawn_from(size, most);
  study.rows = std::make_shared<const MeasuredRows>(some_of(*study.rows, rows));
  return nodes_of(study, {}, 1);
}

/// The places of candidates on some of the rows that may be the lowest on all of them, each once.
std::vector<std::vector<double>> perhaps_lowest(const std::vector<StudyCandidate>& candidates,
                                                double target_norm) {
  // On thousands of rows a square is known to a few percent.
  constexpr double share = 1.1, rounding = 1e-20, near = 1e-3;
  constexpr std::size_t most = 8;
  std::vector<std::vector<double>> places;
  for (const StudyCandidate& candidate : candidates) {
    const std::vector<double>& own = candidate.parameters;
    const auto is_near = [](double a, double b) {
      return std::abs(a - b) <= near * std::max(std::abs(a), std::abs(b));
    };
    const auto is_there = [&](const auto& place) { return std::ranges::equal(place, own, is_near); };
    const double highest = share * candidates.front().square + rounding * target_norm * target_norm;
    if (candidate.square <= highest && places.size() < most && std::ranges::none_of(places, is_there))
      places.push_back(own);
  }
  return places;
}

constexpr std::uint64_t primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};

/// The parameters that do not enter linearly, and the square of the error with the best of the others.
struct SearchedPlace {
  Vector q;
  double square = 0;
  std::optional<std::size_t> kept = std::nullopt;  ///< its number among those that were looked at
};

void sort_by_square(std::vector<SearchedPlace>& places) {
  std::ranges::stable_sort(places, {}, &SearchedPlace::square);
}

/// Descents on some nodes. A place without a finite error is left out. `units` are those of all parameters,
/// or empty.
class Descents {
 public:
  Descents(const StudyError& error, const SampledStudy<double>& sampled, const std::vector<double>& units,
           const Checkpoint& checkpoint, bool keeps_from_poles = false)
      : problem_(error, sampled),
        barrier_(keeps_from_poles ? &sampled : nullptr),
        residuals_(problem_.residual_count()),
        units_(units.empty() ? Vector::Ones(problem_.unknown_count()) : unknowns_of(units)),
        residual_unit_(unit_of(sampled.target_norm())),
        checkpoint_(checkpoint),
        least_change_(1e-20 * sampled.target_norm() * sampled.target_norm()) {}

  /// The indices of the parameters that do not enter linearly.
  const std::vector<std::size_t>& unknowns() const { return problem_.nonlinear(); }
  Vector unknowns_of(const std::vector<double>& parameters) const {
    Vector q(problem_.unknown_count());
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = parameters[unknowns()[static_cast<std::size_t>(i)]];
    return q;
  }
  std::vector<double> parameters_at(const Vector& q) const {
    square_at(q);
    return problem_.parameters();
  }

  /// The places with their squares, sorted by square. What was computed there is kept for `from`.
  std::vector<SearchedPlace> all_at(const std::vector<Vector>& places) const {
    std::vector<SearchedPlace> looked;
    kept_.clear();
    for (std::size_t i = 0; i < places.size(); ++i) {
      checkpoint_();
      problem_.forget();
      const double square = square_at(places[i]);
      problem_.keep(kept_);
      if (std::isfinite(square)) looked.push_back({places[i], square, i});
    }
    sort_by_square(looked);
    return looked;
  }

  /// The ends of descents of so many steps, sorted by square.
  std::vector<SearchedPlace> from(const std::vector<SearchedPlace>& starts, int steps) const {
    std::vector<SearchedPlace> ends;
    for (const SearchedPlace& start : starts) {
      checkpoint_();
      const std::size_t size = problem_.kept_size();
      if (start.kept) {
        problem_.recall(std::span(kept_).subspan(*start.kept * size, size));
      } else {
        problem_.forget();
      }
      Vector q = start.q;
      if (!std::isfinite(square_at(q))) continue;
      descend(q, steps);
      if (const double square = square_at(q); std::isfinite(square)) ends.push_back({q, square});
    }
    sort_by_square(ends);
    return ends;
  }

 private:
  double square_at(const Vector& q) const {
    problem_(q.data(), residuals_.data(), nullptr);
    return is_behind_pole() ? HUGE_VAL : residuals_.squaredNorm();
  }

  /// A descent ends when the square changes by a few roundings. How small the square becomes is known only at
  /// the end: if it has fallen far, the descent goes on with the rounding of the smaller square.
  void descend(Vector& q, int steps) const {
    // The squares of 900 nodes, near an optimum, differ by up to 5 epsilon.
    constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
    const Residuals residuals{
        problem_.residual_count(),
        [this](const double* at, double* r, double* jacobian) { evaluate_in_units(at, r, jacobian); }};
    Vector in_units = q.cwiseQuotient(units_);
    for (double before = HUGE_VAL, square = square_at(q); steps > 0 && square < before / 2;) {
      before = square;
      const double least = std::max(least_change_, roundings * square) / (residual_unit_ * residual_unit_);
      steps -= shadefit::descend(residuals, {1e-10, steps, least}, in_units);
      q = in_units.cwiseProduct(units_);
      square = square_at(q);
    }
  }

  /// The reduced problem in units of its unknowns and of its residuals, which are powers of two. The solver
  /// takes derivatives far below 1 for rounding.
  void evaluate_in_units(const double* q, double* residuals, double* jacobian) const {
    const Eigen::Index n = problem_.unknown_count();
    const ProductVector<double> at = units_.cwiseProduct(Eigen::Map<const Vector>(q, n));
    problem_(at.data(), residuals, jacobian);
    if (is_behind_pole()) residuals[0] = HUGE_VAL;
    Eigen::Map<Vector>(residuals, n + 1) /= residual_unit_;
    if (jacobian == nullptr) return;
    Eigen::Map<MatrixOf<double>> columns(jacobian, n + 1, n);
    for (Eigen::Index i = 0; i < n; ++i) columns.col(i) *= units_[i] / residual_unit_;
  }

  /// Whether the last parameters have a pole, if these descents keep from one.
  bool is_behind_pole() const {
    return barrier_ != nullptr && barrier_->has_pole(std::span<const double>(problem_.parameters()));
  }

  Projection problem_;
  const SampledStudy<double>* barrier_;
  mutable Vector residuals_;
  Vector units_;
  double residual_unit_;
  const Checkpoint& checkpoint_;
  double least_change_;  ///< of the square: a smaller one is left to Newton's method
  mutable std::vector<double> kept_ = {};
};

/// Places from elements `first` on of Halton's points. `unknowns` are the indices of the parameters that do
/// not enter linearly; `value` makes the value of one from its number in [0, 1).
template <class Value>
std::vector<Vector> halton_places(std::size_t first, std::size_t count,
                                  const std::vector<std::size_t>& unknowns, const Value& value) {
  std::vector<Vector> places(count, Vector(static_cast<Eigen::Index>(unknowns.size())));
  for (std::size_t n = 0; n < count; ++n) {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      places[n][static_cast<Eigen::Index>(i)] = value(unknowns[i], radical_inverse(first + n, primes[i]));
  }
  return places;
}

std::vector<Vector> starting_places(const SearchStarts& wanted, const std::vector<std::size_t>& unknowns) {
  std::vector<Vector> places = halton_places(
      wanted.first, wanted.count, unknowns, [&](std::size_t, double u) { return spread(u, wanted.octaves); });
  if (!wanted.units.empty())
    std::ranges::move(
        halton_places(wanted.first, wanted.count, unknowns,
                      [&](std::size_t i, double u) { return wanted.units[i] * spread(u, wanted.octaves); }),
        std::back_inserter(places));
  return places;
}

/// Starts with positions in their ranges: as many as they come, and as many that are the lowest of many more.
/// The lowest ones alone would lie in few basins.
std::vector<Vector> placed(const SearchStarts& wanted, const Descents& scan) {
  constexpr std::size_t looks = 24, each = 1 + looks;
  std::vector<Vector> places = halton_places(each * (wanted.first - 1) + 1, each * wanted.count,
                                             scan.unknowns(), [&](std::size_t i, double u) {
                                               const auto& range = wanted.ranges[i];
                                               return range ? std::lerp((*range)[0], (*range)[1], u)
                                                            : wanted.sizes[i] * spread(u, octaves_of_shading);
                                             });
  const auto as_they_come = places.begin() + static_cast<std::ptrdiff_t>(wanted.count);
  const std::vector<SearchedPlace> lowest = scan.all_at({as_they_come, places.end()});
  places.erase(as_they_come, places.end());
  for (std::size_t i = 0; i < std::min(wanted.count, lowest.size()); ++i) places.push_back(lowest[i].q);
  return places;
}

/// The better half of places that are sorted by square.
std::vector<SearchedPlace> lower_half(std::vector<SearchedPlace> places) {
  places.resize((places.size() + 1) / 2);
  return places;
}

/// Adds the lowest ends that are not near an earlier one: near ends are in the same basin.
void append_distinct(const std::vector<SearchedPlace>& ends, std::vector<SearchedPlace>& starts) {
  constexpr std::size_t most = 16;
  constexpr double near = 0.05;  // relative, in every parameter
  for (std::size_t i = 0; i < ends.size() && starts.size() < most; ++i) {
    const auto is_near = [&](const SearchedPlace& start) {
      return (start.q - ends[i].q).cwiseAbs().cwiseQuotient(ends[i].q.cwiseAbs()).maxCoeff() < near;
    };
    if (std::none_of(starts.begin(), starts.end(), is_near)) starts.push_back(ends[i]);
  }
}

/// Goes on until as many more starts as there were, at least 32, find nothing lower; at most 1024 in all.
template <class Search>
void search_on(SearchedStudy& searched, SearchStarts& wanted, const Search& search) {
  constexpr std::size_t least = 32, most = 1024;
  const std::size_t sets = wanted.sets();
  wanted.given.clear();
  for (bool is_lower = wanted.count > 0; is_lower;) {
    const auto so_far = static_cast<std::size_t>(searched.starts);
    wanted.first += wanted.count;
    wanted.count = std::min(std::max(least, so_far), most - std::min(most, so_far)) / sets;
    if (wanted.count == 0) return;
    std::vector<StudyCandidate> more = search();
    is_lower = !more.empty() && (searched.candidates.empty() || more.front().square * (1 + same_square) <
                                                                    searched.candidates.front().square);
    std::ranges::move(more, std::back_inserter(searched.candidates));
    std::ranges::stable_sort(searched.candidates, {}, &StudyCandidate::square);
    searched.starts += static_cast<int>(wanted.count * sets);
  }
}

bool is_inside(const std::vector<double>& parameters, const std::vector<std::array<double, 2>>& bounds) {
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (!(bounds[i][0] <= parameters[i] && parameters[i] <= bounds[i][1])) return false;
  return true;
}

/// The ends of descents, best first, without those that have a pole. `keeps_from_poles`: no step is taken to
/// a place with one.
std::vector<StudyCandidate> basins(const StudyError& error, const SampledStudy<double>& coarse,
                                   const SampledStudy<double>& sampled, const SearchStarts& wanted,
                                   const Checkpoint& checkpoint, bool keeps_from_poles) {
  // A few steps from the better half of the starts, some more from the better half of their ends, then many
  // from the lowest: most starts lead to the same few basins.
  constexpr int few = 3, some = 5, many = 100;
  const Descents problem(error, sampled, wanted.units, checkpoint, keeps_from_poles);
  std::vector<SearchedPlace> ends;
  if (problem.unknowns().empty()) {
    ends = problem.from({{Vector(0)}}, 0);
  } else {
    if (wanted.count > 0) {
      const Descents scan(error, coarse, wanted.units, checkpoint, keeps_from_poles);
      std::vector<Vector> places = starting_places(wanted, problem.unknowns());
      if (!wanted.ranges.empty()) std::ranges::move(placed(wanted, scan), std::back_inserter(places));
      for (Vector& place : places) {
        for (Eigen::Index i = 0; i < place.size() && !wanted.bounds.empty(); ++i)
          place[i] = folded(place[i], wanted.bounds[problem.unknowns()[static_cast<std::size_t>(i)]]);
      }
      ends = scan.all_at(places);
      for (const int steps : {few, some}) ends = scan.from(lower_half(ends), steps);
    }
    std::vector<SearchedPlace> starts;
    for (const std::vector<double>& start : wanted.given) starts.push_back({problem.unknowns_of(start)});
    append_distinct(ends, starts);
    ends = problem.from(starts, many);
  }
  std::vector<StudyCandidate> found;
  for (const SearchedPlace& end : ends) {
    const std::vector<double> parameters = problem.parameters_at(end.q);
    if (!sampled.has_pole(parameters)) found.push_back({parameters, end.square});
  }
  return found;
}

}  // namespace

std::vector<StudyCandidate> search_basins(const StudyError& error, const SampledStudy<double>& coarse,
                                          const SampledStudy<double>& sampled, const SearchStarts& starts,
                                          const Checkpoint& checkpoint) {
  // A long step may lead over a pole, to where the way down leads away from it.
  const auto found = basins(error, coarse, sampled, starts, checkpoint, false);
  return found.empty() ? basins(error, coarse, sampled, starts, checkpoint, true) : found;
}

std::size_t search_rule(const ReadStudy& study) {
  constexpr std::array<std::size_t, most_axes> rules{4, 1, 0};
  return rules[study.axes.size() - 1];
}

SearchedStudy search_study(const ReadStudy& study, const StudyError& error,
                           const std::vector<std::vector<StudyEdge>>& edges, const std::vector<Held>& starts,
                           const Checkpoint& checkpoint) {
  const bool has_finer_nodes = study.axes.size() == 1 && !study.rows && !moving_kinks(study).empty();
  // Between kinks that move, sums over few nodes have basins of their own.
  const std::size_t rule = has_finer_nodes ? fit_rules.size() - 1 : search_rule(study);
  const StudyNodes nodes = nodes_of(study, edges, fit_rules[rule]);
  const std::vector<double> target = require_values(study, nodes);
  require_dependence(study, error.is_open());
  const auto& linear = error.is_linear();
  const auto nonlinear = static_cast<std::size_t>(std::count(linear.begin(), linear.end(), false));
  SearchedStudy result{SampledStudy<double>(error, nodes), {}, 0, nonlinear == 0, study.rows != nullptr};
  SearchStarts wanted = search_starts(study, nonlinear, target, starts);
  // Fewer nodes, but still more than parameters, show the same basins.
  std::optional<SampledStudy<double>> coarse, some;
  if (nodes.rows && nonlinear > 0) some.emplace(error, thinned(study, most_searched));
  if (study.rows && nodes.size() > most_scanned) {
    coarse.emplace(error, thinned(study, most_scanned));
  } else if (wanted.count > 0 && nonlinear > 0 && study.axes.size() == 1 && !study.rows) {
    coarse.emplace(error, nodes_of(study, edges, fit_rules[has_finer_nodes ? search_rule(study) : 0]));
  }
  const auto search = [&] {
    const SampledStudy<double>& searched = some ? *some : result.sampled;
    return search_basins(error, coarse ? *coarse : searched, searched, wanted, checkpoint);
  };
  result.candidates = search();
  result.starts = static_cast<int>(wanted.sets() * wanted.count + (nonlinear == 0 ? 0 : wanted.given.size()));
  if (nonlinear > 0) search_on(result, wanted, search);
  if (some) {
    const auto places = perhaps_lowest(result.candidates, some->target_norm());
    result.candidates = search_basins(error, result.sampled, result.sampled,
                                      {.count = 0, .octaves = 0, .given = places}, checkpoint);
  }
  const auto is_out = [&](const StudyCandidate& end) { return !is_inside(end.parameters, wanted.bounds); };
  if (nonlinear > 0 && !std::ranges::all_of(result.candidates, is_out))
    std::erase_if(result.candidates, is_out);
  if (result.candidates.empty())
    throw UserError(
        "--form has a pole, or no finite value, from every start: give another by --start, for example --start " +
        study.parameters.front() + "=2");
  return result;
}

bool is_slower_wave(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double clear = 1e-3;
  const auto size_of = [](const auto& p) { return std::inner_product(p.begin(), p.end(), p.begin(), 0.0); };
  return size_of(a) < (1 - clear) * size_of(b);
}

std::vector<StudyCandidate> lowest_basins(const SearchedStudy& searched, std::size_t most) {
  std::vector<StudyCandidate> basins;
  for (const StudyCandidate& candidate : searched.candidates) {
    if (basins.empty() || candidate.square > basins.back().square * (1 + same_square)) {
      if (basins.size() == most) break;
      basins.push_back(candidate);
    } else if (searched.has_rows && is_slower_wave(candidate.parameters, basins.back().parameters)) {
      basins.back().parameters = candidate.parameters;
    }
  }
  return basins;
}

}  // namespace shadefit
