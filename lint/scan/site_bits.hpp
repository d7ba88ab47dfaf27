#pragma once

#include <string_view>
#include <vector>

#include "lint/scan/sites.hpp"

namespace shadefit::lint {

/// How telling the numbers of a site are: log2 of how seldom as many numbers at random places agree as well.
/// The digits of each number tell, its place among the other numbers, the published order, and the names
/// beside it.
double bits_of(std::string_view text, const std::vector<Literal>& literals, const KnownSet& set,
               const Site& site);

}  // namespace shadefit::lint
