#include <cmath>
#include <cstdio>

#include "fit/squares/solve_study.hpp"

/// A form of one's own: a template over its scalar, so that a shader's mock-up in float and the fit use one
/// formula.
template <class T>
T arc_cosine(const T& x, const T& a, const T& b) {
  using shadefit::sqrt;
  return sqrt(shadefit::integer<T>(1) - x) * (a + b * x);
}

/// Fits it to acos, and a formula from text to the same. Exits with 1 unless both give the same constants.
int main() {
  using shadefit::Symbolic;
  const auto name = [](const char* text) { return Symbolic::variable(text); };
  shadefit::Study study{.target = "acos(x)",
                        .form = shadefit::to_text(arc_cosine(name("x"), name("a"), name("b"))),
                        .over = {{"x", "0", "1"}}};
  const shadefit::StudyFit from_template = shadefit::solve_study(shadefit::read_study(study), {});
  study.form = "sqrt(1 - x) (a + b x)";
  const shadefit::StudyFit from_text = shadefit::solve_study(shadefit::read_study(study), {});
  std::printf("a = %.14g, b = %.14g, %d digits\n", from_text.parameters[0], from_text.parameters[1],
              from_text.digits);
  const bool is_one_fit = from_template.parameters == from_text.parameters && from_text.digits == 14;
  // The template in float, with the constants in it.
  const float half = arc_cosine(0.5F, static_cast<float>(from_text.parameters[0]),
                                static_cast<float>(from_text.parameters[1]));
  return is_one_fit && std::abs(half - std::acos(0.5F)) < 0.006F ? 0 : 1;
}
