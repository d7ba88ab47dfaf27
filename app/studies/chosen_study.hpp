#pragma once

#include <optional>

#include "app/options/options.hpp"
#include "fit/study/study_file.hpp"

namespace shadefit {

/// The study that the options state or name: --target, --form and --over of the command line, or the file or
/// the id of a study, changed by the options that are present. Empty if the id is built in. Throws UserError
/// for an unknown id and for options that belong to built-in families.
std::optional<StudyFile> chosen_study(const FitOptions& options);

}  // namespace shadefit
