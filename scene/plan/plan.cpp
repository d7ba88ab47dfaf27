#include "scene/plan/plan.hpp"

#include <algorithm>
#include <cmath>

#include "approx/gloss.hpp"
#include "fit/support/decimal.hpp"
#include "scene/materials/conversions.hpp"
#include "scene/plan/choose_lobe.hpp"
#include "scene/plan/lobes.hpp"

namespace shadefit::scene {
namespace {

/// The Fresnel term is cheap to keep, so little of a light's share of the tolerance is spent on dropping it.
/// The lobe gets the rest.
constexpr double for_fresnel = 0.3;

/// The number of materials with a lobe and a roughness below the minimum of engines.
long smooth_materials(const Scene& scene, const Plan& plan) {
  const double most = power_of_roughness(least_engine_roughness, scene.conventions);
  long smooth = 0;
  for (std::size_t i = 0; i < plan.materials.size(); ++i) {
    const bool has_roughness = scene.materials[i].fresnel == FresnelTerm::schlick;
    if (plan.materials[i].has_lobe && has_roughness && plan.materials[i].power.most > most) ++smooth;
  }
  return smooth;
}

/// What is done with small roughness, or what engines would do.
std::vector<std::string> notes_of(const Scene& scene, const Plan& plan) {
  std::vector<std::string> notes;
  const double least = scene.conventions.min_roughness;
  if (least > 0) {
    notes.push_back("a roughness below " + decimal(least, 4) + " is taken for it");
  } else if (const long smooth = smooth_materials(scene, plan); smooth > 0) {
    notes.push_back("the roughness of " + counted(smooth, "material") +
                    " falls below 0.045, the least that engines keep (Filament; three.js has 0.0525): "
                    "--min-roughness takes it for more");
  }
  return notes;
}

class Planner {
 public:
  Planner(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint)
      : scene_(scene), checkpoint_(checkpoint), budget_(wanted.tolerance / wanted.lights) {
    plan_.wanted = wanted;
  }

  Plan plan() && {
    decide_materials();
    if (lobes_.all.empty()) {
      skip_all();
    } else {
      decide_fresnel();
      decide_lobe();
      decide_power();
      decide_colour();
    }
    sum_up();
    plan_.notes = notes_of(scene_, plan_);
    return std::move(plan_);
  }

 private:
  ShownScale scale() const { return plan_.wanted.scale; }

  void decide(std::string term, Treatment treatment, std::string form, std::string reason, double error = 0) {
    plan_.decisions.push_back({std::move(term), treatment, std::move(form), std::move(reason), error});
  }

  MaterialPlan plan_material(const Material& material) const {
    MaterialPlan plan;
    plan.power = material.power;
    plan.factor = largest_factor(material, plan.power.most);
    const double shown = on_scale(scale(), plan.factor);
    if (material.is_unlit) {
      plan.reason = "unlit";
    } else if (largest_reflectance(material) == 0) {
      plan.reason = "black specular colour";
    } else if (shown <= budget_) {
      plan.reason = "at most " + decimal_above(shown, 2) +
                    (scale() == ShownScale::linear ? " of a light" : " sRGB codes of a light");
      plan.error = shown;
    } else {
      plan.has_lobe = true;
    }
    return plan;
  }

  void decide_materials() {
    std::vector<bool> has_lobe;
    double error = 0;
    for (const Material& material : scene_.materials) {
      plan_.materials.push_back(plan_material(material));
      has_lobe.push_back(plan_.materials.back().has_lobe);
      error = std::max(error, plan_.materials.back().error);
    }
    lobes_ = lobes_of(scene_.materials, has_lobe);
    const auto total = static_cast<long>(has_lobe.size());
    const auto needed = std::count(has_lobe.begin(), has_lobe.end(), true);
    const std::string all = counted(total, "material");
    if (needed == total) {
      decide("specular lobe", Treatment::keep, "for " + all, "every material has one", error);
    } else {
      decide("specular lobe", needed == 0 ? Treatment::skip : Treatment::replace,
             needed == 0 ? "" : "for " + std::to_string(needed) + " of " + all,
             "skipped for " + std::to_string(total - needed) + " of " + all, error);
    }
  }

  void skip_all() {
    plan_.shading = {};
    plan_.shading.lobe.kind = LobeKind::constant;
    for (const char* term :
         {"Fresnel", "lobe", "rounding", "power", "gloss decode", "normalisation", "coloured F0"})
      decide(term, Treatment::skip, "", "no material needs a specular lobe");
  }

  /// A bound of the error of F0 in place of the reflectance.
  double error_without_fresnel() const {
    double largest = 0;
    for (std::size_t i = 0; i < plan_.materials.size(); ++i) {
      const Material& material = scene_.materials[i];
      if (!plan_.materials[i].has_lobe || material.fresnel == FresnelTerm::none) continue;
      const double normalisation = game_normalisation(plan_.materials[i].power.most);
      for (const Range& f0 : material.f0) {
        const double rise =
            std::max(std::abs(material.f90.most - f0.least), std::abs(material.f90.least - f0.most));
        largest = std::max(largest, on_scale(scale(), rise * normalisation));
      }
    }
    return largest;
  }

