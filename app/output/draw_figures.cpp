#include "app/output/draw_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/figures/plots.hpp"
#include "reports/io/gnuplot.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {

DrawnFigures draw_figures(std::vector<Figure>& figures, const std::string& out,
                          const Checkpoint& checkpoint) {
  DrawnFigures drawn{plot_files(figures), {}, {}};
  const std::size_t all = figures.size();
  const auto directory = printable((without_detours(out) / "plots").string());
  for (const Figure& figure : figures) drawn.missing.push_back({"plots/" + figure.name + ".svg", ""});
  if (const auto gnuplot = all > 0 ? find_gnuplot() : std::nullopt) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) names.push_back(figure.name);
    const Pictures pictures = draw_pictures(*gnuplot, drawn.files, names, checkpoint);
    drawn.files.insert(drawn.files.end(), pictures.files.begin(), pictures.files.end());
    std::erase_if(drawn.missing, [&](const File& missing) {
      return std::any_of(pictures.files.begin(), pictures.files.end(),
                         [&](const File& file) { return file.name == missing.name; });
    });
    for (const FailedPlot& failed : pictures.failed) {
      drawn.news.err +=
          fmt::format("shadefit: plot {} was not drawn: {}\n", failed.name, one_line(failed.complaint));
      std::erase_if(figures, [&](const Figure& figure) { return figure.name == failed.name; });
    }
    drawn.news.out = fmt::format("\nPlots: {} of {} drawn in {}\n", figures.size(), all, directory);
  } else if (all > 0) {
    figures.clear();
    drawn.news.out =
        fmt::format("\nPlots skipped: gnuplot was not found; their data and scripts are in {}\n", directory);
  }
  return drawn;
}

}  // namespace shadefit
