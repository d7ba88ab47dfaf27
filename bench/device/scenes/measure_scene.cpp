#include "bench/device/scenes/measure_scene.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "bench/device/dispatches.hpp"
#include "bench/shading/picture.hpp"
#include "bench/shading/workload.hpp"
#include "bench/timing/statistics.hpp"

namespace shadefit::device {
namespace {

/// Lights per pixel in a pass. The most are for a device that is a thousand times as fast as a CPU.
constexpr std::uint32_t fewest_lights = 16, most_lights = 1U << 14;

/// In seconds: about the longest time of a pass with the fewest lights. A slow device gets fewer pixels, so
/// that it can have many lights.
constexpr double first_pass = 0.002;

/// A pass has enough lights if the same pass without lights takes at most this share of its time.
constexpr double empty_share = 0.05;

/// The pixels of all materials that are not black.
std::vector<ShaderPixel> lit_pixels(const shade::Workload& workload, const scene::Scene& scene) {
  std::vector<ShaderPixel> all;
  for (const shade::Visit& visit : workload.visits()) {
    if (shade::is_black(scene.materials[visit.material])) continue;
    const shade::SingleLights<float> single(workload.block<float>(visit));
    auto pixels = pixels_of(single.block(), scene.materials[visit.material].power_texture, scene.conventions);
    for (ShaderPixel& pixel : pixels) pixel.material = static_cast<std::uint32_t>(visit.material);
    all.insert(all.end(), pixels.begin(), pixels.end());
  }
  return all;
}

/// A share of the tiles, spread evenly, but at least one tile.
std::vector<ShaderPixel> thinned(const std::vector<ShaderPixel>& pixels, double share) {
  const std::size_t tiles = pixels.size() / shade::tile_pixels;
  const auto kept =
      std::clamp<std::size_t>(static_cast<std::size_t>(share * static_cast<double>(tiles)), 1, tiles);
  std::vector<ShaderPixel> thin;
  for (std::size_t i = 0; i < kept; ++i) {
    const auto tile = std::span(pixels).subspan(i * tiles / kept * shade::tile_pixels, shade::tile_pixels);
    thin.insert(thin.end(), tile.begin(), tile.end());
  }
  return thin;
}

/// The passes of all shaders over the same pixels, timed.
class Passes {
 public:
  /// `least` is the least time of a pass in seconds. Tests pass 0: then the fewest lights are enough.
  Passes(SceneDevice& device, const std::vector<SceneShader>& shaders, std::vector<ShaderPixel> pixels,
         double least)
      : device_(device), shaders_(shaders) {
    for (const SceneShader& shader : shaders) programs_.push_back(device.load(shader));
    device.put_pixels(pixels);
    // A driver may compile a shader when it first runs.
    all_seconds(1);
    const double first = slowest_of(least_seconds(lights_));
    if (first > first_pass) pixels = thinned(pixels, first_pass / first);
    device.put_pixels(pixels);
    pixels_ = pixels.size();
    for (;; lights_ *= 2) {
      const std::vector<double> all = least_seconds(lights_);
      const double slowest = slowest_of(all);
      // A quarter of the limit, so that a dispatch with twice the lights is still below it.
      const double share = std::min(1.0, longest_dispatch / 4 / slowest);
      at_once_ =
          std::max(threads_per_group, static_cast<std::uint32_t>(share * static_cast<double>(pixels_)));
      const bool is_long = slowest >= least && (least == 0 || all.back() <= empty_share * slowest);
      if (is_long || lights_ == most_lights) break;
    }
  }

  std::size_t pixels() const { return pixels_; }
  std::uint32_t lights() const { return lights_; }

  /// The seconds of each pass, and last those of a pass without lights: medians of interleaved rounds.
  std::vector<double> medians(int rounds, const std::function<void(double)>& between) {
    std::vector<std::vector<double>> all(programs_.size() + 1);
    for (int round = 0; round < rounds; ++round) {
      between(static_cast<double>(round) / rounds);
      const std::vector<double> of_round = all_seconds(lights_);
      for (std::size_t i = 0; i < all.size(); ++i) all[i].push_back(of_round[i]);
    }
    std::vector<double> medians;
    for (auto& of_one : all) medians.push_back(bench::spread_of(std::move(of_one)).median);
    return medians;
  }

