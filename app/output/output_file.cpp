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

}  // namespace

OutputFile::OutputFile(const std::string& option, const std::string& text, const std::string& what) {
  const fs::path path(text);
  const std::string name = path.filename().string();
  std::error_code error;
  if (name.empty() || name == "." || name == ".." || fs::is_directory(path, error))
    throw UserError(fmt::format("{} '{}' names no file for {}", option, text, what));
  const auto status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found) fail(text, error.message());
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(text, "it is a device or a pipe, not a file");
  const fs::path target = target_of(path);
  name_ = target.filename().string();
  folder_ = target.has_parent_path() ? target.parent_path() : ".";
  require_writable(folder_);
}

std::function<void()> OutputFile::prepare(const std::string& content, bool force,
                                          const Checkpoint& checkpoint) const {
  return OutputFolder(folder_.string()).prepare({{name_, content}}, {}, force, checkpoint);
}

}  // namespace shadefit
