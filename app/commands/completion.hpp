#pragma once

#include <string>

namespace CLI {
class App;
}

namespace shadefit {

/// What a shell needs to complete the commands, options and ids of `app`, for "bash", "zsh" or "fish"; or the
/// manual page, for "man". Throws UserError for another word.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace shadefit
