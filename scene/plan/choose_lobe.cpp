#include "scene/plan/choose_lobe.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "fit/support/decimal.hpp"
#include "scene/plan/choose_exp2.hpp"
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

/// The share of the allowed error for the form; the rest is for exp2 by a polynomial.
constexpr double share_of_form = 0.9;
/// A c - A saves one instruction over A (c - 1). It is used if its additional rounding is at most this share
/// of the allowed error.
constexpr double next_to_nothing = 0.02;
/// The number of steps from the constants with the smallest largest error to those with the smallest mean
/// error.
constexpr int all_the_way = 128;

/// The constants after a number of these steps, each slope a float.
LobeForm between(LobeForm level, const LobeForm& mean, int steps) {
  const auto mixed = [&](double a, double b) { return a + (b - a) * steps / all_the_way; };
  level.offset = mixed(level.offset, mean.offset);
  if (level.slopes.size() > 1) {
    for (std::size_t i = 0; i < level.slopes.size(); ++i)
      level.slopes[i] = static_cast<double>(static_cast<float>(mixed(level.slopes[i], mean.slopes[i])));
  }
  return level;
}

class Choice {
 public:
  Choice(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint)
      : lobes_(lobes), budget_(budget), checkpoint_(checkpoint) {}

  ChosenLobe cheapest() {
    const Range range = lobes_.range();
    if (range.most == 0) return measured({.kind = LobeKind::constant});
    if (const auto whole = one_whole_power())
      return measured({.kind = LobeKind::multiplied, .whole = *whole});
    LobeFitter fitter(lobes_.all, budget_.scale, lobes_.used);
    const auto done = [&](ChosenLobe found) {
      found.fits_run = fitter.fits_run();
      found.cheaper = cheaper_;
      return found;
    };
    if (const auto found = gaussian(fitter)) return done(*found);
    for (int slopes = 2; slopes <= most_slopes; ++slopes) {
      const LobeForm form{.kind = LobeKind::exponential, .slopes = fitter.best_slopes(slopes)};
      if (const auto found = near_enough(fitter, form)) return done(by_use(fitter, *found));
    }
    return done(measured({.kind = LobeKind::power}));
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

  /// The Gaussian without an offset if that is enough, else with this scene's offset.
  std::optional<ChosenLobe> gaussian(LobeFitter& fitter) {
    LobeForm form{.kind = LobeKind::exponential, .slopes = {natural_slope}};
    if (const auto plain = near_enough(fitter, form)) return plain;
    form.offset = fitter.best_offset();
    if (const auto found = near_enough(fitter, form)) return by_use(fitter, *found);
    cheaper_ = "the best Gaussian, x = " + decimal(form.offset, 3) + ", is off by " +
               decimal(fitter.sampled_error(form.slopes, form.offset), 2);
    return {};
  }

  std::optional<ChosenLobe> near_enough(const LobeFitter& fitter, const LobeForm& form) const {
    return within(fitter, form, share_of_form * budget_.allowed);
  }

  /// Starts from the form with the smallest largest error and spends the rest of its budget on a smaller mean
  /// error.
  ChosenLobe by_use(LobeFitter& fitter, ChosenLobe level) const {
    const LobeForm mean = fitter.best_on_the_mean(level.form);
    level.mean_error = level.mean_error_of_level = fitter.mean_error(level.form);
    const double left = budget_.allowed - level.error - level.rounding;
    const double allowed = std::min(share_of_form * budget_.allowed,
                                    level.error + left - choose_exp2(left, budget_.scale).error);
    // The proven bound may be wider than the sampled error; then fewer steps are taken.
    int steps = steps_towards(fitter, level.form, mean, allowed);
    for (int attempt = 0; attempt < 4 && steps > 0; ++attempt, steps = steps * 3 / 4) {
      auto found = within(fitter, between(level.form, mean, steps), allowed);
      if (!found || found->form.is_fused != level.form.is_fused) continue;
      found->mean_error = fitter.mean_error(found->form);
      if (!(found->mean_error < level.mean_error)) break;
      found->mean_error_of_level = level.mean_error;
      return *found;
    }
    return level;
  }

  /// The number of steps from `level` towards `mean` within the allowed sampled error. Along every line of
  /// constants the error first falls, then rises.
  static int steps_towards(const LobeFitter& fitter, const LobeForm& level, const LobeForm& mean,
                           double allowed) {
    int near = 0, far = all_the_way + 1;
    while (far - near > 1) {
      const int middle = (near + far) / 2;
      const LobeForm form = between(level, mean, middle);
      (fitter.sampled_error(form.slopes, form.offset, allowed) <= allowed ? near : far) = middle;
    }
    return near;
  }

  /// The form with its errors, if they are within the budget. `allowed` is the part of the budget for the
  /// lobe.
  std::optional<ChosenLobe> within(const LobeFitter& fitter, LobeForm form, double allowed) const {
    if (fitter.sampled_error(form.slopes, form.offset) > allowed) return {};
    double error = 0;
    const LobeCells cells(form.slopes, std::max(1.0, lobes_.range().most));
    for (const WeightedPower& lobe : lobes_.all) {
      checkpoint_();
      error = std::max(error, cells.largest_error(lobe, form.offset, budget_.scale, error));
      if (error > allowed) return {};
    }
    form.is_fused = form.slopes.size() == 1 && !lobes_.is_textured();
    form.is_fused = form.is_fused && rounding(form) <= next_to_nothing * budget_.allowed;
    const double added = rounding(form);
    if (error + added > budget_.allowed) return {};
    return ChosenLobe{.form = form, .error = error, .rounding = added};
  }

  ChosenLobe measured(const LobeForm& form) const {
    return {.form = form, .error = 0, .rounding = rounding(form)};
  }

  double rounding(const LobeForm& form) const {
    return rounding_error({form, lobes_, budget_.has_fresnel, budget_.is_gloss_exponential},
                          budget_.precision, budget_.scale);
  }

  const Lobes& lobes_;
  const LobeBudget& budget_;
  const Checkpoint& checkpoint_;
  std::string cheaper_;
};

}  // namespace

ChosenLobe choose_lobe(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint) {
  return Choice(lobes, budget, checkpoint).cheapest();
}

}  // namespace shadefit::scene
