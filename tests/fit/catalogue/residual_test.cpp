#include <gtest/gtest.h>

#include <string>

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/fit_study.hpp"

namespace shadefit {
namespace {

TEST(Residual, OfEveryLobeIsFormMinusTarget) {
  for (const char* lobe : {"sg-offset", "sg-scaled", "phong-blinn"})
    for (const double exponent : {1e-6, 0.5, 2.0, 37.0, 1e4})
      require_residual(read_study(study_of(*find_family(lobe), exponent, {}).value()));
}

TEST(Residual, MustBeTheDifference) {
  Study study{.target = "x^2", .form = "a x", .over = {{"x", "0", "1"}}, .residual = "x (a - x)"};
  EXPECT_EQ(fit_study({.study = study}).parameters,
            fit_study({.study = {.target = "x^2", .form = "a x", .over = {{"x", "0", "1"}}}}).parameters);
  study.residual = "x (a - x^2)";
  try {
    require_residual(read_study(study));
    FAIL() << "it is not form - target";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("but form - target is"), std::string::npos) << error.what();
  }
  study.target = "sqrt(-1 - x)";
  EXPECT_THROW(require_residual(read_study(study)), UserError) << "nothing can be compared";
}

}  // namespace
}  // namespace shadefit
