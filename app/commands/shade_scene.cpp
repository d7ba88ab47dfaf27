#include "app/commands/shade_scene.hpp"

#include <fmt/format.h>

#include "app/output/draw_figures.hpp"
#include "bench/device/scenes/measure_scene.hpp"
#include "bench/shading/measure.hpp"
#include "bench/shading/picture.hpp"
#include "bench/shading/tables.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

constexpr const char* picture_name = "scene.png";

/// Draws the spheres if gnuplot is installed.
void draw_spheres(ShadedScene& shaded, const std::vector<File>& files, const std::string& out,
                  const Checkpoint& checkpoint) {
  shaded.missing.push_back({picture_name, ""});
  const auto gnuplot = find_gnuplot();
  if (!gnuplot) {
    shaded.out += "\nPicture skipped: gnuplot was not found\n";
    return;
  }
  const Pictures pictures = draw_pictures(*gnuplot, files, {picture_name}, checkpoint);
  for (const FailedPlot& failed : pictures.failed)
    shaded.err += fmt::format("shadefit: {} was not drawn: {}\n", failed.name, one_line(failed.complaint));
  for (const File& file : pictures.files) {
    shaded.files.push_back({picture_name, file.content});
    std::erase_if(shaded.missing, [](const File& missing) { return missing.name == picture_name; });
    shaded.out += fmt::format("\nPicture: {}\n", printable((without_detours(out) / picture_name).string()));
  }
}

}  // namespace

std::vector<File> files_of_shading() {
  return {{"shade.csv", "way,tolerance,form"},
          {picture_name, ""},
          {"plots/shade.csv", "ns,planned,published"},
          {"plots/shade.gnuplot", ""},
          {"plots/shade.svg", ""}};
}

ShadedScene shade_scene(const scene::Scene& scene, const scene::Plan& plan,
                        const std::optional<std::size_t>& device, const std::optional<std::string>& out,
                        const Terminal& terminal, const Checkpoint& checkpoint, const Progress& progress) {
  const shade::Kernels kernels = shade::kernels_here().back();
  // Before the CPU is measured: without a device there is nothing to wait for.
  std::optional<device::SceneDevice> graphics;
  if (device) graphics.emplace(device::DeviceChoice{.place = *device}, device::largest_pass(scene, plan));
  shade::Measurement measured =
      shade::measure(scene, plan, kernels, shade::full_plan, checkpoint, bar(progress, "shade"));
  const shade::ReferenceWay reference(scene, kernels);
  if (graphics) {
    measured.on_device = device::measure_scene(*graphics, scene, plan, reference, shade::full_plan,
                                               checkpoint, bar(progress, "shade there"));
    measured.on_device->id = fmt::format("vulkan:{}", *device);
  }
  progress("");
  ShadedScene shaded{.out = shade::shade_text(measured, terminal), .err = shade::broken_lines(measured)};
  if (!out) return shaded;
  shaded.files.push_back({"shade.csv", write_csv(shade::shade_table(measured), Precision::report)});
  std::vector<Figure> figures{shade::shade_figure(measured)};
  const DrawnFigures drawn = draw_figures(figures, *out, checkpoint);
  shaded.files.insert(shaded.files.end(), drawn.files.begin(), drawn.files.end());
  shaded.missing = drawn.missing;
  shaded.out += drawn.news.out;
  shaded.err += drawn.news.err;
  const shade::FloatWay here(scene, plan, kernels);
  std::vector<shade::ShownWay> ways{{"planned", shade::way_of(here)}};
  if (graphics)
    ways.push_back({measured.on_device->id, graphics->way(scene, device::planned_shader(scene, plan))});
  draw_spheres(shaded, shade::picture_files(scene, plan, reference, ways), *out, checkpoint);
  return shaded;
}

}  // namespace shadefit
