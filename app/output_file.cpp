#include "app/output_file.hpp"

#include <fmt/format.h>

#include "fit/user_error.hpp"
#include "reports/files.hpp"

namespace shadefit {

OutputFile parse_output_file(const std::string& text, const std::string& what) {
  const std::filesystem::path path(text);
  const std::string name = path.filename().string();
  if (name.empty() || name == "." || name == ".." || std::filesystem::is_directory(path))
    throw UserError(fmt::format("--out '{}' names no file for {}", text, what));
  const std::filesystem::path directory = path.has_parent_path() ? path.parent_path() : ".";
  require_directory(directory);
  return {directory, name};
}

}  // namespace shadefit
