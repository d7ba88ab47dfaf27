#pragma once

#include <deque>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"

/// The files of studies/catalogue.
namespace shadefit {

struct Catalogue {
  std::vector<Family> families = {};      ///< those that only compare come last
  std::vector<Published> published = {};  ///< one for each number
  std::deque<StudyFile> files = {};       ///< what `published` points into
};

/// Reads the file of a study whose forms are families. Beside the keys of a study it has
/// - `error_of`: the target is a weight f, of the reflectance f0 + (1 - f0) f;
/// - `near_peak` of [target] and of a form: the same as a formula of y = 1 - c and of k, in which all digits
///   of a sharp lobe survive; the values of `k` in [given] are the exponents to fit by default;
/// - `title`, `variables`, `is_comparison`, `starts` and `starts_inside` of a form (`Family`);
/// - `id`, `statement` ("best", "mean", "limit", "somewhere"), `sweep` and `convention` of published values
///   (`Published`). An id of several values is followed by the name of the parameter.
/// Appends to the catalogue. Throws UserError like `read_study_file`.
void read_families(const std::string& text, const std::string& name, Catalogue& into);

}  // namespace shadefit
