#pragma once

#include <functional>
#include <string_view>

/// What a command that takes seconds shows while it works.
namespace shadefit {

/// Called before each part of the work with its name, and with nothing at the end.
using Progress = std::function<void(std::string_view part)>;

/// For a pipe, a file or a test.
inline void in_silence(std::string_view) {}

/// One line on standard error that is written over, where that is a terminal; else silence.
Progress terminal_progress();

}  // namespace shadefit
