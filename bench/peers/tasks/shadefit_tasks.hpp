#pragma once

#include <vector>

#include "bench/peers/tasks/task_program.hpp"

namespace peer_tasks {

/// Minimax fits, the largest error of the published pair, and normalisations.
std::vector<Variant> other_tasks();

}  // namespace peer_tasks