 private:
  double seconds(std::size_t i, std::uint32_t lights) {
    device_.put_materials(shaders_[i].materials);
    return device_.pass(programs_[i], lights, at_once_);
  }

  std::vector<double> all_seconds(std::uint32_t lights) {
    std::vector<double> all;
    for (std::size_t i = 0; i < programs_.size(); ++i) all.push_back(seconds(i, lights));
    all.push_back(seconds(programs_.size() - 1, 0));
    return all;
  }

  /// The quickest of a few passes: time that other programs take is not the device's.
  std::vector<double> least_seconds(std::uint32_t lights) {
    std::vector<double> least = all_seconds(lights);
    for (int more = 0; more < 2; ++more)
      std::ranges::transform(least, all_seconds(lights), least.begin(),
                             [](double a, double b) { return std::min(a, b); });
    return least;
  }

  static double slowest_of(const std::vector<double>& all) {
    return *std::max_element(all.begin(), all.end());
  }

  SceneDevice& device_;
  const std::vector<SceneShader>& shaders_;
  std::size_t pixels_ = 0;
  std::uint32_t at_once_ = 0;  ///< of `SceneDevice::pass`
  std::uint32_t lights_ = fewest_lights;
  std::vector<Program> programs_;
};

}  // namespace

PassSize largest_pass(const scene::Scene& scene, const scene::Plan& plan) {
  const shade::Workload workload(scene, plan.wanted.lights);
  return {std::max(workload.samples(), shade::pixels_of_sphere()), scene.materials.size()};
}

shade::DeviceMeasurement measure_scene(SceneDevice& device, const scene::Scene& scene,
                                       const scene::Plan& plan, const shade::ReferenceWay& reference,
                                       const bench::TimingPlan& timing, const Checkpoint& checkpoint,
                                       const std::function<void(double)>& watch) {
  const std::vector<SceneShader> shaders{reference_shader(scene), published_shader(scene),
                                         planned_shader(scene, shade::with_published_lobe(plan)),
                                         planned_shader(scene, plan)};
  shade::DeviceMeasurement measured;
  measured.name = name_with_driver(device.device().info());
  measured.clock = name_of_clock(device.device().info());
  measured.ways = {{.name = "reference", .form = "pow"},
                   {.name = "published", .form = shade::published_form()},
                   {.name = "published, culled", .form = shade::published_form()},
                   {.name = "planned", .tolerance = plan.wanted.tolerance, .form = shade::form_of(plan)}};
  measured.ways.back().allowed = shade::allowed_error(plan);

  const shade::Workload workload(scene, plan.wanted.lights);
  std::vector<shade::Way> ways;
  for (const SceneShader& shader : shaders) ways.push_back(device.way(scene, shader));
  const std::vector<shade::Errors> errors = shade::errors_of(workload, reference, ways, checkpoint);
  for (std::size_t i = 0; i < ways.size(); ++i) measured.ways[i].errors = errors[i];

  const std::vector<ShaderPixel> pixels = lit_pixels(workload, scene);
  if (pixels.empty()) return measured;
  Passes passes(device, shaders, pixels, timing.seconds);
  measured.pixels = passes.pixels();
  measured.lights = passes.lights();
  const auto between = [&](double share) {
    checkpoint();
    watch(share);
  };
  const std::vector<double> seconds = passes.medians(timing.rounds, between);
  const double ns = 1e9 / static_cast<double>(measured.pixels * measured.lights);
  for (std::size_t i = 0; i < ways.size(); ++i)
    measured.ways[i].ns = ns * std::max(0.0, seconds[i] - seconds.back());
  measured.empty_ns = 1e9 / static_cast<double>(measured.pixels) * seconds.back();
  return measured;
}

}  // namespace shadefit::device
