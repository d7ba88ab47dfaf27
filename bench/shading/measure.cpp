#include "bench/shading/measure.hpp"

#include <algorithm>
#include <span>

#include "approx/lobe.hpp"
#include "bench/timing/statistics.hpp"

namespace shadefit::shade {
namespace {

/// The plan, then those of the sweep.
std::vector<scene::Plan> with_sweep(const scene::Scene& scene, const scene::Plan& plan,
                                    const Checkpoint& checkpoint) {
  std::vector<scene::Plan> plans{plan};
  for (const double tolerance : swept_tolerances) {
    scene::Wanted wanted = plan.wanted;
    wanted.tolerance = tolerance * scene::on_scale(wanted.scale, 1);  // in codes relative to white, 255
    plans.push_back(scene::make_plan(scene, wanted, checkpoint));
  }
  return plans;
}

/// ns per sample of the whole workload by each way, one after the other: the median of the rounds, in
/// processor time of this thread.
std::vector<double> times_of(const Workload& workload, std::span<const FloatWay> ways, std::size_t samples,
                             const bench::TimingPlan& timing, const std::function<void(double)>& between) {
  Results<float> results(workload.tiles());
  std::vector<bench::Work> work;
  for (const FloatWay& way : ways) {
    const auto shade = [&workload, &results, &way] {
      for (const Visit& visit : workload.visits()) {
        if (!way.has_lobe(visit.material)) continue;
        Block<float> block = workload.block<float>(visit);
        block.out = results.out();
        way.shade(block, visit.material);
        bench::keep(block.out[0]);
      }
    };
    work.push_back({.once = shade, .elements = std::max<std::size_t>(1, samples)});
  }
  std::vector<double> times;
  for (const bench::Samples& of_way : bench::time_interleaved(work, timing, bench::now, between))
    times.push_back(bench::spread_of(of_way.cpu).median);
  return times;
}

Skipped skipped_by(const scene::Scene& scene, const scene::Plan& plan, const Workload& workload,
                   const FloatWay& way) {
  Results<float> results(workload.tiles());
  double all = 0, with_lobe = 0, culled = 0, full = 0, planned = 0;
  for (const Visit& visit : workload.visits()) {
    const scene::Material& material = scene.materials[visit.material];
    if (is_black(material)) continue;
    const auto samples = static_cast<double>(workload.samples_of_visit());
    all += samples;
    const auto constants = planned_material(material, plan.materials[visit.material], plan.shading);
    if (!constants) continue;
    with_lobe += samples;
    full += full_operations(material.is_power_textured());
    planned += planned_operations(*constants);
    Block<float> block = workload.block<float>(visit);
    block.out = results.out();
    culled += static_cast<double>(way.shade(block, visit.material));
  }
  Skipped skipped{.by_materials = all > 0 ? 1 - with_lobe / all : 1};
  if (with_lobe > 0) {
    skipped.by_terms = 1 - planned / full;
    skipped.by_culling = culled / with_lobe;
  }
  return skipped;
}

}  // namespace

double allowed_error(const scene::Plan& plan) {
  return std::max(plan.wanted.tolerance, plan.error) / plan.wanted.lights;
}

std::size_t shaded_samples(const scene::Scene& scene, const Workload& workload) {
  const auto shaded =
      std::count_if(workload.visits().begin(), workload.visits().end(),
                    [&](const Visit& visit) { return !is_black(scene.materials[visit.material]); });
  return static_cast<std::size_t>(shaded) * workload.samples_of_visit();
}

std::string published_form() {
  return "exp2(A c - A), A = (n + " + std::string(sg_offset_published[0].printed) + ")/ln 2";
}

std::string form_of(const scene::Plan& plan) {
  return plan.has_lobes() ? to_text(plan.shading.lobe) : "no lobe";
}

std::vector<MeasuredWay> broken_promises(const Measurement& measurement) {
  std::vector<MeasuredWay> all{measurement.planned};
  all.insert(all.end(), measurement.sweep.begin(), measurement.sweep.end());
  if (measurement.on_device) {
    all.push_back(measurement.on_device->ways.back());
    all.back().device = measurement.on_device->id;
  }
  std::erase_if(all,
                [&](const MeasuredWay& way) { return way.errors.most_on(measurement.scale) <= way.allowed; });
  return all;
}

Measurement measure(const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels,
                    const bench::TimingPlan& timing, const Checkpoint& checkpoint,
                    const std::function<void(double)>& watch) {
  const std::vector<scene::Plan> plans = with_sweep(scene, plan, checkpoint);
  const Workload workload(scene, plan.wanted.lights);
  const ReferenceWay reference(scene, kernels);
  std::vector<FloatWay> ways{
      {scene, kernels.reference}, {scene, kernels.published}, {scene, with_published_lobe(plan), kernels}};
  const std::size_t first_planned = ways.size();
  for (const scene::Plan& some : plans) ways.emplace_back(scene, some, kernels);
  std::vector<Way> shown;
  for (const FloatWay& way : ways) shown.push_back(way_of(way));
  const std::vector<Errors> errors = errors_of(workload, reference, shown, checkpoint);
  const auto between = [&](double share) {
    checkpoint();
    watch(share);
  };
  Measurement result{.width = kernels.width, .scale = plan.wanted.scale};
  result.samples = shaded_samples(scene, workload);
  result.lights = workload.lights();
  result.is_half = plan.wanted.precision == scene::PixelPrecision::float16;
  const std::vector<double> ns = times_of(workload, ways, result.samples, timing, between);
  const std::string published = published_form();
  result.reference = {.name = "reference", .form = "pow", .ns = ns[0], .errors = errors[0]};
  result.published = {.name = "published", .form = published, .ns = ns[1], .errors = errors[1]};
  result.published_culled = {
      .name = "published, culled", .form = published, .ns = ns[2], .errors = errors[2]};
  for (std::size_t i = 0; i < plans.size(); ++i) {
    MeasuredWay& way = i == 0 ? result.planned : result.sweep.emplace_back();
    way = {.name = "planned",
           .tolerance = plans[i].wanted.tolerance,
           .form = form_of(plans[i]),
           .ns = ns[first_planned + i],
           .errors = errors[first_planned + i],
           .allowed = allowed_error(plans[i])};
  }
  result.skipped = skipped_by(scene, plan, workload, ways[first_planned]);
  return result;
}

}  // namespace shadefit::shade
