#pragma once

#include <string>
#include <vector>

namespace shadefit {

/// Throws UserError, suggesting the nearest known id (all of them where none is near), unless `id` is one of
/// `known`. `what` says what it should name.
void require_known(const std::string& id, const std::vector<std::string>& known, const std::string& what);

}  // namespace shadefit
