#include "scene/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "fit/decimal.hpp"
#include "fit/fit.hpp"
#include "scene/lobe_error.hpp"

namespace shadefit::scene {
namespace {

/// How a light's share of the tolerance is spent. A cut-off costs no instruction of a pixel that is lit, and
/// a tenth of the error widens it little: the lobe's own width is its logarithm.
constexpr double for_cutoff = 0.1;
/// The lobe's form and Fresnel's share the rest.
constexpr double for_lobe = 0.6, for_fresnel = 0.3;

/// Whole powers up to this one are cheaper by multiplications than by LOG2, MUL and EXP2: at a quarter of the
/// rate each, those are nine instructions, and 64 is six multiplications.
constexpr double most_multiplied = 64;

double largest_of(const std::array<Range, 3>& channels) {
  return std::max({channels[0].most, channels[1].most, channels[2].most});
}

/// The largest reflectance at any angle.
double largest_reflectance(const Material& material) {
  const double facing = largest_of(material.f0);
  return material.fresnel == FresnelTerm::none ? facing : std::max(facing, material.f90.most);
}

bool is_black(const Material& material) {
  return largest_reflectance(material) == 0;
}

/// F90 as a material's lobe meets it: a black F0 with a white F90 shines at grazing angles alone.
double largest_factor(const Material& material, double power) {
  return largest_reflectance(material) * game_normalisation(power);
}

Range powers_of(const Material& material) {
  return {material.powers.front().power, material.powers.back().power};
}

MaterialPlan plan_material(const Material& material, double budget) {
  MaterialPlan plan;
  plan.name = material.name;
  plan.power = powers_of(material);
  plan.factor = largest_factor(material, plan.power.most);
  if (material.is_unlit) {
    plan.reason = "unlit";
  } else if (is_black(material)) {
    plan.reason = "black specular colour";
  } else if (std::min(plan.factor, 1.0) <= budget) {
    plan.reason = "at most " + decimal_above(plan.factor, 2) + " of a light";
    plan.error = plan.factor;
  } else {
    plan.has_lobe = true;
  }
  return plan;
}

/// Each power once, with the largest factor that it has anywhere.
std::vector<WeightedPower> each_once(std::vector<WeightedPower> lobes) {
  std::sort(lobes.begin(), lobes.end(), [](const WeightedPower& a, const WeightedPower& b) {
    return a.power != b.power ? a.power < b.power : a.factor > b.factor;
  });
  const auto is_same = [](const WeightedPower& a, const WeightedPower& b) { return a.power == b.power; };
  lobes.erase(std::unique(lobes.begin(), lobes.end(), is_same), lobes.end());
  return lobes;
}

/// What the lobes of a scene have in common.
struct Lobes {
  std::vector<WeightedPower> powers;  ///< of all materials that have one, by rising power
  bool is_textured = false, has_schlick = false, has_colour = false;

  Range range() const { return {powers.front().power, powers.back().power}; }
  bool is_one_power() const { return range().is_constant() && !is_textured; }
};

Lobes lobes_of(const Scene& scene, const std::vector<MaterialPlan>& plans) {
  Lobes lobes;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!plans[i].has_lobe) continue;
    const Material& material = scene.materials[i];
    for (const PowerShare& share : material.powers)
      lobes.powers.push_back({share.power, largest_factor(material, share.power)});
    lobes.is_textured = lobes.is_textured || material.is_power_textured;
    lobes.has_schlick = lobes.has_schlick || material.fresnel == FresnelTerm::schlick;
    const auto& f0 = material.f0;
    lobes.has_colour = lobes.has_colour || f0[0] != f0[1] || f0[1] != f0[2];
  }
  lobes.powers = each_once(std::move(lobes.powers));
  return lobes;
}

/// The largest proven error of a Gaussian with that offset; empty where it is above what is allowed.
std::optional<double> error_within(const Lobes& lobes, double offset, double allowed,
                                   const Checkpoint& checkpoint) {
  for (const WeightedPower& lobe : lobes.powers) {
    if (lobe.power > 0 && sampled_gaussian_error(lobe, offset) > allowed) return std::nullopt;
  }
  double largest = 0;
  // Far enough below what is allowed, more precise bounds decide nothing.
  constexpr double enough = 0.9;
  for (const WeightedPower& lobe : lobes.powers) {
    checkpoint();
    // a power of 0 is 1, and its Gaussian 1 - x y + ..
    if (lobe.power == 0 && offset != 0) return std::nullopt;
    if (lobe.power > 0) largest = std::max(largest, gaussian_error(lobe, offset, enough * allowed));
    if (largest > allowed) return std::nullopt;
  }
  return largest;
}

