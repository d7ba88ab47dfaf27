#pragma once

#include <cstddef>
#include <functional>

#include "fit/support/checkpoint.hpp"

/// Independent pieces of work on all cores.
namespace shadefit {

/// How many threads this process can run at once, at least 1.
unsigned cores();

/// The piece of work number `place`. Its checkpoint may end it, see `Checkpoint`.
using PieceOfWork = std::function<void(std::size_t place, const Checkpoint& checkpoint)>;

/// How the work is done.
struct InParallel {
  Checkpoint before_each = keep_going;  ///< called before each piece
  Checkpoint checkpoint = keep_going;   ///< called by the checkpoints that the pieces get
  unsigned threads = cores();           ///< at most so many; the calling thread is one of them
};

/// Calls `work` once for each place from 0 to count - 1. The threads take places in rising order. Let a piece
/// store its result at its place: then results do not depend on the number of threads.
///
/// Both functions of `how` are called by one thread at a time, though not by the same one: they need not be
/// safe under threads. `work` must be.
///
/// Throws what a loop over the places would throw: the exception of the first place that fails. Places behind
/// it are not begun, or end at their next checkpoint; those before it go on, because they may fail too. An
/// exception of `how` (an interruption) ends all of them.
void for_each_in_parallel(std::size_t count, const PieceOfWork& work, const InParallel& how = {});

}  // namespace shadefit
