#include "app/output/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <climits>
#include <cstring>
#include <string_view>
#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& words) {
  throw UserError(fmt::format("cannot write '{}': {}", path.string(), words));
}

/// Whether a path names an open descriptor of a process, such as /dev/fd/3. Its file may have no name; if it
/// has one, others may write to it too.
bool is_descriptor(const fs::path& path) {
  std::error_code ignored;
  return fs::canonical(path.parent_path(), ignored).string().starts_with("/proc/");
}

/// The end of a chain of links; it need not exist yet.
fs::path target_of(fs::path path) {
  std::error_code error;
  while (!is_descriptor(path) && fs::is_symlink(path, error))
    path = path.parent_path() / fs::read_symlink(path, error);  // an absolute path replaces all of it
  return path;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

/// A descriptor that closes itself.
struct Descriptor : boost::noncopyable {
  int number;
  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

/// The wait before the checkpoint is called again: too short to notice after Ctrl-C.
constexpr int pause_in_milliseconds = 50;

/// Opens a pipe once it has a reader.
int open_stream(const fs::path& path, const Checkpoint& checkpoint) {
  for (;;) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    std::error_code ignored;
    if (descriptor >= 0 || errno != ENXIO || !fs::is_fifo(path, ignored)) return descriptor;
    checkpoint();
    ::poll(nullptr, 0, pause_in_milliseconds);
  }
}

void write_stream(const fs::path& path, std::string_view content, const Checkpoint& checkpoint) {
  const Descriptor stream(open_stream(path, checkpoint));
  if (stream.number < 0) fail(path, std::strerror(errno));
  while (!content.empty()) {
    checkpoint();
    pollfd ready{stream.number, POLLOUT, 0};
    ::poll(&ready, 1, pause_in_milliseconds);
    const std::size_t size = std::min<std::size_t>(content.size(), PIPE_BUF);
    const ssize_t written = ::write(stream.number, content.data(), size);
    if (written < 0 && errno != EAGAIN && errno != EINTR) fail(path, std::strerror(errno));
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

OutputFile::OutputFile(const std::string& text, const std::string& what) : path_(text) {
  const std::string name = path_.filename().string();
  std::error_code error;
  if (name.empty() || name == "." || name == ".." || fs::is_directory(path_, error))
    throw UserError(fmt::format("--out '{}' names no file for {}", text, what));
  const auto status = fs::status(path_, error);
  if (error && status.type() != fs::file_type::not_found) fail(text, error.message());
  path_ = target_of(path_);
  is_stream_ = is_descriptor(path_) || (fs::exists(status) && !fs::is_regular_file(status));
  if (!is_stream_) require_writable(folder_of(path_));
}

std::function<void()> OutputFile::prepare(const std::string& content, bool force,
                                          const Checkpoint& checkpoint) const {
  if (is_stream()) return [path = path_, content, checkpoint] { write_stream(path, content, checkpoint); };
  const std::vector<File> files{{path_.filename().string(), content}};
  return OutputFolder(folder_of(path_)).prepare(files, {}, force, checkpoint);
}

}  // namespace shadefit
