#pragma once

#include <functional>

/// Places where long work can be stopped.
namespace shadefit {

/// Long work and writers call it at places where they can end without loss. It returns to go on, and throws
/// to end the work. Its exception passes through, and everything half-done is undone on its way.
using Checkpoint = std::function<void()>;

/// The checkpoint that never interrupts.
inline void keep_going() {}

}  // namespace shadefit
