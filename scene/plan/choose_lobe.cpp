#include "scene/plan/choose_lobe.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "fit/support/decimal.hpp"
#include "scene/plan/lobe_error.hpp"
#include "scene/plan/lobe_fit.hpp"

namespace shadefit::scene {
namespace {

/// A whole power by at most this many multiplications costs no more than LOG2, MUL and EXP2.
constexpr int most_multiplications = 9;

int multiplications(int n) {
  const auto bits = static_cast<unsigned>(n);
  return static_cast<int>(std::bit_width(bits)) + std::popcount(bits) - 2;
}

/// A c - A saves one instruction over A (c - 1). It is used if its additional rounding is at most this share
/// of the allowed error.
constexpr double next_to_nothing = 0.02;

class Choice {
 public:
  Choice(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint)
      : lobes_(lobes), budget_(budget), checkpoint_(checkpoint) {}

  ChosenLobe cheapest() {
    const Range range = lobes_.range();
    if (range.most == 0) return measured({.kind = LobeKind::constant}, "every power is 0");
    if (const auto whole = one_whole_power())
      return measured({.kind = LobeKind::multiplied, .whole = *whole}, "one whole power: exact");
    LobeFitter fitter(lobes_.all, budget_.scale);
    LobeForm form{.kind = LobeKind::exponential, .slopes = {natural_slope}};
    if (const auto plain = within(fitter, form)) return *plain;
    form.offset = fitter.best_offset();
    if (const auto gaussian = within(fitter, form)) return *gaussian;
    const std::string reason = "the best Gaussian, x = " + decimal(form.offset, 3) + ", is off by " +
                               decimal(fitter.sampled_error(form.slopes, form.offset), 2);
    for (int slopes = 2; slopes <= most_slopes; ++slopes) {
      form = {.kind = LobeKind::exponential, .slopes = fitter.best_slopes(slopes)};
      if (const auto found = within(fitter, form, reason)) return *found;
    }
    return measured({.kind = LobeKind::power}, reason);
  }

 private:
  static constexpr int most_slopes = 4;

  std::optional<int> one_whole_power() const {
    const Range range = lobes_.range();
    constexpr double most = 1 << 8;
    if (!lobes_.is_one_power() || range.most != std::floor(range.most) || range.most > most) return {};
    const int n = static_cast<int>(range.most);
    if (multiplications(n) > most_multiplications) return {};
    return n;
  }

  /// The form with its errors, if they are within the budget.
  std::optional<ChosenLobe> within(const LobeFitter& fitter, LobeForm form,
                                   const std::string& reason = "the cheapest, and near enough") const {
    const double allowed = budget_.allowed;
    if (fitter.sampled_error(form.slopes, form.offset) > allowed) return {};
    double error = 0;
    const LobeCells cells(form.slopes, std::max(1.0, lobes_.range().most));
    for (const WeightedPower& lobe : lobes_.all) {
      checkpoint_();
      error = std::max(error, cells.largest_error(lobe, form.offset, budget_.scale, error));
      if (error > allowed) return {};
    }
    form.is_fused = form.slopes.size() == 1 && !lobes_.is_textured();
    form.is_fused = form.is_fused && rounding(form) <= next_to_nothing * allowed;
    const double added = rounding(form);
    if (error + added > allowed) return {};
    return ChosenLobe{.form = form, .error = error, .rounding = added, .reason = reason};
  }

  ChosenLobe measured(const LobeForm& form, const std::string& reason) const {
    return {.form = form, .error = 0, .rounding = rounding(form), .reason = reason};
  }

  double rounding(const LobeForm& form) const {
    return rounding_error({form, lobes_, budget_.has_fresnel, budget_.is_gloss_exponential},
                          budget_.precision, budget_.scale);
  }

  const Lobes& lobes_;
  const LobeBudget& budget_;
  const Checkpoint& checkpoint_;
};

}  // namespace

ChosenLobe choose_lobe(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint) {
  return Choice(lobes, budget, checkpoint).cheapest();
}

}  // namespace shadefit::scene
