#pragma once

#include <filesystem>
#include <string>

#include "reports/io/files.hpp"

/// Recognises files that shadefit wrote by their contents. No separate record is kept that could be lost.
namespace shadefit {

/// Ends a text with a line that holds the CRC-32 of the text before it. After a user's change the text counts
/// as the user's. `open` and `close` turn the line into a comment: "# " and "", or "<!-- " and " -->".
std::string sealed(std::string text, const std::string& open, const std::string& close = "");

/// A picture as gnuplot drew it, marked as ours: an SVG is sealed, a PNG gets a tEXt chunk "Software".
std::string marked_picture(const std::string& name, std::string picture);

/// Whether the file at `path` is one that shadefit wrote under the name of `file`. A gnuplot script and an
/// SVG must be sealed, and a PNG must be marked. Any other file must begin like `file`: with the same first
/// line, or for JSON with the same first two fields. A table may lack columns at the end, as in an older
/// version. Only a regular file can be ours.
bool is_own(const std::filesystem::path& path, const File& file);

}  // namespace shadefit
