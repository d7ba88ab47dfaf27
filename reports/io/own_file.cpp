#include "reports/io/own_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "reports/io/digest.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view seal_word = "shadefit ";

/// A chunk of PNG: the length of its data, its type, the data, and the CRC-32 of type and data.
std::string png_mark() {
  constexpr std::string_view data("Software\0shadefit", 17);
  const std::string body = "tEXt" + std::string(data);
  std::string chunk{'\0', '\0', '\0', static_cast<char>(data.size())};
  chunk += body;
  for (const int shift : {24, 16, 8, 0}) chunk += static_cast<char>(crc_of(body) >> shift & 0xFF);
  return chunk;
}

/// A PDF with the date of the epoch: equal pictures are equal files.
std::string without_date(std::string pdf) {
  constexpr std::string_view key = "/CreationDate (D:", epoch = "19700101000000";
  const std::size_t at = pdf.find(key);
  if (at != std::string::npos && at + key.size() + epoch.size() <= pdf.size())
    pdf.replace(at + key.size(), epoch.size(), epoch);
  return pdf;
}

/// Bytes of the chunk IEND, the last of a PNG.
constexpr std::size_t png_end = 12;

bool is_sealed(std::string_view text) {
  if (!text.ends_with('\n')) return false;
  const std::size_t line = text.rfind('\n', text.size() - 2) + 1;  // npos + 1 is 0
  const std::size_t word = text.find(seal_word, line);
  if (word == std::string_view::npos) return false;
  return text.substr(word + seal_word.size())
      .starts_with(fmt::format("{:08x}", crc_of(text.substr(0, line))));
}

bool is_marked(std::string_view picture) {
  const std::string mark = png_mark();
  return picture.size() >= mark.size() + png_end &&
         picture.substr(picture.size() - png_end - mark.size(), mark.size()) == mark;
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

std::string sealed(std::string text, const std::string& open, const std::string& close) {
  if (!text.empty() && !text.ends_with('\n')) text += '\n';
  return text + fmt::format("{}{}{:08x}{}\n", open, seal_word, crc_of(text), close);
}

std::string marked_picture(const std::string& name, std::string picture) {
  if (name.ends_with(".svg")) return sealed(std::move(picture), "<!-- ", " -->");
  if (name.ends_with(".pdf")) return sealed(without_date(std::move(picture)), "% ");
  picture.insert(picture.size() - std::min(picture.size(), png_end), png_mark());
  return picture;
}

bool is_own(const fs::path& path, const File& file) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  const bool is_sealed_kind =
      file.name.ends_with(".gnuplot") || file.name.ends_with(".svg") || file.name.ends_with(".pdf");
  const bool is_picture = file.name.ends_with(".png");
  // The beginning is enough for most files, and our pictures are small: larger files are not read.
  constexpr std::size_t enough = 4096, largest = std::size_t{1} << 26;
  if ((is_sealed_kind || is_picture) && fs::file_size(path, error) > largest) return false;
  std::ifstream in(path, std::ios::binary);
  std::string there;
  if (is_sealed_kind || is_picture) {
    there.assign(std::istreambuf_iterator<char>(in), {});
  } else {
    there.resize(enough);
    in.read(there.data(), static_cast<std::streamsize>(there.size()));
    there.resize(static_cast<std::size_t>(in.gcount()));
  }
  if (is_sealed_kind) return is_sealed(there);
  return is_picture ? is_marked(there) : begins_alike(file.name, there, file.content);
}

}  // namespace shadefit
