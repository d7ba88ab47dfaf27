#include "fit/least_squares/error_scale.hpp"

#include <cmath>

#include "fit/quadrature/gauss.hpp"
#include "fit/quadrature/rule_choice.hpp"

namespace shadefit {

double scale_of(const Weight& weight, const Metric& metric) {
  if (weight.is_one()) return 1;
  const Shape shape{.edges = weight.edges()};
  const auto panels = Substitution::panels(metric, shape);
  const auto sum_by = [&](unsigned rule_size) {
    double total = 0, sum = 0;
    for (const Substitution& panel : panels) {
      total += static_cast<double>(panel.total());
      visit_gauss_rule<double>(rule_size, [&](double position, double node_weight) {
        const auto place = panel.at(position);
        const double value = weight.at(place.cosine.cos_theta);
        sum += node_weight * place.density * value * value;
      });
    }
    return std::sqrt(sum / total);
  };
  double last = -1;
  for (std::size_t i = first_rule(metric, shape); i < fit_rules.size(); ++i) {
    const double scale = sum_by(fit_rules[i]);
    if (std::abs(scale - last) <= 1e-12 * scale) return scale;
    last = scale;
  }
  return last;
}

Shape shape_under(const ErrorScale& scale, Shape shape) {
  if (scale.kind == Error::relative) {
    shape.is_singular_below = shape.end_power > 0;
    shape.concentration = shape.end_power = 0;
  }
  if (scale.weight.is_one()) return shape;
  shape.edges = scale.weight.edges();
  const Domain& domain = scale.weight.domain();
  if (!(shape.concentration > 0)) return shape;
  double length = Substitution::decay / shape.concentration;
  for (double c = domain.upper - length; c > domain.lower; c = domain.upper - length) {
    shape.edges.push_back({c, c});
    length *= 2;
  }
  return shape;
}

}  // namespace shadefit
