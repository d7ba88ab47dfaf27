#pragma once

#include <string>
#include <vector>

namespace shadefit {

/// Throws UserError unless `id` is one of `known`. The message suggests the known ids that begin so, or the
/// nearest one, or lists all if none is near. `what` is the word for such an id.
void require_known(const std::string& id, const std::vector<std::string>& known, const std::string& what);

}  // namespace shadefit
