#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fit/panels/minimax.hpp"
#include "fit/steps/alternation.hpp"
#include "fit/steps/linear_programme.hpp"

/// The places where the curves of a minimax problem are extreme or constrained, at given parameters. The
/// exchange swaps these.
namespace shadefit {

/// A place where a curve is extreme or constrained, with its value and the derivatives of the value by the
/// parameters.
struct Contact {
  Touch touch;
  SearchPlace place;
  bool is_tangent;  ///< value and gradient are those of the curve's slope into the domain
  double value;
  Unknowns gradient;
};

/// The usual number for four parameters needs no heap.
template <class T>
using Few = boost::container::small_vector<T, 24>;

/// 1 where a touch bounds its curve from above, -1 from below.
inline double sign_of(Touch touch) {
  return touch == Touch::lowest || touch == Touch::at_least || touch == Touch::rises ? -1 : 1;
}

/// Whether a touch bounds the form itself, not its error.
inline bool is_of_form(Touch touch) {
  return touch == Touch::at_most || touch == Touch::at_least;
}

/// Whether a touch bounds the slope of the form.
inline bool is_of_slope(Touch touch) {
  return touch == Touch::falls || touch == Touch::rises;
}

class Contacts {
 public:
  Contacts(const MinimaxProblem& problem, const MinimaxParameters& start)
      : parameters(start), problem_(problem), values_(problem.places.size()) {}

  MinimaxParameters parameters;  ///< at which all curves are evaluated

  /// The parameters and the level.
  std::size_t unknowns() const { return problem_.size + 1; }
  const Few<Contact>& all() const { return all_; }
  /// Of the last evaluation: the largest error that counts for the level, infinite if the parameters are not
  /// admissible, and the sum of all violations.
  double level() const { return level_; }
  double violation() const { return violation_; }

  double share_of_level(Touch touch) const;
  /// How a one-sided form touches its target.
  Touch one_sided_touch() const { return problem_.one_sided == Side::below ? Touch::highest : Touch::lowest; }
  Touch slope_touch() const { return problem_.monotone == Course::falls ? Touch::falls : Touch::rises; }
  double share_of_level(const Contact& c) const { return c.is_tangent ? 0 : share_of_level(c.touch); }
  PanelCurve& curve_of(Touch touch) const;
  long double bound_of(Touch touch) const;
  /// Whether a constraint is violated infinitely: the target or a bound of a positive form is 0 there.
  bool is_impossible() const { return violation_ == HUGE_VAL; }
  Contact contact(Touch touch, const SearchPlace& place, bool is_tangent = false) const;
  /// The contact at the present parameters. Inside a panel its place moves to the extremum.
  Contact moved(const Contact& c) const;
  Condition condition(const Contact& c) const;

  void find_tangents();
  /// From now on the form equals its target at the problem's places. A place where it does so for all
  /// parameters is left out. A line that says why the form cannot, or an empty text.
  std::string hold_exact();
  void look();

  /// False if the parameters do not move the error independently. Adds the same to the contacts and to the
  /// conditions.
  bool first_reference(Few<Condition>& conditions, std::array<std::size_t, most_unknowns>& reference);
  std::string most_violated() const;
  /// Whether a constraint is violated where no parameter moves its curve.
  bool is_violation_fixed() const;
  /// "x = 0.5"
  std::string place_text(const SearchPlace& place) const;

 private:
  enum class CanBe { exact, exact_for_all, never };
  /// By Newton's method: if no parameters make the form exact, as for exp(a) = 0, its steps stay long.
  /// Changes the parameters.
  CanBe can_be_exact(const SearchPlace& place);
  const Contact* worst_violation() const;
  void find_extrema(PanelCurve& curve, Touch touch);
  void sample(PanelCurve& curve);
  /// A chain of contacts, and the place in it where those that come first begin.
  struct Chain {
    Few<Contact> contacts;
    std::size_t first = 0;
  };
  Chain alternating(std::size_t count) const;
  bool refer_to(std::span<const Contact> chain, Few<Condition>& conditions,
                std::array<std::size_t, most_unknowns>& reference);

  const MinimaxProblem& problem_;
  std::vector<double> values_;      ///< of a curve at the search places
  std::vector<SearchPlace> exact_;  ///< those of the problem that do not hold for all parameters
  Few<Contact> all_, tangents_;
  double level_ = 0, violation_ = 0;
};

}  // namespace shadefit
