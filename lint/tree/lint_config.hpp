#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lint/tree/source_language.hpp"

/// The settings of a project: .shadefit.toml.
namespace shadefit::lint {

/// The table [lint]. Members that the file does not set are empty.
struct LintConfig {
  std::filesystem::path file;             ///< where it was read
  std::vector<std::string> exclude = {};  ///< see `FolderGlobs`, relative to the folder of the file
  std::vector<SourceLanguage> languages = {};
  std::optional<std::string> fail_on = {};             ///< the least verdict that fails
  std::optional<double> max_effect = {};               ///< the largest effect that passes, at least 0
  std::optional<std::filesystem::path> baseline = {};  ///< relative to the current folder
  std::vector<std::string> paths = {};                 ///< relative to the current folder
};

/// The name of the file.
inline constexpr const char* lint_config_name = ".shadefit.toml";

/// Reads a configuration. `file` is its path: messages name it, and `baseline` and `paths` are relative to
/// its folder. `verdicts` are the words that fail-on may have. Throws UserError with the line for a text that
/// is not TOML, an unknown key or word (with the nearest one), a value of another type, a max-effect that is
/// negative or not finite, and an empty text.
LintConfig read_lint_config(const std::string& text, const std::filesystem::path& file,
                            const std::vector<std::string>& verdicts);

/// The configuration of the nearest folder that has one, from the current folder up to the root of its
/// repository. Outside of a repository only the current folder counts, because a folder above may be another
/// user's. Empty if there is none. Throws UserError as `read_lint_config` does, and for a file that cannot be
/// read.
std::optional<LintConfig> find_lint_config(const std::vector<std::string>& verdicts);

}  // namespace shadefit::lint
