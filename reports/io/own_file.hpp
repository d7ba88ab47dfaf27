#pragma once

#include <filesystem>
#include <string>

#include "reports/io/files.hpp"

/// Recognises files that shadefit wrote by their contents. No separate record is kept that could be lost.
namespace shadefit {

/// Ends a text with a line that holds the CRC-32 of all before it. A user who changes the text owns it.
/// `open` and `close` make a comment of the line: "# " and "", or "<!-- " and " -->".
std::string sealed(std::string text, const std::string& open, const std::string& close = "");

/// A picture as gnuplot drew it, marked as ours: an SVG is sealed, a PNG gets a tEXt chunk "Software".
std::string marked_picture(const std::string& name, std::string picture);

/// Whether the file at `path` is one that shadefit wrote under the name of `file`. A script of gnuplot and an
/// SVG have to be sealed, a PNG has to be marked; any other file has to begin as `file` does: in the same
/// first line, of JSON with the same first two fields. A table may have fewer columns at its end: that is an
/// older version's. Anything but a regular file is not ours.
bool is_own(const std::filesystem::path& path, const File& file);

}  // namespace shadefit
