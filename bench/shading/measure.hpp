#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/shading/errors.hpp"
#include "bench/timing/timing.hpp"

/// The ways on one workload: how long they take and how wrong they are, and the same of plans for other
/// tolerances.
///
/// What is timed is the specular term alone, its cosines given, in float on one core with its data in the
/// caches: the geometry of a pixel is the same for all. Black materials are skipped by every way and are in
/// no time: a time is that of a sample of the others. The reference and the published constants decode a
/// power where it is textured, take it from the material elsewhere, and compute every term; the published
/// lobe is also measured in the plan's own kernel, which culls.
namespace shadefit::shade {

struct MeasuredWay {
  std::string name;                      ///< "reference", "published", "published, culled" or "planned"
  std::optional<double> tolerance = {};  ///< of a plan
  std::string form;                      ///< of the lobe
  double ns = 0;                         ///< a sample
  Errors errors = {};                    ///< against the reference, of one light
  double allowed = 0;                    ///< of a plan: error of one light, on its scale
};

/// Shares of the work that the plan leaves out, each of what the one before has left.
struct Skipped {
  double by_materials = 0;  ///< of the samples: their material is not black and has no lobe
  double by_terms = 0;      ///< of what a sample costs, as operations.hpp counts
  double by_culling = 0;    ///< of the samples
};

struct Measurement {
  forms::Width width;
  scene::ShownScale scale;
  std::size_t samples = 0;  ///< of materials that are not black
  std::size_t lights = 1;   ///< that were shaded
  bool is_half = false;     ///< the plan is for half; all of this is float
  MeasuredWay reference = {}, published = {};
  MeasuredWay published_culled = {};    ///< the published lobe in the kernel of the plan
  MeasuredWay planned = {};             ///< by the plan that is given
  std::vector<MeasuredWay> sweep = {};  ///< by plans for tolerances of 1/32 .. 1/4096 of white
  Skipped skipped = {};

  bool is_published_within() const { return published_culled.errors.most_on(scale) <= planned.allowed; }
};

/// The plans whose errors are not what they promise, which would be an error of ours.
std::vector<MeasuredWay> broken_promises(const Measurement& measurement);

/// Of white, in the order of the sweep.
inline constexpr std::array swept_tolerances{1.0 / 32,  1.0 / 64,   1.0 / 128,  1.0 / 255,
                                             1.0 / 512, 1.0 / 1024, 1.0 / 2048, 1.0 / 4096};

/// How long is measured.
inline constexpr bench::Plan full_plan{.rounds = 7, .seconds = 0.015};
/// For tests, which look at no time.
inline constexpr bench::Plan quick_plan{.rounds = 1, .seconds = 0};

/// `watch` is told the share of the timing that is done, from 0 to 1.
Measurement measure(
    const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels, const bench::Plan& timing,
    const Checkpoint& checkpoint = keep_going, const std::function<void(double)>& watch = [](double) {});

}  // namespace shadefit::shade
