#pragma once

#include <vector>

#include "bench/peers/tasks/task_program.hpp"

namespace peer_tasks {

/// Minimax fits, the largest error of the published pair, normalisations, and fits from text.
std::vector<Task> other_tasks();

}  // namespace peer_tasks
