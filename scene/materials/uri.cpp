#include "scene/materials/uri.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "fit/support/user_error.hpp"
#include "scene/materials/messages.hpp"

namespace shadefit::scene {
namespace {

namespace fs = std::filesystem;

/// PATH_MAX of Linux: it opens no file with a longer name.
constexpr std::size_t most_name_bytes = 4096;

char in_small_letters(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// "http" of "http://..", in small letters; empty if there is none. Source: Berners-Lee, Fielding, Masinter
/// 2005, RFC 3986, section 3.1.
std::string scheme_of(std::string_view uri) {
  std::string scheme(uri.substr(0, uri.find(':')));
  std::ranges::transform(scheme, scheme.begin(), in_small_letters);
  const bool is_one = !scheme.empty() && scheme.size() < uri.size() && scheme[0] >= 'a' && scheme[0] <= 'z' &&
                      scheme.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789+-.") == scheme.npos;
  return is_one ? scheme : "";
}

constexpr std::string_view hexadecimal = "0123456789abcdef",
                           base64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The value of a digit; the number of digits for any other character.
unsigned value_among(std::string_view digits, char c) {
  return static_cast<unsigned>(std::min(digits.find(c), digits.size()));
}

std::string base64_decoded(std::string_view text) {
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) throw UserError("base64 ends within a byte");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  unsigned pending = 0, bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned value = value_among(base64, text[i]);
    if (value == 64) throw UserError(fmt::format("character {} of the base64 is not one of its 64", i + 1));
    pending = (pending << 6 | value) & 0xFFFF;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(pending >> bits & 0xFF));
  }
  return bytes;
}

bool is_below(const fs::path& folder, const fs::path& path) {
  const auto [end_of_folder, next] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end_of_folder == folder.end() && next != path.end();
}

}  // namespace

std::string percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text.push_back(uri[i]);
      continue;
    }
    const auto digit = [&](std::size_t at) {
      return i + 2 < uri.size() ? value_among(hexadecimal, in_small_letters(uri[at])) : 16;
    };
    const unsigned high = digit(i + 1), low = digit(i + 2);
    if (high == 16 || low == 16 || high + low == 0)
      throw UserError(fmt::format("character {} of the URI is a % without two digits of a byte", i + 1));
    text.push_back(static_cast<char>(high << 4 | low));
    i += 2;
  }
  return text;
}

bool is_data(std::string_view uri) {
  return scheme_of(uri.substr(0, 5)) == "data";
}

std::string data_of_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw UserError("the data URI has no comma before its data");
  const std::string_view data = uri.substr(comma + 1);
  return uri.substr(0, comma).ends_with(";base64") ? base64_decoded(data) : percent_decoded(data);
}

bool is_remote(std::string_view uri) {
  const std::string scheme = scheme_of(uri.substr(0, 6));
  return scheme == "http" || scheme == "https";
}

fs::path path_within(const fs::path& folder, std::string_view name) {
  if (name.size() > most_name_bytes) {
    throw UserError(
        fmt::format("the name of a file has {} bytes, more than {}", name.size(), most_name_bytes));
  }
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  const auto refuse = [&] {
    throw UserError(
        fmt::format("'{}' is outside of the scene's folder '{}'", shortened(name), folder.string()));
  };
  if (text.empty()) throw UserError("the name of a file is empty");
  if (text.find('\0') != std::string::npos) throw UserError("the name of a file has a zero within");
  if (!scheme_of(text).empty() || fs::path(text).is_absolute()) refuse();
  std::error_code error;
  const fs::path root = fs::weakly_canonical(fs::absolute(folder), error);
  const fs::path path = error ? fs::path() : fs::weakly_canonical(root / text, error);
  if (error) throw UserError(fmt::format("'{}' cannot be followed: {}", shortened(name), error.message()));
  if (!is_below(root, path)) refuse();
  return path;
}

bool has_extension(const fs::path& file, std::string_view small_letters) {
  return std::ranges::equal(file.extension().string(), small_letters, {}, in_small_letters);
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace shadefit::scene