  void decide_fresnel() {
    const double skipped = error_without_fresnel();
    plan_.shading.has_fresnel = lobes_.has_schlick && skipped > for_fresnel * budget_;
    if (!lobes_.has_schlick) {
      decide("Fresnel", Treatment::skip, "", "the format has none: Ks times the lobe");
    } else if (!plan_.shading.has_fresnel) {
      decide("Fresnel", Treatment::skip, "F0", "F90 is next to F0", skipped);
      left_ -= skipped;
    } else {
      decide("Fresnel", Treatment::keep, "F0 + (F90 - F0) (1 - c)^5, three multiplications",
             "exact, and cheaper than exp2((a c + b) c)");
    }
  }

  void decide_lobe() {
    const LobeBudget budget{.allowed = left_,
                            .scale = scale(),
                            .precision = plan_.wanted.precision,
                            .has_fresnel = plan_.shading.has_fresnel,
                            .is_gloss_exponential = lobes_.textures.contains(PowerTexture::gloss) &&
                                                    scene_.conventions.is_gloss_exponential};
    const ChosenLobe chosen = choose_lobe(lobes_, budget, checkpoint_);
    plan_.shading.lobe = chosen.form;
    const LobeKind kind = chosen.form.kind;
    decide("lobe",
           kind == LobeKind::power      ? Treatment::keep
           : kind == LobeKind::constant ? Treatment::skip
                                        : Treatment::replace,
           to_text(chosen.form), chosen.reason, chosen.error);
    const bool is_float = plan_.wanted.precision == PixelPrecision::float32;
    decide("rounding", Treatment::keep, std::string(name(plan_.wanted.precision)),
           is_float ? "each operation by 2^-24, exp2 and log2 by eight times that"
                    : "each operation by 2^-11, exp2 and log2 too; powers up to 65504",
           chosen.rounding);
  }

  void decide_power() {
    const Range range = lobes_.range();
    const std::string one = "one power for the whole scene: " + decimal(range.least, 6);
    const std::string powers = "powers from " + decimal(range.least, 3) + " to " + decimal(range.most, 3);
    plan_.shading.is_power_of_pixel = lobes_.is_textured();
    if (lobes_.is_textured()) {
      decide("power", Treatment::keep, "for each pixel", powers);
      const auto& textures = lobes_.textures;
      if (textures.contains(PowerTexture::roughness) || textures.contains(PowerTexture::gloss)) {
        decide("gloss decode", Treatment::keep, "for each pixel", "a texture holds it");
      } else {
        decide("gloss decode", Treatment::skip, "", "the textures hold powers");
      }
      decide("normalisation", Treatment::keep, "(n + 2)/8", powers);
    } else {
      const bool is_one = lobes_.is_one_power();
      const std::string reason = is_one ? one : powers + ", one for each material";
      decide("power", is_one ? Treatment::skip : Treatment::replace, is_one ? "" : "for each material",
             reason);
      decide("gloss decode", Treatment::skip, "", is_one ? one : "no power comes from a texture");
      decide("normalisation", Treatment::replace,
             is_one ? decimal(game_normalisation(range.least), 6) : "a constant of the material", reason);
    }
  }

  void decide_colour() {
    if (lobes_.is_coloured) {
      decide("coloured F0", Treatment::keep, "three channels", "a reflectance is coloured");
    } else {
      decide("coloured F0", Treatment::replace, "one channel", "every reflectance is grey");
    }
  }

  void sum_up() {
    // A pixel has one material: either with a lobe and the errors of its terms, or without a lobe.
    double of_lobes = 0, of_materials = 0;
    for (const Decision& decision : plan_.decisions)
      (decision.term == "specular lobe" ? of_materials : of_lobes) += decision.error;
    plan_.error = plan_.wanted.lights * std::max(of_lobes, of_materials);
  }

  const Scene& scene_;
  const Checkpoint& checkpoint_;
  double budget_;          ///< of one light
  double left_ = budget_;  ///< the unspent part of the budget
  Plan plan_;
  Lobes lobes_;
};

}  // namespace

std::string_view name(Treatment treatment) {
  return treatment == Treatment::keep ? "keep" : treatment == Treatment::replace ? "replace" : "skip";
}

bool Plan::has_lobes() const {
  return std::any_of(materials.begin(), materials.end(), [](const MaterialPlan& m) { return m.has_lobe; });
}

std::string to_text(const LobeForm& form) {
  switch (form.kind) {
    case LobeKind::constant:
      return "1";
    case LobeKind::multiplied:
      return "c^" + std::to_string(form.whole) + " by multiplications";
    case LobeKind::power:
      return "exp2(n log2(c))";
    case LobeKind::exponential:
      break;
  }
  constexpr int digits = 6;
  if (form.slopes.size() == 1) {
    const std::string sharpness =
        form.offset == 0 ? "n/ln 2" : "(n + " + decimal(form.offset, digits) + ")/ln 2";
    return (form.is_fused ? "exp2(A c - A), A = " : "exp2(A (c - 1)), A = ") + sharpness;
  }
  std::string sum = decimal(form.slopes.back(), digits);
  for (std::size_t i = form.slopes.size() - 1; i > 0; --i)
    sum = decimal(form.slopes[i - 1], digits) + " + y (" + sum + ")";
  return "exp2(n y (" + sum + ")), y = c - 1";
}

Plan make_plan(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint) {
  return Planner(scene, wanted, checkpoint).plan();
}

}  // namespace shadefit::scene
