#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/io/files.hpp"

/// Writes results so that nothing is ever half-written and no file of others is touched.
namespace shadefit {

/// What happens to a file that shadefit did not write (`is_own`) under a name that is to be written.
enum class Foreign {
  refused,
  replaced,  ///< --force
};

/// Whether other runs may write to the directory meanwhile.
enum class Company { welcome, refused };

/// Files that are written into a directory all at once or not at all: `prepare` writes them into a directory
/// of its own there, `put` renames them into their places. Unless `put` completes, everything stays as
/// before.
class Output {
 public:
  /// Creates the directory (`without_detours`) and tries whether one can write to it. Throws UserError where
  /// one cannot, or where company is refused and another run has locked the directory.
  explicit Output(const std::filesystem::path& directory, Company company = Company::welcome);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Writes the files, and notes which of the `obsolete` are to be removed: those that are there and that
  /// shadefit wrote; their content is what such a file begins with. A file keeps the mode of the one that it
  /// replaces, and the owner where the system allows. The checkpoint is called before each file and once more
  /// at the end. Throws UserError naming the path and what went wrong; before anything is written, where a
  /// file of others or a directory has a name that is needed. To be called once.
  void prepare(const std::vector<File>& files, const std::vector<File>& obsolete, Foreign foreign,
               const Checkpoint& checkpoint = keep_going);

  /// Moves the files to their places and removes the obsolete ones. Throws UserError naming the path and what
  /// went wrong; then the old files are restored.
  void put();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// All of it at once, for files whose places are known to be free or ours.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files,
                 const Checkpoint& checkpoint = keep_going, const std::vector<File>& obsolete = {});

}  // namespace shadefit
