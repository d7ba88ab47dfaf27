#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Where the names in a scene's file lead: into the file itself, into its folder, and nowhere else.
namespace shadefit::scene {

/// A URI that holds its data itself.
bool is_data(std::string_view uri);

/// The bytes of a URI that `is_data`. Throws UserError where it is malformed.
/// Source: Masinter 1998, RFC 2397, "The data URL scheme"; Josefsson 2006, RFC 4648, for base64.
std::string data_of_uri(std::string_view uri);

/// http and https: fetched by nobody here.
bool is_remote(std::string_view uri);

/// The text of a URI with its %NN made bytes. Throws UserError where two digits are missing or make a zero.
std::string percent_decoded(std::string_view uri);

/// The path of the file `name` as `folder` has it. Throws UserError where it is outside: an absolute path, a
/// scheme such as file:, a way out by "..", a link that leads elsewhere; or a name longer than a system
/// opens. A backslash separates folders, as in the files of many exporters. The file need not be there.
std::filesystem::path path_within(const std::filesystem::path& folder, std::string_view name);

/// The folder of a scene's file, which names in it are relative to.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace shadefit::scene
