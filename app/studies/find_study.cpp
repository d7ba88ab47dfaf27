#include "app/studies/find_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "fit/better/results.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/input/known.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_claims.hpp"
#include "fit/verdicts/study_verdict.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// The studies that came with the command: beside an installed one, or in its source tree.
std::vector<fs::path> own_folders() {
  std::error_code none;
  const fs::path command = fs::read_symlink("/proc/self/exe", none);
  if (none) return {};
  const fs::path folder = command.parent_path();
  return {folder / "../share/shadefit/studies", folder / "../../studies", folder / "../../../studies"};
}

/// Reads all formulas of a study, and compares the published sets with the parameters of their forms. What is
/// refused is refused with the name of the file.
void require_formulas(const StudyFile& file, const fs::path& path) {
  const std::string of = "study '" + printable(path.string()) + "'";
  std::string id;  // of the form that is read
  std::set<std::string> parameters;
  try {
    Study study = combinations(file.study, file.given).front();
    for (const StudyForm& form : file.forms) {
      id = form.id;
      take_form(study, form);
      const ReadStudy read = read_formulas(study);
      if (read.residual) require_residual(read);
      parameters.insert(read.parameters.begin(), read.parameters.end());
      for (const PublishedSet& set : file.published) {
        if (set.form != form.id) continue;
        values_of(set, read.parameters);
        for (const ErrorClaim& claim : set.claims) study_of(claim, study);
      }
    }
    for (const ParameterBounds& bounds : file.study.bounds) {
      if (!parameters.contains(bounds.parameter))
        throw StudyFault({"--bounds", bounds.parameter}, fmt::format(" '{}': no form has a parameter '{}'",
                                                                     to_text(bounds), bounds.parameter));
    }
    if (file.recompute) read_recompute(study, *file.recompute);
  } catch (const StudyFault& fault) {
    throw UserError(of + fault_in(file, fault, id));
  } catch (const UserError& error) {
    throw UserError(of + ": " + error.what());
  }
}

/// The table of a study. It lies in the folder of the study, links resolved: else the study of another could
/// name any file.
fs::path table_of(const fs::path& study, const StudyFile& file) {
  std::error_code none;
  const fs::path folder = fs::canonical(fs::absolute(study).parent_path(), none);
  const fs::path table = fs::weakly_canonical(folder / file.table.unescaped(), none);
  if (std::mismatch(folder.begin(), folder.end(), table.begin(), table.end()).first == folder.end())
    return table;
  const StudyFault fault(
      {"table"},
      fmt::format(" '{}' leads out of the folder of the study: a table lies in it", file.table.unescaped()));
  throw UserError("study '" + study.string() + "'" + fault_in(file, fault, ""));
}

}  // namespace

std::vector<fs::path> study_folders(const std::vector<std::string>& given) {
  std::vector<fs::path> folders(given.begin(), given.end());
  for (const fs::path& folder : folders) {
    std::error_code none;
    if (!fs::is_directory(folder, none))
      throw UserError("--studies '" + folder.string() + "' is not a folder");
  }
  for (const fs::path& own : own_folders()) {
    std::error_code none;
    if (!fs::is_directory(own, none)) continue;
    folders.push_back(own);
    break;
  }
  return folders;
}

std::vector<fs::path> study_files(const std::vector<fs::path>& folders) {
  std::vector<fs::path> files;
  std::set<std::string> seen;
  for (const fs::path& folder : folders) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".toml" && seen.insert(path.stem().string()).second) files.push_back(path);
    }
  }
  std::ranges::sort(files, {}, [](const fs::path& file) { return file.stem(); });
  return files;
}

std::vector<fs::path> known_study_files(std::vector<fs::path> folders) {
  const std::size_t count = folders.size();
  for (std::size_t i = 0; i < count; ++i) folders.push_back(folders[i] / "exact");
  return study_files(folders);
}

std::vector<std::string> study_ids(const std::vector<fs::path>& folders) {
  std::vector<std::string> ids;
  for (const fs::path& file : study_files(folders)) ids.push_back(file.stem().string());
  return ids;
}

void take_rows(StudyFile& file, const TextParts& text, const std::string& table, const std::string& measured,
               const OthersText& shown) {
  std::vector<std::string> variables;
  for (const StudyRange& range : file.study.over) variables.push_back(range.variable);
  auto rows = std::make_shared<MeasuredRows>(read_measured_rows(text, table, variables, measured));
  rows->file = shown;
  file.study.rows = std::move(rows);
  if (file.study.rows->sigma.empty() || file.has_weight) return;
  if (file.study.error == Error::relative)
    throw UserError(
        "--error 'relative' needs a --weight, as the table has sigma: 1/sigma weights errors that are absolute");
  file.study.weight = "1/sigma";
}

StudyFile load_study(const fs::path& path) {
  StudyFile file = read_study_file(read_bounded(path, most_study_bytes), printable(path.string()));
  if (!file.table.empty()) {
    const fs::path table = table_of(path, file);
    // What is printed names the file as the study does, wherever the study lies.
    take_rows(file, parts_of(table, most_row_bytes), table.string(), "value", file.table);
  }
  require_formulas(file, path);
  return file;
}

LoadedStudies load_studies(const std::vector<fs::path>& paths) {
  LoadedStudies loaded;
  for (const fs::path& path : paths) {
    try {
      loaded.files.push_back(load_study(path));
    } catch (const UserError& error) {
      loaded.refused.push_back(fmt::format("{}; it is left out", one_line(error.what())));
    }
  }
  return loaded;
}

std::optional<StudyFile> find_study(const std::string& name, const std::vector<fs::path>& folders) {
  if (name.ends_with(".toml")) return load_study(name);
  for (const fs::path& file : known_study_files(folders)) {
    if (file.stem() == name) return load_study(file);
  }
  return std::nullopt;
}

StudyFile named_study(const std::string& name, const std::vector<fs::path>& folders) {
  if (auto found = find_study(name, folders)) return *std::move(found);
  if (is_known_id(name))
    throw UserError(fmt::format("'{0}' is built in, no study: see 'shadefit run --only {0}'", name));
  require_known(name, study_ids(folders), "study");
  return {};
}

}  // namespace shadefit
