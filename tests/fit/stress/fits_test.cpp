#include "fit/stress/fits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/family_visit.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/newton.hpp"
#include "fit/solve.hpp"
#include "fit/stress/numbers.hpp"

namespace shadefit {
namespace {

// From starts drawn from a box around the family's own, four times as wide: all that converge have one
// answer, which is none of the starts, and that of the family's own starts if these converge.
TEST(FitsUnderStress, DoNotDependOnTheirStarts) {
  constexpr double same_answer = 1e-12;  // a hundred times the error of 14 digits
  Sequence sequence(1);
  int converged = 0;
  for (const Fit& own : fits_under_stress(keep_going)) {
    visit_family(own.family->id, [&]<class F>(std::type_identity<F>) {
      const F family = make_family<F>(setting_of(own));
      const auto box = starts_of_family(family);
      Solution answer = own;
      for (int fit = 0; fit < 4; ++fit) {
        Starts starts = box;
        for (auto& start : starts) {
          for (Eigen::Index i = 0; i < start.size(); ++i) {
            const auto [low, high] = std::minmax({box[0][i], box[1][i], box[2][i]});
            start[i] = (low + high) / 2 + 2 * (high - low) * sequence.between(-1, 1);
          }
        }
        const Solution found = solve_by_squares(family, own.metric, starts);
        if (found.status != Status::converged) continue;
        if (answer.status != Status::converged) answer = found;
        ++converged;
        const auto parameters = vector_of(found.parameters), expected = vector_of(answer.parameters);
        EXPECT_LE(relative_size<double>(parameters - expected, expected), same_answer)
            << own.family->id << " of exponent " << own.exponent.value_or(0) << " on "
            << to_text(own.metric.domain);
        EXPECT_EQ(std::ranges::find(starts, parameters), starts.end()) << own.family->id;
      }
    });
  }
  EXPECT_GE(converged, 150);
}

}  // namespace
}  // namespace shadefit
