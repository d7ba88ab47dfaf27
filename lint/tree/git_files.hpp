#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The files of a work tree of git.
namespace shadefit::lint {

/// The nearest folder with a .git, from a folder up. The path must be absolute.
std::optional<std::filesystem::path> repository_of(const std::filesystem::path& folder);

/// What git lists below a folder of a work tree, given by its absolute path: the files that it tracks,
/// perhaps deleted ones too, and those that no rule of the tree ignores; and each repository within as one
/// name. By rising name, relative to the folder. Empty if git is missing or refuses, as it does for a tree of
/// another user. Nothing that the configuration of the tree names is run, and nothing is asked or fetched.
std::optional<std::vector<std::string>> git_files(const std::filesystem::path& folder);

}  // namespace shadefit::lint
