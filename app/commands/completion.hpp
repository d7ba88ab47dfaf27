#pragma once

#include <string>

namespace CLI {
class App;
}

namespace shadefit {

/// The completion script for the commands, options and ids of `app`, for "bash", "zsh" or "fish"; or the
/// manual page, for "man". Throws UserError for any other word.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace shadefit
