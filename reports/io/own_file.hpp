#pragma once

#include <filesystem>
#include <string>

#include "reports/io/files.hpp"

/// Recognises files that shadefit wrote by their contents. No separate record is kept that could be lost.
namespace shadefit {

/// A picture as gnuplot drew it with our name near its end, by which `is_own` recognises it. The same plot
/// gives the same bytes: a PDF has no date.
std::string marked_picture(const std::string& name, std::string picture);

/// Whether the file at `path` is one that shadefit wrote under the name of `file`. A picture must be marked.
/// Any other file must begin like `file`: with the same first line, or for JSON with the same first two
/// fields. A table may lack columns at the end, as in an older version. Only a regular file can be ours.
bool is_own(const std::filesystem::path& path, const File& file);

}  // namespace shadefit
