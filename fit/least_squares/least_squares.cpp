#include "fit/least_squares/least_squares.hpp"

namespace shadefit {

template Optimum<1> solve_least_squares(const LeastSquaresProblem<1>&, const Starts<1>&);
template Optimum<2> solve_least_squares(const LeastSquaresProblem<2>&, const Starts<2>&);
template Optimum<3> solve_least_squares(const LeastSquaresProblem<3>&, const Starts<3>&);
template Optimum<4> solve_least_squares(const LeastSquaresProblem<4>&, const Starts<4>&);
template Candidate<1> common_optimum(const Starts<1>&, const DescentProblem<1>&, std::size_t);
template Candidate<2> common_optimum(const Starts<2>&, const DescentProblem<2>&, std::size_t);
template Candidate<3> common_optimum(const Starts<3>&, const DescentProblem<3>&, std::size_t);
template Candidate<4> common_optimum(const Starts<4>&, const DescentProblem<4>&, std::size_t);

}  // namespace shadefit
