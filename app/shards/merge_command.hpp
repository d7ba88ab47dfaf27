#pragma once

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// Writes what one process would have written without --shard. Throws UserError unless the parts are all
/// shards of one work of this version.
Outcome merge_command(const MergeOptions& options, const Checkpoint& checkpoint);

}  // namespace shadefit
