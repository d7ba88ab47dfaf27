#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "scene/materials/material.hpp"
#include "scene/plan/lobe_form.hpp"
#include "scene/plan/rounding_error.hpp"
#include "scene/plan/shown_scale.hpp"

/// What a shading needs for a scene's own materials, within a tolerance: each term is kept, replaced by the
/// cheapest form that is near enough, or skipped.
///
/// The shading is that of one light: F (n + 2)/8 c^n (n.l), F by Schlick, c = n.h, a unit light of games,
/// clamped to [0, 1]. Where a normal is turned away from the viewer, n.v < 0, n.l counts as 2 n.h at most:
/// `seen_light`, which the code computes. An error is one of that result, in linear values or in sRGB codes,
/// and the sum of all of a pixel's errors over all lights stays below the tolerance. Errors are proven, in
/// exact arithmetic, and what the pixel's precision rounds comes on top; the cosines themselves are taken as
/// given.
namespace shadefit::scene {

struct Wanted {
  double tolerance = 1.0 / 255;  ///< on the scale, above 0
  int lights = 1;                ///< that may shine on one point, at least 1
  ShownScale scale = ShownScale::linear;
  PixelPrecision precision = PixelPrecision::float32;
};

enum class Treatment { keep, replace, skip };

std::string_view name(Treatment treatment);

/// What becomes of one term.
struct Decision {
  std::string term;  ///< "specular lobe" ..
  Treatment treatment;
  std::string form;  ///< what is computed; empty where nothing is
  std::string reason;
  double error = 0;  ///< of one light's result, at most, on the scale
};

/// What becomes of one material.
struct MaterialPlan {
  std::string name;
  bool has_lobe = false;
  std::string reason;  ///< why it has none; empty where it has one
  Range power = {};    ///< of its lobe
  double factor = 0;   ///< the largest F (n + 2)/8
  /// Below this n.h a light adds less than the error that is set aside for it, and need not be asked. 0: of
  /// every light.
  double cutoff = 0;
  double error = 0;  ///< of one light, where it has no lobe and might have had one
};

/// What is computed where a material has a lobe.
struct PlannedShading {
  LobeForm lobe;
  bool has_fresnel = true;        ///< else F0 stands for the reflectance
  bool is_coloured = true;        ///< else one channel does
  bool is_power_of_pixel = true;  ///< else of the material
  /// Where the pixel's power is its own, a lobe of at most 2^this need not be finished: no light adds more
  /// than the error that is set aside.
  double least_exponent = 0;
  /// Of the polynomial that does for exp2 where a processor has none; 0: there is no exp2.
  int exp2_degree = 0;
};

struct Plan {
  Wanted wanted;
  PlannedShading shading;
  std::vector<Decision> decisions;
  std::vector<MaterialPlan> materials;
  double error = 0;  ///< of all lights together, at most
  /// What one light is moved by, at most, where n.h comes from a dot product in the pixel's precision, by any
  /// form: not in `error`.
  double dot_product_error = 0;
  std::vector<std::string> notes;  ///< what the plan does not count, and what was changed, a line each
  int fits_run = 0;
  int fits_skipped = 0;  ///< of those that a whole catalogue of constants would take
  bool is_within() const { return error <= wanted.tolerance; }
  bool has_lobes() const;
};

/// The form as it is written: "exp2(A c - A), A = (n + 0.775)/ln 2".
std::string to_text(const LobeForm& form);

/// Decides for a scene with at least one material.
Plan make_plan(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::scene
