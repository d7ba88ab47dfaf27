#include "fit/input/bounded_file.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

constexpr std::uintmax_t part_bytes = 1 << 20;

[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& reason) {
  throw UserError(fmt::format("cannot read '{}': {}", path.string(), reason));
}

std::uintmax_t size_of_regular_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse_file(path, "there is no such file");
  if (error) refuse_file(path, error.message());
  if (std::filesystem::is_directory(status)) refuse_file(path, "it is a directory");
  if (!std::filesystem::is_regular_file(status)) refuse_file(path, "it is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuse_file(path, error.message());
  return size;
}

std::uintmax_t size_within(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  const std::uintmax_t size = size_of_regular_file(path);
  if (size > most_bytes) refuse_file(path, fmt::format("it has {} bytes, more than {}", size, most_bytes));
  return size;
}

}  // namespace

std::string read_part(const std::filesystem::path& path, std::uintmax_t offset, std::uintmax_t length) {
  const std::uintmax_t size = size_of_regular_file(path);
  if (offset > size || length > size - offset) {
    refuse_file(path, fmt::format("{} bytes from {} on are asked of a file of {}", length, offset, size));
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(offset));
  std::string content(static_cast<std::size_t>(length), '\0');
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!in) refuse_file(path, std::strerror(errno != 0 ? errno : EIO));
  return content;
}

void require_size(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  size_within(path, most_bytes);
}

std::string read_bounded(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  return read_part(path, 0, size_within(path, most_bytes));
}

TextParts parts_of(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  return [path, size = size_within(path, most_bytes), offset = std::uintmax_t{0}]() mutable {
    const std::uintmax_t length = std::min(part_bytes, size - offset);
    offset += length;
    return length == 0 ? std::string() : read_part(path, offset - length, length);
  };
}

TextParts parts_of_standard_input(std::uintmax_t most_bytes, const Checkpoint& checkpoint) {
  constexpr int patience = 100;  // milliseconds between two looks for a signal
  return [most_bytes, checkpoint, size = std::uintmax_t{0}]() mutable -> std::string {
    for (;;) {
      checkpoint();
      pollfd input{STDIN_FILENO, POLLIN, 0};
      const int ready = ::poll(&input, 1, patience);
      if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
      std::array<char, 1 << 16> part{};
      const ssize_t length = ready < 0 ? -1 : ::read(STDIN_FILENO, part.data(), part.size());
      if (length < 0) refuse_file("-", std::strerror(errno));
      size += static_cast<std::uintmax_t>(length);
      if (size > most_bytes)
        refuse_file("-", fmt::format("standard input has more than {} bytes", most_bytes));
      return {part.data(), static_cast<std::size_t>(length)};
    }
  };
}

std::string read_standard_input(std::uintmax_t most_bytes, const Checkpoint& checkpoint) {
  const TextParts next = parts_of_standard_input(most_bytes, checkpoint);
  std::string content;
  for (std::string part = next(); !part.empty(); part = next()) content += part;
  return content;
}

}  // namespace shadefit
