#pragma once

#include <filesystem>
#include <string>

/// Where an option --out that names a file puts it.
namespace shadefit {

struct OutputFile {
  std::filesystem::path directory;
  std::string name;
};

/// Throws UserError where the text names no file, or its directory cannot become one; `what` is what the file
/// is for: "the certificate".
OutputFile parse_output_file(const std::string& text, const std::string& what);

}  // namespace shadefit