class Planner {
 public:
  Planner(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint)
      : scene_(scene), checkpoint_(checkpoint), budget_(wanted.tolerance / wanted.lights) {
    plan_.wanted = wanted;
  }

  Plan plan() && {
    for (const Material& material : scene_.materials)
      plan_.materials.push_back(plan_material(material, budget_));
    lobes_ = lobes_of(scene_, plan_.materials);
    decide_materials();
    if (lobes_.powers.empty()) {
      skip_all();
    } else {
      decide_lobe();
      decide_rest();
      decide_fresnel();
      decide_culling();
    }
    sum_up();
    return std::move(plan_);
  }

 private:
  void decide(std::string term, Verdict verdict, std::string form, std::string reason, double error = 0) {
    plan_.decisions.push_back({std::move(term), verdict, std::move(form), std::move(reason), error});
  }

  void decide_materials() {
    const auto total = static_cast<long>(plan_.materials.size());
    const auto needed = std::count_if(plan_.materials.begin(), plan_.materials.end(),
                                      [](const MaterialPlan& m) { return m.has_lobe; });
    double error = 0;
    for (const MaterialPlan& material : plan_.materials) error = std::max(error, material.error);
    const std::string of = std::to_string(total - needed) + " of " + counted(total, "material");
    decide("specular",
           needed == 0       ? Verdict::skip
           : needed == total ? Verdict::keep
                             : Verdict::replace,
           needed == 0 ? "" : "for " + std::to_string(needed) + " of " + counted(total, "material"),
           needed == total ? "every material has one" : "skipped for " + of, error);
  }

  void skip_all() {
    for (const char* term : {"lobe", "offset x", "power", "gloss decode", "normalisation", "coloured F0",
                             "Fresnel", "mip level", "culling"})
      decide(term, Verdict::skip, "", "no material has a specular lobe");
  }

  void decide_lobe() {
    const double allowed = for_lobe * budget_;
    const Range range = lobes_.range();
    if (range.most == 0) {
      decide("lobe", Verdict::skip, "", "every power is 0: a constant");
      decide("offset x", Verdict::skip, "", "no Gaussian");
    } else if (lobes_.is_one_power() && range.most <= most_multiplied &&
               range.most == std::floor(range.most)) {
      decide("lobe", Verdict::replace, "c^" + decimal(range.most, 3) + " by multiplications",
             "one whole power: exact");
      decide("offset x", Verdict::skip, "", "no Gaussian");
    } else {
      decide_gaussian(allowed);
    }
  }

  /// The plain Gaussian, the one with this scene's offset, or the power itself.
  void decide_gaussian(double allowed) {
    if (const auto plain = error_within(lobes_, 0, allowed, checkpoint_)) {
      decide("lobe", Verdict::replace, "exp2(A c - A), A = n/ln 2", "near enough without an offset", *plain);
      decide("offset x", Verdict::skip, "", "0 is near enough");
      return;
    }
    ++plan_.fits_run;
    const double offset = best_offset(lobes_.powers);
    if (const auto best = error_within(lobes_, offset, allowed, checkpoint_)) {
      decide("lobe", Verdict::replace, "exp2(A c - A), A = (n + x)/ln 2", "the cheapest that is near enough",
             *best);
      decide("offset x", Verdict::keep, "x = " + decimal(offset, 6),
             "its largest error over the scene's powers is least");
      return;
    }
    double least = 0;
    for (const WeightedPower& lobe : lobes_.powers)
      least = std::max(least, sampled_gaussian_error(lobe, offset));
    decide("lobe", Verdict::keep, "exp2(n log2(c))",
           "no Gaussian is within " + decimal(allowed, 2) + ": the best, x = " + decimal(offset, 3) +
               ", is off by " + decimal(least, 2) + ", as (n + 2)/8 grows with what it errs less");
    decide("offset x", Verdict::skip, "", "no Gaussian");
  }

