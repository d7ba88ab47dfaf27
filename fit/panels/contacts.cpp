#include "fit/panels/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/panels/panel_curve.hpp"

namespace shadefit {
namespace {

/// Whether no parameter moves the value of a contact.
bool is_fixed(const Contact& c) {
  return std::ranges::all_of(c.gradient, [](double g) { return g == 0; });
}

/// The maximum of sign * curve between low and high, from s: Newton on the slope, inside the interval that is
/// known to contain the maximum.
double climb(PanelCurve& curve, std::size_t panel, double low, double s, double high, double sign,
             const MinimaxParameters& p) {
  for (int i = 0; i < 12; ++i) {
    const Along at = curve.along({panel, s}, p);
    const double slope = sign * at.slope, curvature = sign * at.curvature;
    if (slope == 0 || !std::isfinite(slope)) return s;
    // At the extremum, to rounding: a bracket that begins at it would lead away.
    constexpr double rounding = 1e-12;
    if (curvature < 0 && -std::abs(slope) > rounding * curvature)
      return std::clamp(s - slope / curvature, low, high);
    (slope > 0 ? low : high) = s;
    double next = curvature < 0 ? s - slope / curvature : high + low;
    if (!(low < next && next < high)) next = low + (high - low) / 2;
    const double step = std::abs(next - s);
    s = next;
    // A step's error is of the order of its square; the error of the curve's value is the square of that.
    if (step < 1e-5) return s;
  }
  return s;
}

}  // namespace

/// Whether the level limits this side of the error. A one-sided form has its level on one side only.
double Contacts::share_of_level(Touch touch) const {
  if (touch == Touch::highest) return problem_.one_sided == Side::below ? 0 : 1;
  if (touch == Touch::lowest) return problem_.one_sided == Side::above ? 0 : 1;
  return 0;
}

PanelCurve& Contacts::curve_of(Touch touch) const {
  if (is_of_form(touch)) return *problem_.bounded;
  if (is_of_slope(touch)) return *problem_.sloping;
  return share_of_level(touch) > 0 ? *problem_.error : *problem_.deviation;
}

Contact Contacts::contact(Touch touch, const SearchPlace& place, bool is_tangent) const {
  Contact c{touch, place, is_tangent, 0, {}};
  c.value = curve_of(touch).across(place, parameters, is_tangent, c.gradient);
  return c;
}

Contact Contacts::moved(const Contact& c) const {
  SearchPlace place = c.place;
  if (c.touch != Touch::exact && 0 < place.s && place.s < 1)
    place.s = climb(curve_of(c.touch), place.panel, std::max(0.0, place.s - 0.01), place.s,
                    std::min(1.0, place.s + 0.01), sign_of(c.touch), parameters);
  return contact(c.touch, place, c.is_tangent);
}

/// The bound of a touch's curve, without the level.
long double Contacts::bound_of(Touch touch) const {
  if (!is_of_form(touch)) return 0;
  const long double bound = touch == Touch::at_most ? *problem_.at_most : *problem_.at_least;
  return problem_.is_exponential ? std::log(std::max(0.0L, bound)) : bound;
}

/// How far a step of the parameters and a level may go before they violate a condition.
Condition Contacts::condition(const Contact& c) const {
  const double sign = sign_of(c.touch);
  const double bound = c.is_tangent ? 0 : static_cast<double>(bound_of(c.touch));
  Condition result{{}, sign * (bound - c.value), c.touch == Touch::exact};
  for (std::size_t i = 0; i < problem_.size; ++i) result.slope[i] = sign * c.gradient[i];
  result.slope[problem_.size] = -share_of_level(c);
  return result;
}

/// An end of the domain where a bounded curve is at its bound for all parameters, or by the constraint to be
/// exact. They change only its slope there, so the slope is bounded.
void Contacts::find_tangents() {
  const auto consider = [&](Touch touch) {
    const SearchPlace ends[] = {problem_.places.front(), problem_.places.back()};
    for (const SearchPlace& place : ends) {
      const Contact c = contact(touch, place);
      const bool is_exact =
          !is_of_form(touch) && !is_of_slope(touch) && std::ranges::count(exact_, place) > 0;
      if (!is_exact && (!is_fixed(c) || c.value != static_cast<double>(bound_of(touch)))) continue;
      const Contact tangent = contact(touch, place, true);
      if (!is_fixed(tangent)) tangents_.push_back(tangent);
    }
  };
  if (problem_.one_sided) consider(one_sided_touch());
  if (problem_.at_most) consider(Touch::at_most);
  if (problem_.at_least) consider(Touch::at_least);
  if (problem_.monotone) consider(slope_touch());
}

Contacts::CanBe Contacts::can_be_exact(const SearchPlace& place) {
  constexpr int most_newton_steps = 60;
  // Where a power of a parameter is the value, it falls in each step and never becomes 0.
  constexpr double nothing = 1e-30;
  // A step is relative to the parameters of the start: one that is relative to the last ones changes no sign.
  const MinimaxParameters scale = parameters;
  double first = 0;
  for (int i = 0; i < most_newton_steps; ++i) {
    const Contact c = contact(Touch::exact, place);
    if (i == 0) first = std::abs(c.value);
    if (i > 0 && std::abs(c.value) < nothing * first) return CanBe::exact;
    double square = 0;
    for (std::size_t j = 0; j < problem_.size; ++j) {
      const double scaled = c.gradient[j] * scale[j];
      square += scaled * scaled;
    }
    const auto finer =
        static_cast<double>(curve_of(Touch::exact).wide(place, {parameters.begin(), parameters.end()}));
    // 0, or the rounding of 0: sin(pi x) at 1.
    if (std::abs(c.value) <= 2 * std::abs(c.value - finer))
      return i > 0 || square > 0 ? CanBe::exact : CanBe::exact_for_all;
    if (!(square > 0) || !std::isfinite(square)) return CanBe::never;
    const double step = -c.value / square;
    double largest = 0;
    for (std::size_t j = 0; j < problem_.size; ++j) {
      const double relative = step * c.gradient[j] * scale[j];
      largest = std::max(largest, std::abs(relative));
      parameters[j] += relative * scale[j];
    }
    if (largest < 1e-10) return CanBe::exact;
  }
  return CanBe::never;
}

std::string Contacts::hold_exact() {
  for (const SearchPlace& place : problem_.exact_at) {
    const MinimaxParameters start = parameters;
    const CanBe found = can_be_exact(place);
    parameters = start;
    if (found == CanBe::never) return "the form cannot be exact at " + place_text(place);
    if (found == CanBe::exact) exact_.push_back(place);
  }
  return exact_.size() > problem_.size ? "more places to be exact at than free parameters" : "";
}

/// A curve at the search places.
void Contacts::sample(PanelCurve& curve) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = curve.value(problem_.places[i], parameters);
}

