#include "fit/stress/fits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/squares/prepared_study.hpp"
#include "fit/stress/numbers.hpp"

namespace shadefit {
namespace {

// The starts are drawn from a box around the family's own, four times as wide. Every fit that converges has
// the family's answer, and no start is that answer.
TEST(FitsUnderStress, DoNotDependOnTheirStarts) {
  constexpr double same_answer = 1e-12;  // a hundred times the error of 14 digits
  Sequence sequence(1);
  int converged = 0;
  for (const Fit& own : fits_under_stress(keep_going)) {
    const Domain& domain = own.metric.domain;
    PreparedStudy study(near_peak(study_of(*own.family, setting_of(own), own.metric).value()));
    const auto box = own.family->starts_of(setting_of(own));
    for (int fit = 0; fit < 12; ++fit) {
      std::vector<double> start;
      for (std::size_t i = 0; i < own.parameters.size(); ++i) {
        const auto [low, high] = std::minmax({box[0][i].value, box[1][i].value, box[2][i].value});
        start.push_back((low + high) / 2 + 2 * (high - low) * sequence.between(-1, 1));
      }
      const StudyFit found = study.fit(start);
      if (found.status != Status::converged || own.status != Status::converged) continue;
      ++converged;
      EXPECT_NE(found.parameters, start) << own.family->id;
      for (std::size_t i = 0; i < start.size(); ++i)
        EXPECT_NEAR(found.parameters[i], own.parameters[i], same_answer * std::abs(own.parameters[i]))
            << own.family->id << " of exponent " << own.exponent.value_or(0) << " on " << to_text(domain);
    }
  }
  EXPECT_GE(converged, 450);
}

}  // namespace
}  // namespace shadefit