  void decide_rest() {
    const Range range = lobes_.range();
    const std::string one = "one power for the whole scene: " + decimal(range.least, 6);
    const bool is_one = lobes_.is_one_power();
    const std::string powers = "powers from " + decimal(range.least, 3) + " to " + decimal(range.most, 3);
    if (is_one) {
      decide("power", Verdict::skip, "", one);
    } else {
      decide("power", Verdict::keep, lobes_.is_textured ? "for each pixel" : "for each material", powers);
    }
    if (lobes_.is_textured) {
      decide("gloss decode", Verdict::keep, "n = 2/alpha^2 - 2", "roughness is a texture");
    } else {
      decide("gloss decode", Verdict::skip, "", is_one ? one : "each material's power is a constant");
    }
    if (is_one) {
      decide("normalisation", Verdict::replace, decimal(game_normalisation(range.least), 6), one);
    } else {
      decide("normalisation", Verdict::keep,
             lobes_.is_textured ? "(n + 2)/8" : "(n + 2)/8, a constant of the material", powers);
    }
    if (lobes_.has_colour) {
      decide("coloured F0", Verdict::keep, "three channels", "a reflectance is coloured");
    } else {
      decide("coloured F0", Verdict::replace, "one channel", "every reflectance is grey");
    }
    decide("mip level", lobes_.is_textured ? Verdict::keep : Verdict::replace,
           lobes_.is_textured ? "of the pixel's power" : "a constant of the material", is_one ? one : powers);
  }

  /// What a constant in place of the weight (1 - c)^5 would be off by, at most.
  double error_without_fresnel() const {
    double largest = 0;
    for (std::size_t i = 0; i < plan_.materials.size(); ++i) {
      const Material& material = scene_.materials[i];
      if (!plan_.materials[i].has_lobe || material.fresnel == FresnelTerm::none) continue;
      const double normalisation = game_normalisation(powers_of(material).most);
      for (const Range& f0 : material.f0) {
        const double rise =
            std::max(std::abs(material.f90.most - f0.least), std::abs(material.f90.least - f0.most));
        largest = std::max(largest, std::min(1.0, rise * normalisation));
      }
    }
    return largest;
  }

  void decide_fresnel() {
    if (!lobes_.has_schlick) {
      decide("Fresnel", Verdict::skip, "", "the format has none: Ks times the lobe");
      return;
    }
    const double skipped = error_without_fresnel();
    if (skipped <= for_fresnel * budget_) {
      decide("Fresnel", Verdict::skip, "F0", "F90 is next to F0", skipped);
    } else {
      decide("Fresnel", Verdict::keep, "F0 + (F90 - F0) (1 - c)^5 by three multiplications",
             "exact, and no dearer than exp2((a c + b) c)");
    }
  }

  /// g c^n <= e below c = (e/g)^(1/n); of the powers of a texture with the least n and the largest g.
  void decide_culling() {
    const double error = for_cutoff * budget_;
    double least = 1;
    for (MaterialPlan& material : plan_.materials) {
      if (!material.has_lobe) continue;
      constexpr double downwards = 1 - 0x1p-40;  // more than all of it rounds
      const double n = material.power.least;
      material.cutoff = n > 0 ? std::exp(std::log(error / material.factor) / n) * downwards : 0;
      least = std::min(least, material.cutoff);
    }
    if (least > 0) {
      decide("culling", Verdict::keep, "where n.h < " + decimal(least, 3) + " or more, by material",
             "a light adds less there", error);
    } else {
      decide("culling", Verdict::skip, "", "a lobe reaches every light");
    }
  }

  void sum_up() {
    // A pixel is of one material: it has a lobe, with the errors of its terms, or it has none.
    double of_lobes = 0, of_materials = 0;
    for (const Decision& decision : plan_.decisions)
      (decision.term == "specular" ? of_materials : of_lobes) += decision.error;
    plan_.error = plan_.wanted.lights * std::max(of_lobes, of_materials);
    plan_.fits_skipped = static_cast<int>(fittable_families().size()) - plan_.fits_run;
  }

  const Scene& scene_;
  const Checkpoint& checkpoint_;
  double budget_;  ///< of one light
  Plan plan_;
  Lobes lobes_;
};

}  // namespace

std::string_view name(Verdict verdict) {
  return verdict == Verdict::keep ? "keep" : verdict == Verdict::replace ? "replace" : "skip";
}

Plan make_plan(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint) {
  return Planner(scene, wanted, checkpoint).plan();
}

}  // namespace shadefit::scene
