#include "fit/study_exchange/logarithms.hpp"

#include <algorithm>
#include <cmath>

#include "fit/quadrature/gauss.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

using Kind = Symbolic::Kind;

Symbolic log_of_size(const Symbolic& e) {
  return Symbolic::function("log", {Symbolic::function("abs", {e})});
}

/// log(e) of a positive e, by the laws of powers and products.
std::optional<Symbolic> logarithm(const Symbolic& e) {
  const auto log_of_part = [&](std::size_t i) { return logarithm(e.part(i)); };
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
      return Symbolic::number(e.name()) * log_of_part(0).value_or(log_of_size(e.part(0)));
    case Kind::real_power:
      return e.part(1) * log_of_part(0).value_or(log_of_size(e.part(0)));
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
  const auto form = logarithm(study.form);
  if (!form) return std::nullopt;
  const StudyNodes nodes = nodes_of(study, edges_of(study), gauss_sizes[0]);
  const auto has_none = [](double value) { return std::isnan(value); };
  if (std::ranges::any_of(values_at_nodes(study, at_parameters(study, *form, parameters), nodes), has_none))
    return std::nullopt;
  ReadStudy logarithms = study;
  logarithms.form = *form;
  logarithms.target = logarithm(study.target)
                          .value_or(Symbolic::function(
                              "log", {Symbolic::function("max", {study.target, Symbolic::number("0")})}));
  logarithms.weight = Symbolic::number("1");
  logarithms.error = Error::absolute;
  logarithms.residual.reset();
  return logarithms;
}

}  // namespace shadefit
