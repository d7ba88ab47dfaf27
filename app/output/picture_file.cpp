#include "app/output/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/output/output_file.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/plots.hpp"
#include "reports/io/gnuplot.hpp"

namespace shadefit {
namespace {

constexpr std::array<std::string_view, 3> endings{".svg", ".pdf", ".png"};

}  // namespace

void require_picture(const std::string& file) {
  const bool is_known = std::any_of(endings.begin(), endings.end(),
                                    [&](std::string_view ending) { return file.ends_with(ending); });
  if (!is_known) throw UserError(fmt::format("--plot '{}' must end with .svg, .pdf or .png", file));
  if (!find_gnuplot())
    throw UserError(fmt::format("--plot '{}' needs gnuplot: install the package gnuplot-nox", file));
}

std::function<void()> draw_picture(const Figure& figure, const std::string& file, bool force,
                                   const Checkpoint& checkpoint) {
  require_picture(file);
  const OutputFile output(file, "the picture");
  const std::string ending = file.substr(file.size() - endings.front().size());
  const std::string name = figure.name + (ending == ".svg" ? "" : ending);
  const Pictures pictures = draw_pictures(*find_gnuplot(), plot_files({figure}), {name}, checkpoint);
  if (!pictures.failed.empty())
    throw UserError(fmt::format("--plot '{}' was not drawn: {}", file, pictures.failed.front().complaint));
  return output.prepare(pictures.files.front().content, force, checkpoint);
}

}  // namespace shadefit
