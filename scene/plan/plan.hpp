#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "scene/materials/material.hpp"
#include "scene/plan/lobe_form.hpp"
#include "scene/plan/rounding_error.hpp"
#include "scene/plan/shown_scale.hpp"

/// Plans the shading for a scene's materials within a tolerance: each term is kept, replaced by the cheapest
/// form that is accurate enough, or skipped.
///
/// The shading of one light is F (n + 2)/8 c^n (n.l), clamped to [0, 1]: F by Schlick, c = n.h, a unit light
/// of games. If a normal is turned away from the viewer, n.v < 0, n.l is limited to 2 n.h; the code computes
/// this as `seen_light`. Errors are those of this result, in linear values or in sRGB codes. The sum of a
/// pixel's errors over all lights stays below the tolerance. Errors are proven in exact arithmetic, and the
/// rounding of the pixel's precision is added. The cosines themselves count as exact.
namespace shadefit::scene {

struct Wanted {
  double tolerance = 1.0 / 255;  ///< on `scale`, above 0
  int lights = 1;                ///< the most lights on one point, at least 1
  ShownScale scale = ShownScale::linear;
  PixelPrecision precision = PixelPrecision::float32;
};

enum class Treatment { keep, replace, skip };

std::string_view name(Treatment treatment);

/// The decision about one term.
struct Decision {
  std::string term;  ///< "specular lobe" ..
  Treatment treatment;
  std::string form;  ///< the computed form; empty if none
  std::string reason;
  double error = 0;  ///< upper bound for one light's result, on the scale
};

/// The decisions about one material.
struct MaterialPlan {
  bool has_lobe = false;
  std::string reason;  ///< why it has no lobe; empty if it has one
  Range power = {};    ///< of its lobe
  double factor = 0;   ///< the largest F (n + 2)/8
  double error = 0;    ///< of one light, if its lobe was dropped
};

/// The shading of materials with a lobe.
struct PlannedShading {
  LobeForm lobe;
  bool has_fresnel = true;        ///< else F0 replaces the reflectance
  bool is_power_of_pixel = true;  ///< else the power is that of the material
};

struct Plan {
  Wanted wanted;
  PlannedShading shading;
  std::vector<Decision> decisions;
  std::vector<MaterialPlan> materials;
  double error = 0;                ///< upper bound for all lights together
  std::vector<std::string> notes;  ///< on small roughness
  bool is_within() const { return error <= wanted.tolerance; }
  bool has_lobes() const;
};

/// The form as text: "exp2(A c - A), A = (n + 0.775)/ln 2".
std::string to_text(const LobeForm& form);

/// Makes the plan for a scene with at least one material.
Plan make_plan(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::scene
