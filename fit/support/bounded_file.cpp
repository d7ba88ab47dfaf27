#include "fit/support/bounded_file.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

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

std::string read_standard_input(std::uintmax_t most_bytes, const Checkpoint& checkpoint) {
  constexpr int pause_in_milliseconds = 50;  // Ctrl-C is noticed after it
  std::string content;
  std::array<char, 65536> part;
  while (true) {
    checkpoint();
    pollfd ready{STDIN_FILENO, POLLIN, 0};
    if (::poll(&ready, 1, pause_in_milliseconds) == 0) continue;
    const ssize_t count = ::read(STDIN_FILENO, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw UserError(fmt::format("cannot read standard input: {}", std::strerror(errno)));
    if (count == 0) return content;
    content.append(part.data(), static_cast<std::size_t>(count));
    if (content.size() > most_bytes)
      throw UserError(fmt::format("cannot read standard input: it has more than {} bytes", most_bytes));
  }
}

}  // namespace shadefit
