#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/io/files.hpp"

/// Writes results: nothing is ever half-written, and no foreign file is touched.
namespace shadefit {

/// What happens to a foreign file (not `is_own`) with a name that is needed.
enum class Foreign {
  refused,
  replaced,  ///< --force
};

/// Whether other runs may write to the directory at the same time.
enum class Company { welcome, refused };

/// Files that are written into a directory all at once or not at all: `prepare` writes them into a temporary
/// directory there, `put` renames them into their places. Unless `put` completes, everything stays as before.
class Output {
 public:
  /// Creates the directory (`without_detours`) and tests whether it can be written. Throws UserError if it
  /// cannot, or if company is refused and another run has locked the directory.
  explicit Output(const std::filesystem::path& directory, Company company = Company::welcome);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Writes the files, and notes which of the `obsolete` to remove: those that exist and that shadefit wrote.
  /// The content of an obsolete file is the beginning by which it is recognised. A file keeps the mode of the
  /// file that it replaces, and the owner if the system allows it. The checkpoint is called before each file
  /// and once more at the end. Throws UserError naming the path and what went wrong; before anything is
  /// written, if a foreign file or a directory has a needed name. Call it once.
  void prepare(const std::vector<File>& files, const std::vector<File>& obsolete, Foreign foreign,
               const Checkpoint& checkpoint = keep_going);

  /// Moves the files to their places and removes the obsolete ones. Throws UserError naming the path and what
  /// went wrong; then the old files are restored.
  void put();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Removes the temporary directories that runs left in a directory when they were killed. Every Output there
/// does so first.
void remove_leftovers(const std::filesystem::path& directory);

/// All of this at once, for places that are free or ours.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files,
                 const Checkpoint& checkpoint = keep_going, const std::vector<File>& obsolete = {});

}  // namespace shadefit
