#include "fit/minimax.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <utility>

#include "fit/least_squares.hpp"

namespace shadefit {
namespace {

/// A step of this size, relative, is Newton's last: the next would be its square.
constexpr double last_step = 1e-7;
/// A multiplier below this holds nothing up.
constexpr double no_multiplier = 1e-9;

/// A place where a curve is extreme or held, with its value and the derivatives of that by the parameters.
struct Contact {
  Touch touch;
  SearchPlace place;
  bool is_tangent;  ///< value and gradient are those of the curve's slope into the domain
  double value;
  Unknowns gradient;
};

template <class T>
using Few = boost::container::small_vector<T, 24>;

double sign_of(Touch touch) {
  return touch == Touch::lowest || touch == Touch::at_least ? -1 : 1;
}

bool is_of_form(Touch touch) {
  return touch == Touch::at_most || touch == Touch::at_least;
}

/// The maximum of sign * curve between low and high, from s: Newton on its slope, kept within what is known
/// to hold the maximum.
double climb(const MinimaxCurve& curve, std::size_t panel, double low, double s, double high, double sign,
             const MinimaxParameters& p) {
  for (int i = 0; i < 12; ++i) {
    const Along at = curve.along({panel, s}, p);
    const double slope = sign * at.slope, curvature = sign * at.curvature;
    if (slope == 0 || !std::isfinite(slope)) return s;
    (slope > 0 ? low : high) = s;
    double next = curvature < 0 ? s - slope / curvature : high + low;
    if (!(low < next && next < high)) next = low + (high - low) / 2;
    const double step = std::abs(next - s);
    s = next;
    // The error of a step is of the order of its square, and the curve's that of the square of that.
    if (step < 1e-5) return s;
  }
  return s;
}

/// One exchange's knowledge of a problem at its parameters.
class Exchange {
 public:
  Exchange(const MinimaxProblem& problem, const MinimaxParameters& start) : problem_(problem) {
    result_.parameters = start;
    values_.resize(problem.places.size());
  }

  MinimaxOptimum solve() {
    find_tangents();
    if (can_be_exact() && descend()) settle();
    return std::move(result_);
  }

 private:
  std::size_t unknowns() const { return problem_.size + 1; }

  /// Whether the level counts on this side of the error: on one side only where the form has to keep to it.
  double share_of_level(Touch touch) const {
    if (touch == Touch::highest) return problem_.one_sided == Side::below ? 0 : 1;
    if (touch == Touch::lowest) return problem_.one_sided == Side::above ? 0 : 1;
    return 0;
  }
  double share_of_level(const Contact& c) const { return c.is_tangent ? 0 : share_of_level(c.touch); }

  const MinimaxCurve& curve_of(Touch touch) const {
    return is_of_form(touch) ? problem_.form : problem_.error;
  }

  bool fail(Status status, std::string why) {
    result_.status = status;
    result_.why = std::move(why);
    return false;
  }

  Contact contact(Touch touch, const SearchPlace& place, bool is_tangent = false) const {
    Contact c{touch, place, is_tangent, 0, {}};
    const MinimaxCurve& curve = curve_of(touch);
    c.value = (is_tangent ? curve.slope_across : curve.across)(place, result_.parameters, c.gradient);
    return c;
  }

  /// What the curve of a touch may at most (or at least) be, apart from the level.
  double bound_of(Touch touch) const {
    if (touch == Touch::at_most) return *problem_.at_most;
    return touch == Touch::at_least ? *problem_.at_least : 0;
  }

  /// By how much a step of the parameters and a level may use a condition up.
  Condition condition(const Contact& c) const {
    const double sign = sign_of(c.touch), bound = c.is_tangent ? 0 : bound_of(c.touch);
    Condition result{{}, sign * (bound - c.value), c.touch == Touch::exact};
    for (std::size_t i = 0; i < problem_.size; ++i) result.slope[i] = sign * c.gradient[i];
    result.slope[problem_.size] = -share_of_level(c);
    return result;
  }

