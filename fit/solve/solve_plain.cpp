#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/solve/solve.hpp"

namespace shadefit {
namespace {

template <int N>
Solution solution_of(const Optimum<N>& optimum) {
  return {.parameters = {optimum.parameters.begin(), optimum.parameters.end()},
          .status = optimum.status,
          .iterations = optimum.iterations,
          .digits = optimum.digits,
          .rms_error = optimum.rms_error,
          .why = std::string(optimum.why)};
}

}  // namespace

template <class F>
Solution solve_plain(const F& family, const Metric& metric) {
  return solution_of(solve_least_squares(family, metric));
}

template <class F>
Solution solve_plain_from(const F& family, const Metric& metric, const FamilyStarts<F>& starts) {
  return solution_of(LeastSquares<F>(family, metric).solve(starts));
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

template Solution solve_plain_from(const SgOffset&, const Metric&, const FamilyStarts<SgOffset>&);
template Solution solve_plain_from(const FresnelOneTerm&, const Metric&, const FamilyStarts<FresnelOneTerm>&);
template Solution solve_plain_from(const FresnelQuadratic&, const Metric&,
                                   const FamilyStarts<FresnelQuadratic>&);
template Solution solve_plain_from(const PhongBlinn&, const Metric&, const FamilyStarts<PhongBlinn>&);
template Solution solve_plain_from(const SgScaled&, const Metric&, const FamilyStarts<SgScaled>&);
template Solution solve_plain_from(const FresnelCubic&, const Metric&, const FamilyStarts<FresnelCubic>&);
template Solution solve_plain_from(const FresnelQuartic&, const Metric&, const FamilyStarts<FresnelQuartic>&);
template Solution solve_plain_from(const FresnelFourth&, const Metric&, const FamilyStarts<FresnelFourth>&);
template Solution solve_plain_from(const FresnelSquare&, const Metric&, const FamilyStarts<FresnelSquare>&);
template Solution solve_plain_from(const FresnelRational&, const Metric&,
                                   const FamilyStarts<FresnelRational>&);

}  // namespace shadefit
