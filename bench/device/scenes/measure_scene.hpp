#pragma once

#include <functional>

#include "bench/device/scenes/scene_device.hpp"
#include "bench/shading/measure.hpp"

/// The times and errors of the ways to shade a scene, on a graphics device.
namespace shadefit::device {

/// The largest pass of a scene: its workload, or a sphere of its picture.
PassSize largest_pass(const scene::Scene& scene, const scene::Plan& plan);

/// Measures the same ways as `shade::measure`, on the same samples: pow with every term, the published
/// constants with every term, the published lobe in the plan's code, and the code of the plan.
///
/// A thread shades one pixel: it reads its inputs, adds up its lights and writes their sum. The time is that
/// of one more light: the time of a pass with many lights, less that of a pass with none, divided by the
/// lights. Both are medians of interleaved rounds. A dispatch takes about 50 ms at most.
shade::DeviceMeasurement measure_scene(
    SceneDevice& device, const scene::Scene& scene, const scene::Plan& plan,
    const shade::ReferenceWay& reference, const bench::TimingPlan& timing,
    const Checkpoint& checkpoint = keep_going, const std::function<void(double)>& watch = [](double) {});

}  // namespace shadefit::device
