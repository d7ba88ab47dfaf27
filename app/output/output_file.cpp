#include "app/output/output_file.hpp"

#include <fmt/format.h>

#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& words) {
  throw UserError(fmt::format("cannot write '{}': {}", path.string(), words));
}

/// The end of a chain of links; it need not exist yet.
fs::path target_of(fs::path path) {
  std::error_code error;
  while (fs::is_symlink(path, error))
    path = path.parent_path() / fs::read_symlink(path, error);  // an absolute path replaces all of it
  return path;
}

/// "." for a name alone.
fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace

std::function<void()> prepare_output(const fs::path& directory, const std::vector<File>& files,
                                     const std::vector<File>& obsolete, bool force,
                                     const Checkpoint& checkpoint) {
  if (!force) require_own(directory, files);
  checkpoint();
  return [=] {
    write_files(directory, files);
    remove_own(directory, obsolete);
  };
}

fs::path output_file(const std::string& option, const std::string& text, const std::string& what) {
  const fs::path path(text);
  const std::string name = path.filename().string();
  std::error_code error;
  if (name.empty() || name == "." || name == ".." || fs::is_directory(path, error))
    throw UserError(fmt::format("{} '{}' names no file for {}", option, text, what));
  const auto status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found) fail(text, error.message());
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(text, "it is a device or a pipe, not a file");
  const fs::path target = target_of(path);
  require_writable(folder_of(target));
  return target;
}

std::function<void()> prepare_output_file(const fs::path& file, const std::string& content, bool force,
                                          const Checkpoint& checkpoint) {
  return prepare_output(folder_of(file), {{file.filename().string(), content}}, {}, force, checkpoint);
}

}  // namespace shadefit
