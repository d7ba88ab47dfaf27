#include "fit/weight.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fit/extremum.hpp"
#include "fit/parse_formula.hpp"

namespace shadefit {

Weight::Weight(std::string_view text) {
  constexpr std::array<std::string_view, 1> variables{"c"};
  if (!text.empty()) formula_ = parse_formula(text, variables);
}

std::optional<WeightFault> find_fault(const Weight& weight, const Domain& domain) {
  std::vector<double> cosines{domain.lower};
  for (const double s : search_points()) cosines.push_back(domain.lower + s * (domain.upper - domain.lower));
  cosines.push_back(domain.upper);

  std::vector<double> values;
  for (const double c : cosines) {
    values.push_back(weight.at(c));
    if (!std::isfinite(values.back())) return WeightFault{c, values.back()};
  }
  // A weight that touches zero between two places: what is left of it at the minimum is rounding.
  const double least = 1e-12 * *std::max_element(values.begin(), values.end());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > least)) return WeightFault{cosines[i], values[i]};
    if (i == 0 || i + 1 == values.size() || values[i] > values[i - 1] || values[i] > values[i + 1]) continue;
    std::uintmax_t steps = 60;
    const auto minimum = boost::math::tools::brent_find_minima([&](double c) { return weight.at(c); },
                                                               cosines[i - 1], cosines[i + 1], 53, steps);
    if (!(minimum.second > least)) return WeightFault{minimum.first, minimum.second};
  }
  return std::nullopt;
}

}  // namespace shadefit
