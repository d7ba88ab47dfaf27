#pragma once

#include <filesystem>

#include "fit/study/study_file.hpp"

namespace shadefit {

/// Reads the measured rows of a study from a file of comma-separated values. Where they have `sigma` and the
/// study has no weight, the weight becomes 1/sigma. Throws UserError like `read_measured_rows`, and for a
/// relative error with such a weight.
void load_rows(StudyFile& file, const std::filesystem::path& table);

}  // namespace shadefit
