// Fits with random settings, each compared with a global search.
//
// Every family is fitted in 50 settings: target, surface, domain, measure, norm, error and exponent are drawn
// from a fixed seed. SHADEFIT_SEARCH_SETTINGS=500 in the environment makes it 500 and prints how the fits
// ended.
//
// The search shares only names with the library: tests/fit/global_search.hpp.
#include "tests/fit/global_search.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fit/catalogue/family.hpp"

namespace shadefit {
namespace {

using search::Drawn;

Setting setting_of(const Drawn& drawn) {
  if (drawn.ior == 0) return {drawn.exponent};
  return {drawn.exponent, drawn.is_exact ? exact_surface(drawn.ior, drawn.extinction)
                                         : schlick_surface(drawn.ior, drawn.extinction)};
}

Metric metric_of(const Drawn& drawn) {
  return {.measure = measures.at(drawn.measure),
          .norm = drawn.is_minimax ? Norm::minimax : Norm::least_squares,
          .error = drawn.is_relative ? Error::relative : Error::absolute,
          .domain = {drawn.lower, drawn.upper}};
}

/// Of what is compared, both sides are computed by the search. Its integrals and its refined maxima have more
/// digits than these; what it finds is itself a little above the optimum.
constexpr double tolerance = 1e-6;

/// Nearer to its border than this a quadrature no longer sees what a pole adds to an rms error.
constexpr double next_to_border = 1e-2;

/// Differences of numbers near 1 are rounded by a few units of 1e-16.
constexpr double rounding = 1e-14;

class GlobalSearch : public ::testing::TestWithParam<std::string_view> {};

TEST_P(GlobalSearch, FindsNothingBetterThanWhatIsCalledConverged) {
  const Family& family = *find_family(GetParam());
  const char* asked = std::getenv("SHADEFIT_SEARCH_SETTINGS");
  const int settings = asked != nullptr ? std::stoi(asked) : 50;
  std::map<std::string_view, int> ends;
  for (int i = 0; i < settings; ++i) {
    const Drawn drawn = search::draw(family.id, i);
    const std::string what = search::command_of(drawn);
    const Fit fit = family.fit(setting_of(drawn), metric_of(drawn));
    ++ends[name(fit.status)];
    const search::Problem problem(drawn);
    const bool is_answer = fit.status == Status::converged;
    const search::Best best = search::least(problem, is_answer ? fit.parameters : std::vector<double>{}, i);
    if (fit.status == Status::at_border) {
      EXPECT_LT(problem.distance_to_pole(best.parameters), next_to_border)
          << what << ": not only at the border, but at " << ::testing::PrintToString(best.parameters);
    }
    if (!is_answer) {
      EXPECT_NE(fit.why, "") << what;
      continue;
    }
    EXPECT_GT(problem.distance_to_pole(fit.parameters), 0) << what;
    const double own = problem.refined_objective(fit.parameters),
                 other = problem.refined_objective(best.parameters);
    EXPECT_LE(own, other * (1 + tolerance) + rounding)
        << what << ": " << ::testing::PrintToString(fit.parameters) << " is beaten by "
        << ::testing::PrintToString(best.parameters);
    const double stated = drawn.is_minimax ? fit.level.value() : fit.rms_error;
    EXPECT_NEAR(stated, own, own * tolerance + rounding) << what;
    const double largest =
        family.largest_error(setting_of(drawn), metric_of(drawn), fit.parameters).magnitude;
    EXPECT_LE(fit.rms_error, largest * (1 + 1e-9) + rounding) << what;
  }
  if (asked == nullptr) return;
  std::cout << family.id << ":";
  for (const auto& [end, count] : ends) std::cout << " " << count << " " << end;
  std::cout << "\n";
}

std::vector<std::string_view> all_families() {
  std::vector<std::string_view> ids;
  for (const Family& family : families()) ids.push_back(family.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Families, GlobalSearch, ::testing::ValuesIn(all_families()), [](const auto& family) {
  std::string name(family.param);
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace shadefit
