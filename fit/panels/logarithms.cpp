#include "fit/panels/logarithms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "fit/quadrature/gauss.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

/// log(e) of a positive e, by the laws of powers and products. The base of a power contains no parameter.
std::optional<Symbolic> logarithm(const Symbolic& e, const std::vector<std::string>& parameters) {
  const auto log_of_part = [&](std::size_t i) { return logarithm(e.part(i), parameters); };
  const auto log_of_base = [&]() -> std::optional<Symbolic> {
    if (auto log = log_of_part(0)) return log;
    if (contains_any(e.part(0), parameters)) return std::nullopt;
    return Symbolic::function("log", {Symbolic::function("abs", {e.part(0)})});
  };
  switch (e.kind()) {
    case Kind::number:
    case Kind::constant:
    case Kind::variable:
      return Symbolic::function("log", {e});
    case Kind::function:
      if (e.name() == "exp") return e.part(0);
      if (e.name() == "exp2") return e.part(0) * Symbolic::constant("ln2");
      return std::nullopt;
    case Kind::integer_power:
    case Kind::real_power: {
      const auto base = log_of_base();
      if (!base) return std::nullopt;
      return (e.kind() == Kind::real_power ? e.part(1) : Symbolic::number(e.name())) * *base;
    }
    case Kind::multiply:
    case Kind::divide: {
      const auto a = log_of_part(0), b = log_of_part(1);
      if (!a || !b) return std::nullopt;
      return e.kind() == Kind::multiply ? *a + *b : *a - *b;
    }
    case Kind::choice: {
      const auto a = log_of_part(2), b = log_of_part(3);
      if (!a || !b) return std::nullopt;
      return e.with_parts({e.part(0), e.part(1), *a, *b});
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<ReadStudy> logarithms_of(const ReadStudy& study, const std::vector<double>& parameters) {
  const auto form = logarithm(study.form, study.parameters);
  if (!form) return std::nullopt;
  const StudyNodes nodes = nodes_of(study, edges_of(study), gauss_sizes[0]);
  const auto all = [&](const Symbolic& formula, bool (*holds)(double)) {
    return std::ranges::all_of(values_at_nodes(study, at_parameters(study, formula, parameters), nodes),
                               holds);
  };
  constexpr auto is_size = [](double value) { return value >= 0; };
  constexpr auto is_number = [](double value) { return !std::isnan(value); };
  if (!all(study.form, is_size) || !all(*form, is_number)) return std::nullopt;
  // The laws of powers do not see the sign of a target.
  const auto target = all(study.target, is_size) ? logarithm(study.target, {}) : std::nullopt;
  ReadStudy logarithms = study;
  logarithms.form = *form;
  if (target) {
    logarithms.target = *target;
  } else {
    // What is left of a difference, as of F(c) - F(1) at c = 1, may be above 0 by a few roundings.
    double largest = 0;
    for (const double value : values_at_nodes(study, study.target, nodes))
      largest = std::max(largest, std::abs(value));
    const Symbolic rounding = Symbolic::number(to_text(4 * std::numeric_limits<double>::epsilon() * largest));
    logarithms.target = Symbolic::function(
        "log", {Symbolic::function("max", {study.target - rounding, Symbolic::number("0")})});
  }
  logarithms.weight = Symbolic::number("1");
  logarithms.error = Error::absolute;
  logarithms.residual.reset();
  return logarithms;
}

}  // namespace shadefit
