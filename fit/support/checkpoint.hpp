#pragma once

#include <functional>

/// Where long work may be given up.
namespace shadefit {

/// Called by long work and by writers at places where nothing is lost if they end there. It returns to go on,
/// and throws to end the work; what it throws passes through untouched, and everything half-done is undone on
/// its way.
using Checkpoint = std::function<void()>;

/// The checkpoint of work that nothing interrupts.
inline void keep_going() {}

}  // namespace shadefit
