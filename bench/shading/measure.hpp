#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/shading/ways.hpp"
#include "bench/timing/timing.hpp"
#include "fit/support/checkpoint.hpp"
#include "scene/plan/shown_scale.hpp"

/// The times and errors of the ways on one workload, and of plans for other tolerances.
///
/// Only the specular term is timed, with given cosines, in float, on one core, with data in the caches: the
/// geometry of a pixel is the same for all ways. Every way skips black materials, and they are not in the
/// times: a time is per sample of the other materials. The reference and the published constants compute
/// every term. They decode a textured power, and take any other from the material. The published lobe is also
/// measured in the plan's kernel, which culls.
namespace shadefit::shade {

/// Errors against the reference, of each sample under one light, over all samples and channels.
struct Errors {
  double most = 0, mean = 0;              ///< in linear values
  double most_codes = 0, mean_codes = 0;  ///< in 8-bit sRGB codes, not rounded

  double most_on(scene::ShownScale scale) const {
    return scale == scene::ShownScale::linear ? most : most_codes;
  }
};

/// The errors of each way.
std::vector<Errors> errors_of(const Workload& workload, const ReferenceWay& reference,
                              std::span<const Way> ways, const Checkpoint& checkpoint = keep_going);

struct MeasuredWay {
  std::string name;                      ///< "reference", "published", "published, culled" or "planned"
  std::optional<double> tolerance = {};  ///< of a plan
  std::string form;                      ///< of the lobe
  double ns = 0;                         ///< a sample
  Errors errors = {};                    ///< against the reference, of one light
  double allowed = 0;                    ///< of a plan: error of one light, on its scale
  std::string device = {};               ///< of a broken promise: its id; empty: this processor
};

/// The same ways on another device: a thread shades a pixel, under many lights one after the other. All cores
/// work. Of a time, what a pass without lights takes is subtracted: arithmetic is timed, not memory.
struct DeviceMeasurement {
  std::string id = {};                 ///< "vulkan:0"
  std::string name = {};               ///< of the device and of its driver
  std::string clock = {};              ///< of the times, in words
  std::vector<MeasuredWay> ways = {};  ///< reference, published, "published, culled", planned
  double empty_ns = 0;                 ///< of a pixel, without lights: to read and to write it
  std::size_t pixels = 0, lights = 0;  ///< of a pass
};

/// The shares of the work that the plan skips, each relative to the rest after the one before.
struct Skipped {
  double by_materials = 0;  ///< of the samples: their material is not black and has no lobe
  double by_terms = 0;      ///< of the cost of a sample in operations
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
  MeasuredWay planned = {};             ///< by the given plan
  std::vector<MeasuredWay> sweep = {};  ///< by plans for tolerances of 1/32 .. 1/4096 of white
  Skipped skipped = {};
  std::optional<DeviceMeasurement> on_device = {};

  bool is_published_within() const { return published_culled.errors.most_on(scale) <= planned.allowed; }
};

/// The plans with a larger error than they promise: that would be our error.
std::vector<MeasuredWay> broken_promises(const Measurement& measurement);

/// Relative to white, in the order of the sweep.
inline constexpr std::array swept_tolerances{1.0 / 32,  1.0 / 64,   1.0 / 128,  1.0 / 255,
                                             1.0 / 512, 1.0 / 1024, 1.0 / 2048, 1.0 / 4096};

/// The error of one light that a plan allows. A plan that cannot keep its tolerance promises its own error.
double allowed_error(const scene::Plan& plan);

/// The cost of a sample in operations of a shader; EXP2 and LOG2 count as four each: for the reference's
/// three channels, with the decoding and the normalisation of a power that belongs to the pixel.
int full_operations(bool is_power_of_pixel);

/// The same for a sample that a plan does not cull.
int planned_operations(const PlannedMaterial& material);

/// How many samples of a workload are of materials that are not black.
std::size_t shaded_samples(const scene::Scene& scene, const Workload& workload);

/// The forms of the lobe, as a table names them.
std::string published_form();
std::string form_of(const scene::Plan& plan);

/// The duration of the measurement.
inline constexpr bench::TimingPlan full_plan{.rounds = 7, .seconds = 0.015};
/// For tests, which do not use times.
inline constexpr bench::TimingPlan quick_plan{.rounds = 1, .seconds = 0};

/// `watch` gets the finished share of the timing, from 0 to 1.
Measurement measure(
    const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels,
    const bench::TimingPlan& timing, const Checkpoint& checkpoint = keep_going,
    const std::function<void(double)>& watch = [](double) {});

}  // namespace shadefit::shade
