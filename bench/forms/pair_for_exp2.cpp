#include "bench/forms/pair_for_exp2.hpp"

#include <string>

#include "approx/exp2_polynomial.hpp"
#include "fit/verdicts/study_objectives.hpp"

namespace shadefit {
namespace {

// The error jumps where the exponent x = (a c + b) c passes the middle between two whole numbers. In c, these
// places depend on the pair. With x as the variable instead of c, they do not: the polynomial is 2^n p(x - n)
// for every pair, and the pair moves only the cosine at which (1-c)^5 is evaluated, the root of
// (a c + b) c = x that is 0 at x = 0. So the polynomial is the target here, and (1-c)^5 the form.

constexpr const char* cosine_of_exponent = "2 x/(b - sqrt(b b + 4 a x))";

/// From the first whole numbers, from 0 down. Without the others the level can only be lower. But errors
/// there are below the level: the polynomial is at most 2^-8.5 = 0.0028 and (1-c)^5 less, while the level is
/// at least 0.0034. So the level is that of the whole domain. Its test samples all of it.
constexpr const char* lowest_exponent = "-8.5";

std::string polynomial(int degree) {
  const Exp2Coefficients& coefficients = exp2_of_degree(exp2_for_float, degree);
  std::string text = "0";
  for (int i = degree; i > 0; --i)
    text = "r (" + std::string(coefficients.printed[static_cast<std::size_t>(i - 1)]) + " + " + text + ")";
  return "exp2(n) (1 + " + text + ")";
}

}  // namespace

StudyFit fit_pair_for_exp2(int degree) {
  const Study study{.target = polynomial(degree),
                    .form = std::string("schlick_weight(") + cosine_of_exponent + ")",
                    .over = {{"x", lowest_exponent, "0"}},
                    .definitions = {{"n", {}, "floor(x + 1/2)"}, {"r", {}, "x - n"}},
                    .starts = {{"a", -5}, {"b", -7}}};
  return fit_study({.study = study, .norm = Norm::minimax});
}

}  // namespace shadefit