  /// An end of the domain where a bounded curve is at its bound whatever the parameters: what they move there
  /// is its slope, and the bound is one on that.
  void find_tangents() {
    const auto consider = [&](Touch touch) {
      const SearchPlace ends[] = {problem_.places.front(), problem_.places.back()};
      for (const SearchPlace& place : ends) {
        const Contact c = contact(touch, place);
        const bool is_fixed =
            std::all_of(c.gradient.begin(), c.gradient.end(), [](double g) { return g == 0; });
        if (!is_fixed || c.value != bound_of(touch)) continue;
        const Contact tangent = contact(touch, place, true);
        if (std::any_of(tangent.gradient.begin(), tangent.gradient.end(), [](double g) { return g != 0; }))
          tangents_.push_back(tangent);
      }
    };
    if (problem_.one_sided) consider(problem_.one_sided == Side::below ? Touch::highest : Touch::lowest);
    if (problem_.at_most) consider(Touch::at_most);
    if (problem_.at_least) consider(Touch::at_least);
  }

  /// Constraints of interpolation: those that hold whatever the parameters are fall away; of the others
  /// Newton tells whether the form can meet them. exp(a) meets 0 for no a, and says so by steps that stay
  /// long.
  bool can_be_exact() {
    for (const SearchPlace& place : problem_.exact_at) {
      const MinimaxParameters start = result_.parameters;
      bool is_met = false;
      for (int i = 0; i < 60 && !is_met; ++i) {
        const Contact c = contact(Touch::exact, place);
        double square = 0;
        for (std::size_t j = 0; j < problem_.size; ++j) {
          const double scaled = c.gradient[j] * result_.parameters[j];
          square += scaled * scaled;
        }
        if (i == 0 && c.value == 0 && square == 0) break;  // met by itself
        if (!(square > 0) || !std::isfinite(square)) i = 60;
        const double step = -c.value / square;
        double largest = 0;
        for (std::size_t j = 0; j < problem_.size && i < 60; ++j) {
          const double relative = step * c.gradient[j] * result_.parameters[j];
          largest = std::max(largest, std::abs(relative));
          result_.parameters[j] *= 1 + relative;
        }
        is_met = i < 60 && largest < 1e-10;
        if (i >= 59 && !is_met)
          return fail(Status::infeasible,
                      "the form cannot be exact at c = " + to_text(problem_.cosine_at(place).cos_theta));
      }
      if (is_met) exact_.push_back(place);
      result_.parameters = start;
    }
    if (exact_.size() > problem_.size)
      return fail(Status::infeasible, "more places to be exact at than free parameters");
    return true;
  }

  /// The extrema of a curve that a touch speaks of: maxima for `highest` and `at_most`, else minima.
  void find_extrema(const MinimaxCurve& curve, Touch touch) {
    const double sign = sign_of(touch);
    const auto& places = problem_.places;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const bool has_left = i > 0 && places[i - 1].panel == places[i].panel;
      const bool has_right = i + 1 < places.size() && places[i + 1].panel == places[i].panel;
      const double left = has_left ? sign * (values_[i] - values_[i - 1]) : 0;
      const double right = has_right ? sign * (values_[i] - values_[i + 1]) : 0;
      if (left < 0 || right < 0) continue;
      SearchPlace place = places[i];
      if (has_left && has_right) {
        // the top of the parabola through three places, in divided differences
        const double a = places[i - 1].s, b = places[i].s, c = places[i + 1].s;
        const double rise = left / (b - a), fall = right / (c - b);
        const double bend = rise + fall;
        const double top = bend > 0 ? (a + b) / 2 + (c - a) / 2 * rise / bend : b;
        place.s = climb(curve, place.panel, a, std::clamp(top, a, c), c, sign, result_.parameters);
      } else if (has_left != has_right) {
        // An end of a panel is an extremum unless the curve still rises from it.
        const double inner = has_right ? places[i + 1].s : places[i - 1].s;
        const double slope = sign * curve.along(place, result_.parameters).slope * (inner - place.s);
        if (slope > 0) {
          const double low = std::min(inner, place.s), high = std::max(inner, place.s);
          place.s = climb(curve, place.panel, low, (low + high) / 2, high, sign, result_.parameters);
        }
      }
      contacts_.push_back(contact(touch, place));
    }
  }

  /// All extrema at the parameters, their level, and by how much constraints are violated.
  void look() {
    contacts_.clear();
    problem_.error.everywhere(result_.parameters, values_);
    find_extrema(problem_.error, Touch::highest);
    find_extrema(problem_.error, Touch::lowest);
    if (problem_.at_most || problem_.at_least) {
      problem_.form.everywhere(result_.parameters, values_);
      if (problem_.at_most) find_extrema(problem_.form, Touch::at_most);
      if (problem_.at_least) find_extrema(problem_.form, Touch::at_least);
    }
    for (const SearchPlace& place : exact_) contacts_.push_back(contact(Touch::exact, place));
    for (const Contact& c : tangents_) contacts_.push_back(contact(c.touch, c.place, true));

    level_ = violation_ = 0;
    bool is_finite = true;
    for (const Contact& c : contacts_) {
      const double excess = -condition(c).bound;
      is_finite = is_finite && std::isfinite(excess);
      if (share_of_level(c) > 0) {
        level_ = std::max(level_, excess);
      } else {
        violation_ += c.touch == Touch::exact ? std::abs(excess) : std::max(0.0, excess);
      }
    }
    if (!is_finite) level_ = HUGE_VAL;
  }

