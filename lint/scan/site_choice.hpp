#pragma once

#include <vector>

#include "lint/scan/sites.hpp"

namespace shadefit::lint {

/// Of sites that have numbers in common the ones to keep, by their places: see sites_of().
std::vector<Site> chosen_sites(std::vector<Site> sites, const ReadSite& read);

}  // namespace shadefit::lint
