#include "app/output/draw_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "fit/support/user_error.hpp"
#include "reports/figures/figures.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
DrawnFigures draw_figures(std::vector<Figure>& figures, const std::string& out,
                          const Checkpoint& checkpoint) {
  DrawnFigures drawn{plot_files(figures), {}, {}, {}};
  const std::size_t all = figures.size();
  const auto directory = printable((std::filesystem::path(out) / "plots").string());
  for (const Figure& figure : figures) drawn.missing.push_back({"plots/" + figure.name + ".svg", ""});
  if (const auto gnuplot = all > 0 ? find_gnuplot() : std::nullopt) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) names.push_back(figure.name);
    const Pictures pictures = draw_pictures(*gnuplot, drawn.files, names, checkpoint);
    drawn.files.insert(drawn.files.end(), pictures.files.begin(), pictures.files.end());
    std::erase_if(drawn.missing, [&](const File& missing) {
      return std::ranges::find(pictures.files, missing.name, &File::name) != pictures.files.end();
    });
    for (const FailedPlot& failed : pictures.failed) {
      drawn.err +=
          fmt::format("shadefit: plot {} was not drawn: {}\n", failed.name, one_line(failed.complaint));
      std::erase_if(figures, [&](const Figure& figure) { return figure.name == failed.name; });
    }
    drawn.out = fmt::format("\nPlots: {} of {} drawn in {}\n", figures.size(), all, directory);
  } else if (all > 0) {
    figures.clear();
    drawn.out =
        fmt::format("\nPlots skipped: gnuplot was not found; their data and scripts are in {}\n", directory);
  }
  return drawn;
}

void require_picture(const std::string& file) {
  if (!file.ends_with(".svg")) throw UserError(fmt::format("--plot '{}' must end with .svg", file));
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (std::error_code none; !folder.empty() && !std::filesystem::is_directory(folder, none))
    throw UserError(
        fmt::format("--plot '{}' names no folder that is there: make '{}' first", file, folder.string()));
  if (!find_gnuplot())
    throw UserError(fmt::format("--plot '{}' needs gnuplot: install the package gnuplot-nox", file));
}

}  // namespace shadefit
