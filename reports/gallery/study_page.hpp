#pragma once

#include <string>

#include "reports/gallery/gallery.hpp"

namespace shadefit {

/// The page of a study: what it approximates, each published set with its verdict, the errors as a picture,
/// the comparison, and code to copy.
std::string study_page(const GalleryEntry& entry);

}  // namespace shadefit