/// The extrema of a curve that a touch needs: maxima if it bounds from above, else minima.
void Contacts::find_extrema(PanelCurve& curve, Touch touch) {
  const double sign = sign_of(touch);
  const auto& places = problem_.places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool has_left = i > 0 && places[i - 1].panel == places[i].panel;
    const bool has_right = i + 1 < places.size() && places[i + 1].panel == places[i].panel;
    const double left = has_left ? sign * (values_[i] - values_[i - 1]) : 0;
    const double right = has_right ? sign * (values_[i] - values_[i + 1]) : 0;
    if (left < 0 || right < 0) continue;
    if (sign * values_[i] == -HUGE_VAL) continue;  // where a target is 0 no positive form falls below it
    SearchPlace place = places[i];
    if (has_left && has_right) {
      // the top of the parabola through three places, in divided differences
      const double a = places[i - 1].s, b = places[i].s, c = places[i + 1].s;
      const double rise = left / (b - a), fall = right / (c - b);
      const double bend = rise + fall;
      const double top = bend > 0 ? (a + b) / 2 + (c - a) / 2 * rise / bend : b;
      place.s = climb(curve, place.panel, a, std::clamp(top, a, c), c, sign, parameters);
    } else if (has_left != has_right && std::isfinite(values_[i])) {
      // An end of a panel is an extremum unless the curve still rises from it.
      const double inner = has_right ? places[i + 1].s : places[i - 1].s;
      const double slope = sign * curve.along(place, parameters).slope * (inner - place.s);
      if (slope > 0) {
        const double low = std::min(inner, place.s), high = std::max(inner, place.s);
        place.s = climb(curve, place.panel, low, (low + high) / 2, high, sign, parameters);
      }
    }
    all_.push_back(contact(touch, place));
  }
}

