#include "fit/quadrature/gauss.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <stdexcept>
#include <utility>

namespace shadefit {

GaussRule gauss_rule(unsigned size) {
  GaussRule rule;
  const auto take_if = [&]<unsigned N>(std::integral_constant<unsigned, N>) {
    static_assert(N % 2 == 0);
    using Rule = boost::math::quadrature::gauss<long double, N>;
    if (N == size) rule = {Rule::abscissa(), Rule::weights()};
    return N == size;
  };
  const bool is_found = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (take_if(std::integral_constant<unsigned, gauss_sizes[I]>{}) || ...);
  }
  (std::make_index_sequence<gauss_sizes.size()>{});
  if (!is_found) throw std::out_of_range("no Gauss rule of that size");
  return rule;
}

}  // namespace shadefit
