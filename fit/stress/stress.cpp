#include "fit/stress/stress.hpp"

#include <array>

#include "fit/stress/regimes.hpp"

namespace shadefit {

std::vector<FormTrial> try_all_forms(std::size_t random, const Checkpoint& checkpoint,
                                     const std::function<void(std::string_view topic)>& progress) {
  constexpr std::array topics{lobe_regimes,     dot_product_regimes,   von_mises_fisher_regimes,
                              phase_regimes,    normalisation_regimes, gloss_regimes,
                              remainder_regimes};
  std::vector<FormTrial> trials;
  for (const auto& regimes : topics) {
    for (const Regime& regime : regimes()) {
      progress(regime.topic);
      const auto more = try_forms(regime, random, checkpoint);
      trials.insert(trials.end(), more.begin(), more.end());
    }
  }
  return trials;
}

}  // namespace shadefit
