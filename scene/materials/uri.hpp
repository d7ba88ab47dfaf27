#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Resolves the names in a scene's file: data in the file itself or files in its folder, nothing else.
namespace shadefit::scene {

/// Whether a URI contains its data.
bool is_data(std::string_view uri);

/// The bytes of a URI that `is_data`. Throws UserError if it is malformed.
/// Source: Masinter 1998, RFC 2397, "The data URL scheme"; Josefsson 2006, RFC 4648, for base64.
std::string data_of_uri(std::string_view uri);

/// Whether a URI is http or https; these are never fetched.
bool is_remote(std::string_view uri);

/// The text of a URI with each %NN decoded to a byte. Throws UserError if the two digits are missing or
/// encode a zero byte.
std::string percent_decoded(std::string_view uri);

/// The path of the file `name` in `folder`. Throws UserError if it leads outside (an absolute path, a scheme
/// such as file:, "..", a link) or if the name is too long for the system. A backslash separates folders, as
/// in the files of many exporters. The file need not exist.
std::filesystem::path path_within(const std::filesystem::path& folder, std::string_view name);

/// Whether the name of a file ends with an extension such as ".glb", ignoring case.
bool has_extension(const std::filesystem::path& file, std::string_view small_letters);

/// The folder of a scene's file; names in the file are relative to it.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace shadefit::scene