/// All extrema at the parameters, their level, and the violation of the constraints.
void Contacts::look() {
  all_.clear();
  if (!problem_.is_admissible(parameters)) {
    level_ = HUGE_VAL;
    return;
  }
  sample(*problem_.error);
  if (problem_.one_sided != Side::below) find_extrema(*problem_.error, Touch::highest);
  if (problem_.one_sided != Side::above) find_extrema(*problem_.error, Touch::lowest);
  if (problem_.one_sided) {
    sample(*problem_.deviation);
    find_extrema(*problem_.deviation, one_sided_touch());
  }
  if (problem_.at_most || problem_.at_least) {
    sample(*problem_.bounded);
    if (problem_.at_most) find_extrema(*problem_.bounded, Touch::at_most);
    if (problem_.at_least) find_extrema(*problem_.bounded, Touch::at_least);
  }
  if (problem_.monotone) {
    sample(*problem_.sloping);
    find_extrema(*problem_.sloping, slope_touch());
  }
  for (const SearchPlace& place : exact_) all_.push_back(contact(Touch::exact, place));
  for (const Contact& c : tangents_) all_.push_back(contact(c.touch, c.place, true));

  level_ = violation_ = 0;
  bool is_finite = true;
  for (const Contact& c : all_) {
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

/// The extrema of the error with alternating signs, the largest of each run of equal signs. Of `count`
/// neighbours those come first that are left if the smaller end is dropped again and again. If there are
/// fewer, places of the search fill the rest.
Contacts::Chain Contacts::alternating(std::size_t count) const {
  Few<Contact> found;
  double largest_gradient = 0, highest = -HUGE_VAL, lowest = HUGE_VAL;
  const auto size_of = [&](const Contact& c) {
    double size = 0;
    for (std::size_t i = 0; i < problem_.size; ++i) size = std::max(size, std::abs(c.gradient[i]));
    return size;
  };
  for (Contact c : all_) {
    if (is_of_form(c.touch) || is_of_slope(c.touch) || c.touch == Touch::exact || c.is_tangent) continue;
    if (problem_.one_sided) {
      // A place where no positive form can touch its target holds nothing.
      if (!std::isfinite(contact(one_sided_touch(), c.place).value)) continue;
      c.value = problem_.error->across(c.place, parameters, false, c.gradient);
    }
    largest_gradient = std::max(largest_gradient, size_of(c));
    highest = std::max(highest, c.value);
    lowest = std::min(lowest, c.value);
    found.push_back(c);
  }
  // If no parameter moves the error, because every form of the family meets the target, there is nothing to
  // level.
  const auto is_unmoved = [&](const Contact& c) { return !(size_of(c) > 1e-9 * largest_gradient); };
  found.erase(std::remove_if(found.begin(), found.end(), is_unmoved), found.end());
  const double middle = problem_.one_sided ? (highest + lowest) / 2 : 0;
  const auto height = [&](const Contact& c) { return c.value - middle; };
  std::ranges::sort(found, {}, [](const Contact& c) { return std::pair(c.place.panel, c.place.s); });
  Few<Contact> chain;
  for (const Contact& c : found) {
    const bool is_same_run = !chain.empty() && (height(chain.back()) < 0) == (height(c) < 0);
    if (!is_same_run) {
      chain.push_back(c);
    } else if (std::abs(height(c)) > std::abs(height(chain.back()))) {
      chain.back() = c;
    }
  }
  std::size_t first = 0, last = chain.size();
  while (last - first > count) {
    if (std::abs(height(chain[first])) < std::abs(height(chain[last - 1]))) {
      ++first;
    } else {
      --last;
    }
  }
  const std::size_t all = problem_.places.size();
  for (std::size_t i = 0; chain.size() < count && i < count; ++i) {
    Contact c{Touch::highest, problem_.places[(2 * i + 1) * all / (2 * count)], false, 0, {}};
    c.value = problem_.error->across(c.place, parameters, false, c.gradient);
    chain.push_back(c);
  }
  return {chain, first};
}

/// Neighbours in the alternation. Where the error is symmetric, those around its middle depend on each other,
/// and those of one half do not.
bool Contacts::first_reference(Few<Condition>& conditions,
                               std::array<std::size_t, most_unknowns>& reference) {
  const std::size_t count = unknowns() - exact_.size();
  const auto [contacts, first] = alternating(count);
  const std::span<const Contact> chain(contacts.data(), contacts.size());
  if (refer_to(chain.subspan(first, count), conditions, reference)) return true;
  for (std::size_t i = 0; i + count <= chain.size(); ++i) {
    if (i != first && refer_to(chain.subspan(i, count), conditions, reference)) return true;
  }
  return false;
}

/// A reference: conditions on the error that no step can lower together. Any n + 1 places will do, each with
/// the sign of its share in a combination without slope. False if they depend on each other.
bool Contacts::refer_to(std::span<const Contact> chain, Few<Condition>& conditions,
                        std::array<std::size_t, most_unknowns>& reference) {
  const std::size_t count = chain.size();
  SmallMatrix matrix{}, inverse{};
  for (std::size_t i = 0; i < count; ++i) {
    matrix[i] = chain[i].gradient;
    matrix[i][problem_.size] = i % 2 == 0 ? 1 : -1;
  }
  std::size_t next = count;
  for (std::size_t j = 0; j < all_.size(); ++j) {
    if (all_[j].touch != Touch::exact) continue;
    reference[next] = j;
    matrix[next] = all_[j].gradient;
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
    if (share_of_level(c) == 0) c = contact(c.touch, c.place);
    reference[i] = conditions.size();
    conditions.push_back(condition(c));
    all_.push_back(c);
  }
  return true;
}

/// A fixed one outweighs all others.
const Contact* Contacts::worst_violation() const {
  const Contact* worst = nullptr;
  std::pair<bool, double> most{false, 0};
  for (const Contact& c : all_) {
    const std::pair<bool, double> violation{is_fixed(c), -condition(c).bound};
    if (share_of_level(c) > 0 || !(violation.second > 0) || !(violation > most)) continue;
    most = violation;
    worst = &c;
  }
  return worst;
}

bool Contacts::is_violation_fixed() const {
  const Contact* worst = worst_violation();
  return worst != nullptr && is_fixed(*worst);
}

/// The constraint that the parameters violate most, and its place.
std::string Contacts::most_violated() const {
  const Contact* worst = worst_violation();
  if (worst == nullptr) return "satisfy the constraints";
  if (is_of_slope(worst->touch)) {
    const std::string course = worst->touch == Touch::rises ? "rising" : "falling";
    return "keep the form " + course + " at " + place_text(worst->place);
  }
  const std::string relation = sign_of(worst->touch) > 0 ? "<= " : ">= ";
  const std::string bound = worst->touch == Touch::at_most    ? to_text(*problem_.at_most)
                            : worst->touch == Touch::at_least ? to_text(*problem_.at_least)
                                                              : "target";
  return "keep the form " + relation + bound + " at " + place_text(worst->place);
}

std::string Contacts::place_text(const SearchPlace& place) const {
  return problem_.variable + " = " + to_text(problem_.cosine_at(place).cos_theta);
}

}  // namespace shadefit
