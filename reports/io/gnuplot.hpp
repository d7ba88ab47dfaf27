#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/io/files.hpp"

/// Runs gnuplot, which may be missing or fail.
namespace shadefit {

/// The program `gnuplot` of an absolute directory of the PATH, or nothing.
std::optional<std::filesystem::path> find_gnuplot();

/// A plot that could not be drawn, and gnuplot's last message.
struct FailedPlot {
  std::string name;
  std::string complaint;
};

/// Pictures, and the plots that could not be drawn.
struct Pictures {
  std::vector<File> files;  ///< "plots/NAME.svg"
  std::vector<FailedPlot> failed;
};

/// How long gnuplot may take for one picture: ours take less than 0.1 s. So even a machine that is a
/// hundred times slower draws them, and a gnuplot that hangs does not stop a run for ever.
inline constexpr std::chrono::seconds longest_drawing{60};

/// Draws the plots of `names` at the same time from their files, "plots/NAME.csv" and "plots/NAME.gnuplot",
/// in a temporary directory. The checkpoint is called repeatedly while gnuplot works. If it throws, or a
/// picture takes `longest`, gnuplot is ended. Throws UserError where there can be no such directory.
Pictures draw_pictures(const std::filesystem::path& gnuplot, const std::vector<File>& files,
                       const std::vector<std::string>& names, const Checkpoint& checkpoint = keep_going,
                       std::chrono::seconds longest = longest_drawing);

}  // namespace shadefit
