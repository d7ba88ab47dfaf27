#include "fit/least_squares/weight.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <utility>

#include "fit/errors/extremum.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

/// How close to a root or logarithm Gauss's rule goes: as after the substitution for c^k
/// (fit/quadrature/substitution.hpp).
constexpr int power_at_root = 8;

template <class T>
T value_at(const Symbolic& formula, const T& cosine) {
  return evaluate<T>(formula, [&](const std::string&) { return cosine; });
}

template <class T>
ceres::Jet<T, 1> value_with_slope(const Symbolic& formula, const T& cosine) {
  ceres::Jet<T, 1> c(cosine);
  c.v[0] = T(1);
  return value_at(formula, c);
}

Decimal50 wide_value_at(const Symbolic& formula, double cosine) {
  return in_50_digits(formula, [&](const std::string&) { return Decimal50(cosine); });
}

double slope_at(const Symbolic& formula, double cosine) {
  return value_with_slope(formula, cosine).v[0];
}

/// A choice takes its first side only below zero.
bool is_below(double value) {
  return value < 0;
}

/// The two neighbours between which a predicate changes, among the cosines for which 1 - c is a double too.
/// It differs at `low` and `high`.
template <class Predicate>
std::pair<double, double> bisected(double low, double high, const Predicate& predicate) {
  const bool at_low = predicate(low);
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high))
      return {std::floor(low * 0x1p53) * 0x1p-53, std::ceil(high * 0x1p53) * 0x1p-53};
    (predicate(middle) == at_low ? low : high) = middle;
  }
}

/// The places of a search in a domain, in rising order.
std::vector<double> places_of(const Domain& domain, const std::vector<Shape::Edge>& edges) {
  std::vector<double> places{domain.lower, domain.upper};
  for (const double s : search_points()) places.push_back(domain.lower + s * (domain.upper - domain.lower));
  for (const Shape::Edge& edge : edges) {
    places.push_back(edge.above);
    places.push_back(edge.below);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// The zeros of a hinge in a domain as edges of the formula, appended to those of the inner ones. Returns one
/// at which the formula has a pole.
std::optional<double> append_edges(const Hinge& hinge, const Domain& domain,
                                   std::vector<Shape::Edge>& edges) {
  std::optional<double> pole;
  const auto value = [&](double c) { return value_at(hinge.part, c); };
  std::vector<double> places = places_of(domain, edges), values;
  for (const double c : places) values.push_back(value(c));

  // Between two places it may touch zero or cross it twice, at an extremum that is nearer to zero than both.
  std::vector<double> extrema;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double left = slope_at(hinge.part, places[i - 1]), right = slope_at(hinge.part, places[i]);
    if (!(left * values[i - 1] < 0 && right * values[i] > 0)) continue;
    const auto rises = [&](double c) { return slope_at(hinge.part, c) > 0; };
    extrema.push_back(bisected(places[i - 1], places[i], rises).second);
  }
  for (const double c : extrema) {
    const auto next = std::upper_bound(places.begin(), places.end(), c);
    values.insert(values.begin() + (next - places.begin()), value(c));
    places.insert(next, c);
  }

  double largest = 0;
  for (const double v : values) {
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  }
  const int order = hinge.is_root ? power_at_root : 1;
  // A difference that should be 0 is at most this, by rounding.
  const auto is_zero = [&](double v) { return std::abs(v) <= 1e-15 * largest; };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool has_left = i > 0 && std::isfinite(values[i - 1]);
    if (has_left && std::isfinite(values[i]) && is_below(values[i - 1]) != is_below(values[i])) {
      const auto [low, high] =
          bisected(places[i - 1], places[i], [&](double c) { return is_below(value(c)); });
      edges.push_back({high, low, order});
      if (hinge.is_pole) pole = high;
    }
    if (!hinge.is_root || !is_zero(values[i])) continue;
    const bool is_flat =
        (i == 0 || is_zero(values[i - 1])) && (i + 1 == places.size() || is_zero(values[i + 1]));
    if (is_flat) continue;
    edges.push_back({places[i], places[i], order});
    // The nearest double is 1e-16 from a double zero, so the value there is the square of that.
    if (hinge.is_pole && abs(wide_value_at(hinge.part, places[i])) <= Decimal50(1e-28 * largest))
      pole = places[i];
  }
  return pole;
}

/// In falling order. A place within rounding of another, or of an end, is merged with it.
std::vector<Shape::Edge> tidied(std::vector<Shape::Edge> edges, const Domain& domain) {
  const double near = 1e-14 * (domain.upper - domain.lower);
  std::ranges::stable_sort(edges, std::greater(), &Shape::Edge::above);
  std::vector<Shape::Edge> result;
  for (Shape::Edge edge : edges) {
    if (domain.upper - edge.above <= near) edge.above = edge.below = domain.upper;
    if (edge.below - domain.lower <= near) edge.above = edge.below = domain.lower;
    if (!result.empty() && result.back().below - edge.above <= near) {
      result.back().below = std::min(result.back().below, edge.below);
      result.back().power = std::max(result.back().power, edge.power);
    } else {
      result.push_back(edge);
    }
  }
  return result;
}

