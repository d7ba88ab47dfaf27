#include "reports/io/own_file.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// What tells our pictures from others.
constexpr std::string_view name_of_ours = "shadefit";

bool is_picture(std::string_view name) {
  return name.ends_with(".svg") || name.ends_with(".pdf") || name.ends_with(".png");
}

/// A PDF with the date of the epoch.
std::string without_date(std::string pdf) {
  constexpr std::string_view key = "/CreationDate (D:", epoch = "19700101000000";
  const std::size_t at = pdf.find(key);
  if (at != std::string::npos && at + key.size() + epoch.size() <= pdf.size())
    pdf.replace(at + key.size(), epoch.size(), epoch);
  return pdf;
}

std::string_view first_line(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// The beginning of a file in every version: its first line. For JSON, whose first line is a bracket, its
/// first two fields without the value of the second.
std::string_view beginning_of(std::string_view text) {
  if (!text.starts_with('{')) return first_line(text);
  const std::size_t second = text.find(':', text.find(':') + 1);  // npos + 1 is 0
  return text.substr(0, second);
}

/// Whether two headers are equal, or one is the other with additional columns at the end. Headers of two
/// columns are too common to count.
bool are_columns_alike(const std::string& a, const std::string& b) {
  constexpr auto fewest = 2;                                              // commas
  const std::string &shorter = std::min(a, b), &longer = std::max(a, b);  // of a prefix and the whole
  return a == b || (std::ranges::count(shorter, ',') >= fewest && longer.starts_with(shorter + ","));
}

bool begins_alike(const std::string& name, std::string_view there, std::string_view ours) {
  if (name.ends_with(".csv"))
    return are_columns_alike(std::string(first_line(there)), std::string(first_line(ours)));
  return beginning_of(there) == beginning_of(ours);
}

}  // namespace

std::string marked_picture(const std::string& name, std::string picture) {
  if (name.ends_with(".svg")) return picture + "<!-- " + std::string(name_of_ours) + " -->\n";
  if (name.ends_with(".pdf"))
    return without_date(std::move(picture)) + "% " + std::string(name_of_ours) + "\n";
  // A chunk tEXt with its length and its checksum, before the last chunk, IEND, which has 12 bytes.
  constexpr std::string_view mark("\0\0\0\x11tEXtSoftware\0shadefit\xBE\xD1\x90\xBC", 29);
  return picture.insert(picture.size() - std::min<std::size_t>(picture.size(), 12), mark);
}

bool is_own(const fs::path& path, const File& file) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  constexpr std::streamoff last = 64, first = 4096;
  std::ifstream in(path, std::ios::binary);
  if (is_picture(file.name) && fs::file_size(path, error) > last) in.seekg(-last, std::ios::end);
  std::string part(first, '\0');
  part.resize(static_cast<std::size_t>(in.read(part.data(), first).gcount()));
  return is_picture(file.name) ? part.find(name_of_ours) != std::string::npos
                               : begins_alike(file.name, part, file.content);
}

}  // namespace shadefit
