#include "fit/families.hpp"
#include "fit/least_squares.hpp"
#include "fit/solve.hpp"

namespace shadefit {

template <class F>
Solution solve_plain(const F& family, const Metric& metric) {
  const auto optimum = solve_least_squares(family, metric);
  return {{optimum.parameters.begin(), optimum.parameters.end()},
          optimum.status,
          optimum.iterations,
          optimum.digits,
          optimum.rms_error};
}

template Solution solve_plain(const SgOffset&, const Metric&);
template Solution solve_plain(const FresnelOneTerm&, const Metric&);
template Solution solve_plain(const FresnelQuadratic&, const Metric&);
template Solution solve_plain(const PhongBlinn&, const Metric&);
template Solution solve_plain(const SgScaled&, const Metric&);
template Solution solve_plain(const FresnelCubic&, const Metric&);
template Solution solve_plain(const FresnelQuartic&, const Metric&);
template Solution solve_plain(const FresnelFourth&, const Metric&);
template Solution solve_plain(const FresnelSquare&, const Metric&);
template Solution solve_plain(const FresnelRational&, const Metric&);

}  // namespace shadefit