/// The places where a weight is sampled between two of its edges, ends included, in rising order.
std::vector<std::vector<double>> pieces_of(const Weight& weight) {
  const Domain& domain = weight.domain();
  std::vector<std::vector<double>> pieces;
  const std::vector<double> all = places_of(domain, {});
  double upper = domain.upper;
  const auto add = [&](double lower) {
    if (!(lower < upper)) return;
    std::vector<double> piece{lower, lower + (upper - lower) / 2};
    std::copy_if(all.begin(), all.end(), std::back_inserter(piece),
                 [&](double c) { return lower < c && c < upper; });
    piece.push_back(upper);
    std::sort(piece.begin(), piece.end());
    pieces.push_back(piece);
  };
  for (const Shape::Edge& edge : weight.edges()) {
    add(edge.above);
    upper = std::min(upper, edge.below);
  }
  add(domain.lower);
  return pieces;
}

}  // namespace

Weight::Weight(std::string_view text, const Domain& domain) : domain_(domain) {
  constexpr std::array<std::string_view, 1> variables{"c"};
  if (text.empty()) return;
  formula_ = parse_formula(text, variables);
  for (const Hinge& hinge : hinges_of(*formula_)) {
    if (const auto pole = append_edges(hinge, domain_, edges_)) pole_ = pole;
    if (edges_.size() > most_edges) edges_ = tidied(edges_, domain_);
    if (edges_.size() > most_edges) return;
  }
  edges_ = tidied(edges_, domain_);
}

std::array<double, 3> Weight::derivatives_at(double cos_theta) const {
  const double inside = std::clamp(cos_theta, domain_.lower, domain_.upper);
  const auto value = value_with_slope(*formula_, ceres::Jet<double, 1>(inside, 0));
  return {value.a.a, value.a.v[0], value.v[0].v[0]};
}

std::array<long double, 2> Weight::derivatives_at(long double cos_theta) const {
  const long double lower = domain_.lower, upper = domain_.upper;
  const auto value = value_with_slope(*formula_, std::clamp(cos_theta, lower, upper));
  return {value.a, value.v[0]};
}

std::optional<std::string> find_fault(const Weight& weight) {
  if (!weight.formula()) return std::nullopt;
  if (weight.edges().size() > most_edges)
    return "has more than " + std::to_string(most_edges) + " kinks, roots and poles: no more are allowed";
  const auto pieces = pieces_of(weight);
  double largest = 0;
  for (const auto& piece : pieces) {
    for (const double c : piece) {
      const double value = weight.at(c);
      if (!std::isfinite(value))
        return "is " + (std::isnan(value) ? "nan" : decimal(value, 6)) + " at c = " + to_text(c) +
               ": it must be finite over the domain";
      largest = std::max(largest, std::abs(value));
    }
  }
  if (weight.pole())
    return "divides by zero at c = " + to_text(*weight.pole()) + ": it must be finite over the domain";
  // A formula that cancels 20 of 50 digits leaves at most this of a zero.
  const Decimal50 nothing = Decimal50(largest) * Decimal50("1e-30");
  const auto negative_at = [&](double c) -> std::optional<std::string> {
    if (!(weight.at(c) <= 1e-12 * largest)) return std::nullopt;
    const Decimal50 value = wide_value_at(*weight.formula(), c);
    if (!(value < -nothing)) return std::nullopt;
    return "is " + decimal(static_cast<double>(value), 6) + " at c = " + to_text(c) +
           ": it must not be negative over the domain";
  };
  for (const auto& piece : pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (const auto fault = negative_at(piece[i])) return fault;
      const double value = weight.at(piece[i]);
      const bool is_end = i == 0 || i + 1 == piece.size();
      if (is_end || value > weight.at(piece[i - 1]) || value > weight.at(piece[i + 1])) continue;
      std::uintmax_t steps = 60;
      const auto minimum = boost::math::tools::brent_find_minima([&](double c) { return weight.at(c); },
                                                                 piece[i - 1], piece[i + 1], 53, steps);
      if (const auto fault = negative_at(minimum.first)) return fault;
    }
    // Between two edges a formula is analytic: if it is zero at all these places, it is zero everywhere
    // between.
    const double lower = piece.front(), upper = piece.back();
    const bool is_zero = std::all_of(piece.begin() + 1, piece.end() - 1, [&](double c) {
      return abs(wide_value_at(*weight.formula(), c)) <= nothing;
    });
    if (is_zero)
      return "is 0 from c = " + decimal(lower, 6) + " to c = " + decimal(upper, 6) +
             ": it may be 0 at single places only";
  }
  if (!(1 / largest_weight <= largest && largest <= largest_weight))
    return "is " + decimal(largest, 6) + " at its largest: that must lie between " +
           decimal(1 / largest_weight, 6) + " and " + decimal(largest_weight, 6);
  return std::nullopt;
}

}  // namespace shadefit
