#include "fit/stress/stress.hpp"

#include <array>

#include "fit/stress/regime.hpp"

namespace shadefit {

std::vector<FormTrial> try_all_forms(std::size_t random, const Checkpoint& checkpoint,
                                     const std::function<void(double share)>& progress) {
  constexpr std::array topics{lobe_regimes,     dot_product_regimes,   von_mises_fisher_regimes,
                              phase_regimes,    normalisation_regimes, gloss_regimes,
                              remainder_regimes};
  std::vector<Regime> all;
  for (const auto& regimes : topics) {
    for (const Regime& regime : regimes()) all.push_back(regime);
  }
  std::vector<FormTrial> trials;
  for (std::size_t i = 0; i < all.size(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(all.size()));
    const auto more = try_forms(all[i], random, checkpoint);
    trials.insert(trials.end(), more.begin(), more.end());
  }
  return trials;
}

}  // namespace shadefit
