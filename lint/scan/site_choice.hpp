#pragma once

#include <vector>

#include "lint/scan/sites.hpp"

namespace shadefit::lint {

/// The sites to keep, by their places, of those that have numbers in common: see `sites_of`.
std::vector<Site> chosen_sites(std::vector<Site> sites, const ReadSite& read);

}  // namespace shadefit::lint
