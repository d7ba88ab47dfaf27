#include "scene/plan/plan.hpp"

#include <algorithm>
#include <cmath>

#include "approx/gloss.hpp"
#include "fit/fit.hpp"
#include "fit/support/decimal.hpp"
#include "scene/materials/powers.hpp"
#include "scene/plan/choose_exp2.hpp"
#include "scene/plan/choose_lobe.hpp"
#include "scene/plan/lobes.hpp"

namespace shadefit::scene {
namespace {

/// How a light's share of the tolerance is spent. The cut-off gets 10 %: it costs lit pixels no instruction,
/// and a lobe's width depends only on the logarithm of the threshold. The Fresnel term is cheap to keep, so
/// little is reserved for dropping it. The lobe gets the rest.
constexpr double for_cutoff = 0.1, for_fresnel = 0.3;

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

/// What the plan does not cover, what was changed, and what engines would change, one line each.
std::vector<std::string> notes_of(const Scene& scene, const Plan& plan) {
  std::vector<std::string> notes;
  const PixelPrecision precision = plan.wanted.precision;
  if (plan.dot_product_error > 0) {
    notes.push_back("n.h by a dot product in " + std::string(name(precision)) + " is off by " +
                    decimal_above(dot_product_rounding(precision), 3) + ", which moves a light by up to " +
                    decimal_above(plan.dot_product_error, 2) + " more, whatever the form: not counted");
  }
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

/// Safety factor, larger than the rounding of a computed cut-off.
constexpr double downwards = 1 - 0x1p-40;

/// The least of (s (n + 2))^(-1/(n + shift)) over a range of powers, 1 at most. Its logarithm's slope has the
/// sign of log(s (n + 2)) - (n + shift)/(n + 2), which rises with n: so the function falls to a single
/// minimum and then rises.
double least_root(double s, double shift, const Range& powers) {
  const auto rises = [&](double n) { return std::log(s * (n + 2)) > (n + shift) / (n + 2); };
  double n = powers.least, high = powers.most;
  for (double middle = n; !rises(n) && (middle = n + (high - n) / 2) > n && middle < high;)
    (rises(middle) ? high : n) = middle;
  return n + shift > 0 ? std::min(1.0, std::exp(-std::log(s * (n + 2)) / (n + shift))) : 0;
}

/// A light adds at most g min(1, 2c) c^n, g = F (n + 2)/8. This is at most e for c below (e/g)^(1/n), and for
/// c below (e/(2 g))^(1/(n + 1)). The larger of both is at least the larger of their minima.
///
/// Returns a cosine n.h in [0, 1]. Below it a light adds at most `error` to a material's displayed value, in
/// linear values, for every power of the material.
double cutoff_of(double error, const Material& material) {
  const double per_error = largest_reflectance(material) / 8 / error;
  const Range powers = powers_of(material);
  return std::max(least_root(2 * per_error, 1, powers), least_root(per_error, 0, powers)) * downwards;
}

class Planner {
 public:
  Planner(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint)
      : scene_(scene), checkpoint_(checkpoint), budget_(wanted.tolerance / wanted.lights) {
    plan_.wanted = wanted;
  }

  Plan plan() && {
    decide_materials();
    if (lobes_.are_none()) {
      skip_all();
    } else {
      decide_fresnel();
      decide_horizon();
      decide_culling();
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
    plan.name = material.name;
    plan.power = powers_of(material);
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
    for (const char* term : {"Fresnel", "n.v < 0", "culling", "lobe", "offset x", "exp2", "rounding", "power",
                             "gloss decode", "normalisation", "mip level", "coloured F0"})
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

  void decide_horizon() {
    if (is_constant()) {
      decide("n.v < 0", Treatment::skip, "", "every power is 0");
    } else {
      decide("n.v < 0", Treatment::keep, "min(n.l, 2 n.h)",
             "equals n.l where n.v >= 0; limits a light where a normal map turns the normal away");
    }
  }

  /// Whether every power is 0: then n.h is not needed.
  bool is_constant() const { return lobes_.range().most == 0; }

  void decide_culling() {
    if (is_constant()) {
      decide("culling", Treatment::skip, "", "no light falls with n.h");
      return;
    }
    const double spent = for_cutoff * budget_, error = from_scale(scale(), spent) * downwards;
    double least = 1, largest = 0;
    for (std::size_t i = 0; i < plan_.materials.size(); ++i) {
      MaterialPlan& material = plan_.materials[i];
      if (!material.has_lobe) continue;
      material.cutoff = cutoff_of(error, scene_.materials[i]);
      least = std::min(least, material.cutoff);
      largest = std::max(largest, material.factor);
    }
    plan_.shading.least_exponent = std::log2(error / largest) * (error < largest ? 1 / downwards : downwards);
    left_ -= spent;
    decide("culling", Treatment::keep,
           lobes_.is_textured() ? "where n.h < " + decimal_below(least, 3) + " or the lobe < 2^" +
                                      decimal(plan_.shading.least_exponent, 3)
                                : "where n.h < " + decimal_below(least, 3) + " (higher for some)",
           "a light adds less there", spent);
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
    plan_.fits_run = chosen.fits_run;
    const bool is_kept = chosen.form.kind == LobeKind::power;
    decide("lobe",
           is_kept                                  ? Treatment::keep
           : chosen.form.kind == LobeKind::constant ? Treatment::skip
                                                    : Treatment::replace,
           to_text(chosen.form), reason_of(chosen), chosen.error);
    const bool has_offset = chosen.form.offset != 0;
    decide("offset x", has_offset ? Treatment::keep : Treatment::skip,
           has_offset ? "x = " + decimal(chosen.form.offset, 6) : "",
           has_offset ? "best for this scene's powers, by how often each is used; its ADD is the material's"
           : chosen.form.kind != LobeKind::exponential ? "no Gaussian"
           : chosen.form.slopes.size() > 1             ? "the slopes do its work"
                                                       : "0 is near enough");
    decide_exp2(chosen.form, left_ - chosen.error - chosen.rounding);
    const bool is_float = plan_.wanted.precision == PixelPrecision::float32;
    decide("rounding", Treatment::keep, std::string(name(plan_.wanted.precision)),
           is_float ? "each operation by 2^-24, exp2 and log2 by eight times that"
                    : "each operation by 2^-11, exp2 and log2 too; powers up to 65504",
           chosen.rounding);
  }

  std::string reason_of(const ChosenLobe& chosen) const {
    if (chosen.form.kind == LobeKind::constant) return "every power is 0";
    if (chosen.form.kind == LobeKind::multiplied) return "one whole power: exact";
    constexpr double large = 100;
    const bool is_bright = lobes_.range().most > large;
    const std::string why = chosen.cheaper.empty() ? "the cheapest, and near enough"
                            : is_bright ? chosen.cheaper + ": (n + 2)/8 cancels its smaller error for large n"
                                        : chosen.cheaper;
    if (chosen.mean_error == 0) return why;
    return why + "; powers weighted by their use: mean error " + decimal(chosen.mean_error, 2) +
           ", minimax constants have " + decimal(chosen.mean_error_of_level, 2);
  }

  void decide_exp2(const LobeForm& form, double left) {
    if (form.kind == LobeKind::constant || form.kind == LobeKind::multiplied) {
      decide("exp2", Treatment::skip, "", "none is computed");
      return;
    }
    const ChosenExp2 chosen = choose_exp2(left, scale());
    plan_.shading.exp2_degree = chosen.degree;
    decide("exp2", Treatment::replace, "of degree " + std::to_string(chosen.degree),
           "for processors without exp2: the cheapest that is accurate enough", chosen.error);
  }

  void decide_power() {
    const Range range = lobes_.range();
    const std::string one = "one power for the whole scene: " + decimal(range.least, 6);
    const std::string powers = "powers from " + decimal(range.least, 3) + " to " + decimal(range.most, 3);
    plan_.shading.is_power_of_pixel = lobes_.is_textured();
    if (lobes_.is_textured()) {
      decide("power", Treatment::keep, "for each pixel", powers);
      decide_decode();
      decide("normalisation", Treatment::keep, "(n + 2)/8", powers);
      decide("mip level", Treatment::keep, "of the pixel's power", powers);
    } else {
      const bool is_one = lobes_.is_one_power();
      const std::string reason = is_one ? one : powers + ", one for each material";
      decide("power", is_one ? Treatment::skip : Treatment::replace, is_one ? "" : "for each material",
             reason);
      decide("gloss decode", Treatment::skip, "", is_one ? one : "no power comes from a texture");
      decide("normalisation", Treatment::replace,
             is_one ? decimal(game_normalisation(range.least), 6) : "a constant of the material", reason);
      decide("mip level", Treatment::replace, "a constant of the material", reason);
    }
  }

  /// Decides the conversion of a texture's number to a power.
  void decide_decode() {
    const auto has = [&](PowerTexture texture) { return lobes_.textures.contains(texture); };
    const bool is_gloss_a_power = has(PowerTexture::gloss) && scene_.conventions.is_gloss_exponential;
    const bool is_by_alpha = has(PowerTexture::roughness) || (has(PowerTexture::gloss) && !is_gloss_a_power);
    std::vector<std::string> forms;
    if (is_by_alpha) forms.emplace_back("n = 2/alpha^2 - 2");
    if (is_gloss_a_power) forms.emplace_back("n = 2^(10 g + 1)");
    if (forms.empty()) {
      decide("gloss decode", Treatment::skip, "", "the textures hold powers");
    } else {
      decide("gloss decode", Treatment::keep, enumerated(forms), "a texture holds it");
    }
  }

  void decide_colour() {
    plan_.shading.is_coloured = lobes_.is_coloured;
    const std::string metal = lobes_.has_metal ? "metals among them" : "no metal";
    decide("coloured F0", lobes_.is_coloured ? Treatment::keep : Treatment::replace,
           lobes_.is_coloured ? "three channels" : "one channel",
           (lobes_.is_coloured ? "a reflectance is coloured, " : "every reflectance is grey, ") + metal);
  }

  void sum_up() {
    // A pixel has one material: either with a lobe and the errors of its terms, or without a lobe.
    double of_lobes = 0, of_materials = 0;
    for (const Decision& decision : plan_.decisions)
      (decision.term == "specular lobe" ? of_materials : of_lobes) += decision.error;
    plan_.error = plan_.wanted.lights * std::max(of_lobes, of_materials);
    if (!lobes_.are_none() && !is_constant())
      plan_.dot_product_error = dot_product_error(lobes_, plan_.wanted.precision, scale());
    plan_.fits_skipped = static_cast<int>(fittable_families().size()) + lobe_fits - plan_.fits_run;
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
