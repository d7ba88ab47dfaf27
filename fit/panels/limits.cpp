#include "fit/panels/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fit/panels/features.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// To 30 digits: long double has 20. A number that a double would not hold is 0.
Symbolic number_of(const Decimal50& value) {
  return Symbolic::number(abs(value) < std::numeric_limits<double>::min() ? "0" : value.str(30));
}

/// The limits of formulas of one variable.
class Limits {
 public:
  explicit Limits(const StudyAxis& axis) : axis_(axis) {}

  /// A formula, and the places where it still has no value.
  struct Completed {
    Symbolic formula;
    std::vector<double> open;
  };

  Completed completed(const Symbolic& formula) const {
    if (formula.parts().empty() || integral_depth(formula) > 0) return {formula, {}};
    if (!free_variables(formula).contains(axis_.variable)) return {formula, {}};
    Completed result{formula, {}};
    std::vector<Symbolic> parts;
    for (const Symbolic& part : formula.parts()) {
      Completed of_part = completed(part);
      parts.push_back(std::move(of_part.formula));
      result.open.insert(result.open.end(), of_part.open.begin(), of_part.open.end());
    }
    result.formula = formula.with_parts(std::move(parts));
    if (free_variables(formula) != std::set{axis_.variable}) return result;
    for (const double place : own_poles(formula)) result.open.push_back(place);
    std::ranges::sort(result.open);
    result.open.erase(std::unique(result.open.begin(), result.open.end()), result.open.end());
    std::erase_if(result.open, [&](double place) {
      const std::optional<Symbolic> limited = with_limit(result.formula, place);
      if (limited) result.formula = *limited;
      return limited.has_value();
    });
    return result;
  }

 private:
  /// The places where the operation itself has no value, though its operands have.
  std::vector<double> own_poles(const Symbolic& formula) const {
    const std::vector<Hinge> hinges = hinges_of(formula);
    std::size_t of_parts = 0;
    for (const Symbolic& part : formula.parts()) of_parts += hinges_of(part).size();
    if (hinges.size() == of_parts || !hinges.back().is_pole) return {};  // its own come last
    const Symbolic& part = hinges.back().part;
    return free_variables(part).empty() ? std::vector<double>{} : zeros_of(part, axis_);
  }

  Decimal50 value(const Symbolic& formula, const Decimal50& x) const {
    return in_50_digits(formula, [&](const std::string&) { return x; });
  }

  /// A formula with its limit at a place; empty where it has none.
  std::optional<Symbolic> with_limit(const Symbolic& formula, double place) const {
    const double length = axis_.upper - axis_.lower;
    // 0/0 and 0 log(0) are no number; what is infinite has no limit. The place may be some roundings off.
    const auto is_number = [&](double x) {
      return !std::isnan(evaluate<double>(formula, [&](const std::string&) { return x; }));
    };
    double from = place, to = place;
    bool is_open = !is_number(place) || (std::abs(place) < 1e-15 * length && !is_number(0));
    for (int ulps = 1; ulps <= 3 && !is_open; ++ulps) {
      from = std::nextafter(from, axis_.lower);
      to = std::nextafter(to, axis_.upper);
      is_open = !is_number(from) || !is_number(to);
    }
    if (!is_open) return std::nullopt;
    std::vector<Decimal50> near;
    Decimal50 size = 0;
    for (const int side : {-1, 1}) {
      if (place == (side < 0 ? axis_.lower : axis_.upper)) continue;
      const auto at = [&](const char* distance) {
        return value(formula, Decimal50(place) + side * Decimal50(distance) * Decimal50(length));
      };
      const Decimal50 far = at("1e-6");
      size = max(size, abs(far));
      near.push_back(at("1e-12"));
      // From one distance to the other a logarithm doubles; what has a limit changes little, or falls.
      constexpr double grown = 1.5;
      if (!isfinite(near.back()) || !(abs(near.back()) <= grown * abs(far))) return std::nullopt;
    }
    // Between these places what has a limit changes by a thousandth of its size, unless it falls to 0.
    if (abs(near.front() - near.back()) > size / 1000) return std::nullopt;
    for (double radius = length / 4; radius > length / 1024; radius /= 2) {
      const std::optional<Symbolic> series = polynomial(formula, place, radius);
      const Symbolic distance = abs(Symbolic::variable(axis_.variable) - Symbolic::number(to_text(place)));
      if (series) return select(less(distance, Symbolic::number(to_text(radius))), *series, formula);
    }
    return with_value(formula, place);
  }