  /// The level, and more for a violation than it could gain.
  double merit() const { return level_ + penalty_ * violation_; }

  /// The extrema of the error with alternating signs, the largest of each run, no more than `count`; filled
  /// up with places of the search.
  Few<Contact> alternating(std::size_t count) const {
    Few<Contact> found;
    double largest_gradient = 0, highest = -HUGE_VAL, lowest = HUGE_VAL;
    const auto size_of = [&](const Contact& c) {
      double size = 0;
      for (std::size_t i = 0; i < problem_.size; ++i) size = std::max(size, std::abs(c.gradient[i]));
      return size;
    };
    for (const Contact& c : contacts_) {
      if (is_of_form(c.touch) || c.touch == Touch::exact || c.is_tangent) continue;
      largest_gradient = std::max(largest_gradient, size_of(c));
      highest = std::max(highest, c.value);
      lowest = std::min(lowest, c.value);
      found.push_back(c);
    }
    // Where no parameter moves the error, as where every form of a family meets the target, nothing can be
    // levelled.
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const Contact& c) { return !(size_of(c) > 1e-9 * largest_gradient); }),
                found.end());
    const double middle = problem_.one_sided ? (highest + lowest) / 2 : 0;
    const auto height = [&](const Contact& c) { return c.value - middle; };
    std::sort(found.begin(), found.end(), [](const Contact& a, const Contact& b) {
      return std::pair(a.place.panel, a.place.s) < std::pair(b.place.panel, b.place.s);
    });
    Few<Contact> chain;
    for (const Contact& c : found) {
      const bool is_same_run = !chain.empty() && (height(chain.back()) < 0) == (height(c) < 0);
      if (!is_same_run) {
        chain.push_back(c);
      } else if (std::abs(height(c)) > std::abs(height(chain.back()))) {
        chain.back() = c;
      }
    }
    while (chain.size() > count)
      chain.erase(std::abs(height(chain.front())) < std::abs(height(chain.back())) ? chain.begin()
                                                                                   : chain.end() - 1);
    const std::size_t all = problem_.places.size();
    for (std::size_t i = 0; chain.size() < count && i < count; ++i) {
      const SearchPlace place = problem_.places[(2 * i + 1) * all / (2 * count)];
      chain.push_back(contact(Touch::highest, place));
    }
    return chain;
  }

  /// A reference of conditions on the error that no step can lower together: any n + 1 places, each with the
  /// sign that its share in a combination without slope has.
  bool first_reference(Few<Condition>& conditions, std::array<std::size_t, most_unknowns>& reference) {
    const std::size_t count = unknowns() - exact_.size();
    const auto chain = alternating(count);
    SmallMatrix matrix{}, inverse{};
    for (std::size_t i = 0; i < count; ++i) {
      matrix[i] = chain[i].gradient;
      matrix[i][problem_.size] = i % 2 == 0 ? 1 : -1;
    }
    std::size_t next = count;
    for (std::size_t j = 0; j < contacts_.size(); ++j) {
      if (contacts_[j].touch != Touch::exact) continue;
      reference[next] = j;
      matrix[next] = contacts_[j].gradient;
      matrix[next++][problem_.size] = 0;
    }
    if (!invert(matrix, unknowns(), inverse)) return false;
    const Unknowns& shares = inverse[problem_.size];
    double above = 0, below = 0;
    for (std::size_t i = 0; i < count; ++i) (shares[i] > 0 ? above : below) += std::abs(shares[i]);
    const double weight = above * share_of_level(Touch::highest) + below * share_of_level(Touch::lowest);
    const double flip = weight > 0 ? 1 : -1;
    for (std::size_t i = 0; i < count; ++i) {
      Contact c = chain[i];
      c.touch = flip * shares[i] > 0 ? Touch::highest : Touch::lowest;
      reference[i] = conditions.size();
      conditions.push_back(condition(c));
      contacts_.push_back(c);
    }
    return true;
  }

  /// From extrema to the step of their linear programme and back, until the step is Newton's last. A step
  /// that does not lower the merit is halved.
  bool descend() {
    MinimaxParameters base = result_.parameters, step{};
    double best = HUGE_VAL, scale = 1, size = 1;
    for (; result_.iterations < most_steps; ++result_.iterations) {
      look();
      if (!(merit() < best)) {
        if (result_.iterations == 0) return fail(Status::not_finite, "the error at the start is not finite");
        scale /= 2;
        if (scale < 1e-3) return stall(best, size) && go_to(base, step);
        for (std::size_t i = 0; i < problem_.size; ++i) result_.parameters[i] = base[i] + scale * step[i];
        continue;
      }
      Few<Condition> conditions;
      for (const Contact& c : contacts_) conditions.push_back(condition(c));
      std::array<std::size_t, most_unknowns> reference{};
      if (!first_reference(conditions, reference))
        return fail(Status::degenerate,
                    "the parameters do not move the error independently where it is largest");
      const LowestLevel lowest =
          lowest_level({conditions.data(), conditions.size()}, unknowns(), {reference.data(), unknowns()});
      if (lowest.outcome == LowestLevel::Outcome::infeasible)
        return fail(Status::infeasible, "no parameters near least squares " + most_violated());
      if (lowest.outcome == LowestLevel::Outcome::degenerate)
        return fail(Status::degenerate,
                    "the parameters do not move the error independently where it is largest");
      if (lowest.outcome == LowestLevel::Outcome::unfinished)
        return fail(Status::not_converged, "the exchange of the reference goes round in circles");

      reference_.clear();
      double held_up = 0;
      for (std::size_t i = 0; i < unknowns(); ++i) {
        reference_.push_back(contacts_[lowest.reference[i]]);
        multipliers_[i] = lowest.multipliers[i];
        if (share_of_level(reference_.back()) == 0) held_up += std::abs(multipliers_[i]);
      }
      penalty_ = std::max(penalty_, 2 * held_up + 1);
      base = result_.parameters;
      best = merit();
      scale = 1;
      size = 0;
      for (std::size_t i = 0; i < problem_.size; ++i) {
        step[i] = lowest.unknowns[i];
        if (!std::isfinite(step[i])) return fail(Status::not_finite, "a step is not finite");
        if (step[i] != 0) size = std::max(size, std::abs(step[i] / base[i]));
      }
      expected_ = lowest.unknowns[problem_.size];
      go_to(base, step);
      if (size < last_step) {
        ++result_.iterations;
        return true;
      }
    }
    return fail(Status::not_converged,
                "the alternation did not settle in " + std::to_string(most_steps) + " exchanges");
  }

  /// The constraint that the parameters violate most, and where.
  std::string most_violated() const {
    const Contact* worst = nullptr;
    double most = 0;
    for (const Contact& c : contacts_) {
      const double excess = -condition(c).bound;
      if (share_of_level(c) > 0 || !(excess > most)) continue;
      most = excess;
      worst = &c;
    }
    if (worst == nullptr) return "satisfy the constraints";
    const std::string relation = sign_of(worst->touch) > 0 ? "<= " : ">= ";
    const std::string bound = is_of_form(worst->touch) ? to_text(bound_of(worst->touch)) : "target";
    return "keep the form " + relation + bound + " at c = " + place_text(*worst);
  }

  std::string place_text(const Contact& c) const { return to_text(problem_.cosine_at(c.place).cos_theta); }

  bool go_to(const MinimaxParameters& base, const MinimaxParameters& step) {
    for (std::size_t i = 0; i < problem_.size; ++i) result_.parameters[i] = base[i] + step[i];
    return true;
  }

  /// No part of a step lowers the level any more, and yet it is no last step. Where it is short, the level is
  /// down to its rounding, and Newton may have it; else the level does not tell where the parameters are.
  bool stall(double best, double size) {
    if (best - expected_ >= 1e-9 * best)
      return fail(Status::not_converged, "no part of the exchange's step lowers the largest error");
    if (size < 1e-4) return true;
    return fail(Status::degenerate, "the level is as low as it gets, but fewer than " +
                                        std::to_string(unknowns()) +
                                        " places hold it there: the parameters are not determined");
  }

  /// Newton on the equations of the reference, their residuals in long double, until a step is nothing.
  void settle() {
    for (std::size_t i = 0; i < unknowns(); ++i) {
      if (reference_[i].touch != Touch::exact && !(multipliers_[i] > no_multiplier)) {
        fail(Status::degenerate,
             "the alternation is degenerate: of its " + std::to_string(unknowns()) + " places that at c = " +
                 to_text(problem_.cosine_at(reference_[i].place).cos_theta) + " holds nothing up");
        return;
      }
    }
    long double size = 0;
    // One pass is the rule, and a second confirms it.
    for (int pass = 0; pass < 5; ++pass) {
      SmallMatrix matrix{}, inverse{};
      WideParameters wide{};
      std::copy(result_.parameters.begin(), result_.parameters.end(), wide.begin());
      std::array<long double, most_unknowns> values{};
      long double level = 0;
      for (std::size_t i = 0; i < unknowns(); ++i) {
        Contact& c = reference_[i];
        const MinimaxCurve& curve = curve_of(c.touch);
        if (c.touch != Touch::exact && 0 < c.place.s && c.place.s < 1)
          c.place.s = climb(curve, c.place.panel, std::max(0.0, c.place.s - 0.01), c.place.s,
                            std::min(1.0, c.place.s + 0.01), sign_of(c.touch), result_.parameters);
        c = contact(c.touch, c.place, c.is_tangent);
        matrix[i] = condition(c).slope;
        values[i] = (c.is_tangent ? curve.wide_slope : curve.wide)(c.place, wide);
        level += static_cast<long double>(multipliers_[i] * share_of_level(c) * sign_of(c.touch)) * values[i];
      }
      if (!invert(matrix, unknowns(), inverse)) {
        fail(Status::degenerate, "the equations of the alternation are not independent");
        return;
      }
      // What each equation lacks at this level.
      std::array<long double, most_unknowns> lack{};
      for (std::size_t i = 0; i < unknowns(); ++i) {
        Contact& c = reference_[i];
        const auto sign = static_cast<long double>(sign_of(c.touch));
        const auto bound = static_cast<long double>(c.is_tangent ? 0 : bound_of(c.touch));
        lack[i] = sign * (bound - values[i]) + static_cast<long double>(share_of_level(c)) * level;
        const bool is_error = !c.is_tangent && !is_of_form(c.touch);
        c.value = static_cast<double>(is_error ? values[i] : problem_.error.wide(c.place, wide));
      }
      std::array<long double, most_unknowns> step{};
      for (std::size_t i = 0; i < unknowns(); ++i) {
        for (std::size_t j = 0; j < unknowns(); ++j)
          step[i] += static_cast<long double>(inverse[i][j]) * lack[j];
      }
      result_.level = static_cast<double>(level + step[problem_.size]);
      size = 0;
      for (std::size_t i = 0; i < problem_.size; ++i) {
        if (step[i] != 0) size = std::max(size, std::abs(step[i] / wide[i]));
      }
      result_.digits = correct_digits(size);
      // Half a unit in the last place of a double is 1.1e-16; a step above a few of these is worth taking
      // once.
      if (size <= static_cast<long double>(pass == 0 ? 3e-16 : settled)) {
        result_.status = Status::converged;
        record();
        return;
      }
      for (std::size_t i = 0; i < problem_.size; ++i)
        result_.parameters[i] = static_cast<double>(wide[i] + step[i]);
      ++result_.iterations;
    }
    fail(Status::not_converged, "Newton's last step is still " + to_text(static_cast<double>(size)) +
                                    " of a parameter: the problem has no 14 digits in this arithmetic");
  }

  void record() {
    for (std::size_t i = 0; i < unknowns(); ++i) {
      const Contact& c = reference_[i];
      result_.alternation.push_back(
          {c.touch, c.is_tangent, problem_.cosine_at(c.place), c.value, multipliers_[i]});
    }
    std::sort(result_.alternation.begin(), result_.alternation.end(),
              [](const AlternationPoint& a, const AlternationPoint& b) {
                return a.at.one_minus_cos < b.at.one_minus_cos;
              });
  }

  const MinimaxProblem& problem_;
  MinimaxOptimum result_;
  std::vector<double> values_;
  std::vector<SearchPlace> exact_;  ///< of the problem's, those that are not met by themselves
  Few<Contact> contacts_, reference_, tangents_;
  Unknowns multipliers_{};
  double level_ = 0, violation_ = 0, penalty_ = 1;
  double expected_ = 0;  ///< the level that the last programme promised
};

}  // namespace

MinimaxOptimum solve_minimax(const MinimaxProblem& problem, const MinimaxParameters& start) {
  return Exchange(problem, start).solve();
}

}  // namespace shadefit
