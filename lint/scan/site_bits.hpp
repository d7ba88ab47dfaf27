#pragma once

#include <string_view>
#include <vector>

#include "lint/scan/sites.hpp"

namespace shadefit::lint {

/// How much evidence the numbers of a site are: -log2 of the chance that as many numbers at random places
/// agree as well. What counts: the digits of each number, its place among the other numbers, the published
/// order, and the names beside it.
double bits_of(std::string_view text, const std::vector<Literal>& literals, const KnownSet& set,
               const Site& site);

}  // namespace shadefit::lint
