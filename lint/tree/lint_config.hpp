#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lint/tree/source_language.hpp"

/// What a project says once for all: .shadefit.toml.
namespace shadefit::lint {

/// The table [lint]. Nothing is set that the file does not set.
struct LintConfig {
  std::filesystem::path file;             ///< where it was read
  std::vector<std::string> exclude = {};  ///< globs as in .gitignore, from the folder of the file
  std::vector<SourceLanguage> languages = {};
  std::optional<std::string> fail_on = {};             ///< from which verdict on
  std::optional<double> max_effect = {};               ///< the largest effect that passes, at least 0
  std::optional<std::filesystem::path> baseline = {};  ///< from the current folder
  std::vector<std::string> paths = {};                 ///< from the current folder
};

/// The name of the file.
inline constexpr const char* lint_config_name = ".shadefit.toml";

/// Reads a configuration. `file` is its path: messages name it, and `baseline` and `paths` are relative to
/// its folder. `verdicts`: the words that fail-on may be. Throws UserError with the line: not TOML, a key or
/// a word that is unknown (with the nearest one), a value of another type, a max-effect that is negative or
/// not finite, a text that is empty.
LintConfig read_lint_config(const std::string& text, const std::filesystem::path& file,
                            const std::vector<std::string>& verdicts);

/// The configuration of the nearest folder that has one, from the current folder up to that of its
/// repository; outside of a repository only the current folder, because a folder above may be another user's.
/// Nothing if there is none. Throws UserError like `read_lint_config`, and for a file that cannot be read.
std::optional<LintConfig> find_lint_config(const std::vector<std::string>& verdicts);

}  // namespace shadefit::lint
