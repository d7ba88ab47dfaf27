#pragma once

#include <string>
#include <vector>

#include "fit/checkpoint.hpp"
#include "scene/material.hpp"

/// What a shading needs for a scene's own materials, within a tolerance: each term is kept, replaced by the
/// cheapest form that is near enough, or skipped.
///
/// The shading is that of one light: F (n + 2)/8 c^n (n.l), F by Schlick, c = n.h, a unit light of games,
/// clamped to [0, 1]. An error is one of that result, in linear values, and the sum of all of a pixel's
/// errors over all lights stays below the tolerance. Errors are proven, in exact arithmetic.
namespace shadefit::scene {

struct Wanted {
  double tolerance = 1.0 / 255;  ///< in linear values, above 0
  int lights = 1;                ///< that may shine on one point, at least 1
};

enum class Verdict { keep, replace, skip };

std::string_view name(Verdict verdict);

/// What becomes of one term.
struct Decision {
  std::string term;  ///< "specular lobe" ..
  Verdict verdict;
  std::string form;  ///< what is computed; empty where nothing is
  std::string reason;
  double error = 0;  ///< of one light's result, at most
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

struct Plan {
  Wanted wanted;
  std::vector<Decision> decisions;
  std::vector<MaterialPlan> materials;
  double error = 0;  ///< of all lights together, at most
  int fits_run = 0;
  int fits_skipped = 0;  ///< of those that a whole catalogue of constants would take
  bool is_within() const { return error <= wanted.tolerance; }
};

/// Decides for a scene with at least one material.
Plan make_plan(const Scene& scene, const Wanted& wanted, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::scene
