#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/catalogue/study_file.hpp"

/// Where studies are found.
namespace shadefit {

/// The folders with studies, first come first found: those given, and the one that came with the command.
/// Throws UserError if a given path is not a folder.
std::vector<std::filesystem::path> study_folders(const std::vector<std::string>& given);

/// The files NAME.toml of these folders, by rising name. A name that a folder before has is left out.
std::vector<std::filesystem::path> study_files(const std::vector<std::filesystem::path>& folders);

/// The same, and those of exact constants, which stand in the folder `exact` of each: what `lint` knows.
std::vector<std::filesystem::path> known_study_files(std::vector<std::filesystem::path> folders);

/// The ids of the studies in these folders, rising.
std::vector<std::string> study_ids(const std::vector<std::filesystem::path>& folders);

/// The study that an argument names: a file whose name ends with .toml, or the id of a file in the folders.
/// Empty if there is no such id. Throws UserError for a file that is missing, too large or not a study.
std::optional<StudyFile> find_study(const std::string& name,
                                    const std::vector<std::filesystem::path>& folders);

/// The same. Throws UserError for an unknown id, with the nearest one.
StudyFile named_study(const std::string& name, const std::vector<std::filesystem::path>& folders);

/// Reads a study from its file. Throws UserError like `read_study_file`, and for a table outside of the
/// folder of the file.
StudyFile load_study(const std::filesystem::path& path);

struct LoadedStudies {
  std::vector<StudyFile> files = {};
  std::vector<std::string> refused = {};  ///< a line for each study that could not be read
};

/// Reads studies for a verb that goes over all of them: one that is refused does not end it.
LoadedStudies load_studies(const std::vector<std::filesystem::path>& paths);

/// Reads the measured rows of a study from the text of a file; `measured` is the column of their values, and
/// `shown` names the file in what is printed.
/// Where they have `sigma` and the study has no weight, the weight becomes 1/sigma. Throws UserError like
/// `read_measured_rows`, and for a relative error with such a weight.
void take_rows(StudyFile& file, const TextParts& text, const std::string& table, const std::string& measured,
               const OthersText& shown);

/// The most bytes of a study: pages of text.
inline constexpr std::uintmax_t most_study_bytes = 1U << 20;

}  // namespace shadefit