  /// Whether the operands do no more near a place than a few of their values show.
  bool are_parts_smooth(const Symbolic& formula, double place, double radius) const {
    constexpr double share = 1e-9;  // of their ranges: what the quotient of what is left may be
    StudyAxis near = axis_;
    near.lower = std::max(axis_.lower, place - radius);
    near.upper = std::min(axis_.upper, place + radius);
    return std::ranges::all_of(formula.parts(), [&](const Symbolic& part) {
      if (part.parts().empty()) return true;
      const Features features = features_of(part, near, {{near.lower}, {near.upper}}, share);
      return features.cuts.empty() && !features.unresolved;
    });
  }

  /// The polynomial in x - place that agrees with a formula to 20 digits within a radius; empty if that of so
  /// many terms does not. It meets the formula at Chebyshev's places.
  std::optional<Symbolic> polynomial(const Symbolic& formula, double place, double radius) const {
    if (!are_parts_smooth(formula, place, radius)) return std::nullopt;
    constexpr std::size_t terms = 18;
    const Decimal50 lower = std::max(axis_.lower, place - radius) - Decimal50(place),
                    upper = std::min(axis_.upper, place + radius) - Decimal50(place);
    const auto at_share = [&](double share) { return Decimal50(lower + Decimal50(share) * (upper - lower)); };
    const auto value_at = [&](const Decimal50& t) { return value(formula, Decimal50(place) + t); };
    std::array<Decimal50, terms> t, divided;
    Decimal50 size = 0;
    for (std::size_t i = 0; i < terms; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / terms;
      t[i] = at_share((1 - std::cos(angle)) / 2);
      divided[i] = value_at(t[i]);
      if (!isfinite(divided[i])) return std::nullopt;
      size = max(size, abs(divided[i]));
    }
    for (std::size_t order = 1; order < terms; ++order)
      for (std::size_t i = terms - 1; i >= order; --i)
        divided[i] = (divided[i] - divided[i - 1]) / (t[i] - t[i - order]);
    // From Newton's form to powers of t.
    std::vector<Decimal50> powers{divided[terms - 1]};
    for (std::size_t i = terms - 1; i-- > 0;) {
      powers.insert(powers.begin(), divided[i]);
      for (std::size_t k = 0; k + 1 < powers.size(); ++k) powers[k] -= t[i] * powers[k + 1];
    }
    const auto sum = [&](const Decimal50& at) {
      Decimal50 result = 0;
      for (std::size_t k = powers.size(); k-- > 0;) result = result * at + powers[k];
      return result;
    };
    const Decimal50 agree = Decimal50("1e-20") * size;
    for (const double share : {0.001, 0.03, 0.21, 0.37, 0.51, 0.68, 0.93, 0.999}) {
      const Decimal50 at = at_share(share);
      if (!(abs(sum(at) - value_at(at)) <= agree)) return std::nullopt;
    }
    const Symbolic distance = Symbolic::variable(axis_.variable) - Symbolic::number(to_text(place));
    Symbolic result = number_of(powers.back());
    for (std::size_t k = powers.size() - 1; k-- > 0;) result = result * distance + number_of(powers[k]);
    return result;
  }

  /// A formula with the limit at the place alone; empty where it does not settle to the digits of a double.
  std::optional<Symbolic> with_value(const Symbolic& formula, double place) const {
    const int side = place < axis_.upper ? 1 : -1;
    const auto at = [&](const char* distance) {
      return value(formula,
                   Decimal50(place) + side * Decimal50(distance) * Decimal50(axis_.upper - axis_.lower));
    };
    const Decimal50 limit = at("1e-40");
    if (!isfinite(limit) || abs(limit - at("1e-36")) > 1e-16 * abs(at("0.3"))) return std::nullopt;
    const Symbolic distance = abs(Symbolic::variable(axis_.variable) - Symbolic::number(to_text(place)));
    return select(less(Symbolic::number("0"), distance), formula, number_of(limit));
  }

  const StudyAxis& axis_;
};

}  // namespace

void take_limits(ReadStudy& study) {
  // The limits of longer formulas would take longer than their fits.
  constexpr std::size_t most_hinges = 40;
  if (study.rows || study.axes.size() > 1) return;
  if (hinges_of(error_formula(study)).size() > most_hinges) return;
  const Limits limits(study.axes.front());
  for (Symbolic* formula : {&study.target, &study.form, &study.weight})
    *formula = limits.completed(*formula).formula;
}

}  // namespace shadefit
