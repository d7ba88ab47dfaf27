#include "reports/io/gnuplot.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <cstdlib>
#include <list>
#include <sstream>
#include <system_error>
#include <thread>

#include "reports/io/output.hpp"
#include "reports/io/scratch_directory.hpp"

extern char** environ;

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// Starts the program $0 in the directory $1 with the script $2 and writes its messages to $3. It reads no
/// startup file (-d), and gets neither a terminal nor a locale of the user's.
constexpr const char* shell_command =
    R"(cd "$1" && unset GNUTERM && export LC_ALL=C.UTF-8 && exec "$0" -d "$2" </dev/null >"$3" 2>&1)";

/// Whether gnuplot wrote a picture to its end. It reports success even if the disk is full.
bool is_whole(const std::string& picture) {
  constexpr std::size_t enough = 64;
  return picture.find("</svg>", picture.size() - std::min(picture.size(), enough)) != std::string::npos;
}

/// The last line of gnuplot's messages, which says why it ended.
std::string last_line(const std::string& messages) {
  std::istringstream lines(messages);
  std::string last = "gnuplot failed and said nothing";
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) last = line;
  return last;
}

/// A gnuplot process that draws one picture in `directory`. The destructor ends it.
class Drawing : boost::noncopyable {
 public:
  Drawing(const fs::path& gnuplot, const fs::path& directory, const std::string& name)
      : picture_(directory / (name + ".svg")), messages_(directory / (name + ".messages")) {
    const std::string script = name + ".gnuplot";
    const std::array<const char*, 8> arguments{
        "sh",   "-c", shell_command, gnuplot.c_str(), directory.c_str(), script.c_str(), messages_.c_str(),
        nullptr};
    // posix_spawn changes none of its arguments, whatever its type says.
    auto* const* words = const_cast<char* const*>(arguments.data());
    if (::posix_spawn(&process_, "/bin/sh", nullptr, nullptr, words, environ) != 0) process_ = 0;
  }
  ~Drawing() {
    if (process_ == 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// Waits for gnuplot. What went wrong; empty if nothing did.
  std::string finish(std::chrono::milliseconds longest, const Checkpoint& checkpoint) {
    if (process_ == 0) return "no process could be started";
    // Short compared with the 10 to 40 ms of a picture, long compared with the microseconds of a test. Time
    // is counted in pauses, so the time while the run is stopped does not count.
    constexpr std::chrono::milliseconds pause{2};
    int status = 0;
    for (auto waited = pause; ::waitpid(process_, &status, WNOHANG) == 0; waited += pause) {
      checkpoint();
      if (waited > longest)
        return fmt::format("gnuplot took longer than {} s", longest / std::chrono::seconds(1));
      std::this_thread::sleep_for(pause);
    }
    process_ = 0;
    if (status != 0) return last_line(read_file(messages_));
    return fs::exists(picture_) && is_whole(picture()) ? "" : "gnuplot left no whole picture";
  }

  std::string picture() const { return read_file(picture_); }

 private:
  fs::path picture_, messages_;
  pid_t process_ = 0;
};

}  // namespace

std::optional<fs::path> find_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');) {
    const fs::path candidate = fs::path(directory) / "gnuplot";
    std::error_code none;
    const bool is_program = candidate.is_absolute() && fs::is_regular_file(candidate, none);
    if (is_program && ::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return std::nullopt;
}

Pictures draw_pictures(const fs::path& gnuplot, const std::vector<File>& files,
                       const std::vector<std::string>& names, const Checkpoint& checkpoint,
                       std::chrono::seconds longest) {
  const ScratchDirectory scratch;
  write_files(scratch.path(), files);
  std::list<Drawing> drawings;
  for (const std::string& name : names) drawings.emplace_back(gnuplot, scratch.path() / "plots", name);
  Pictures pictures;
  auto drawing = drawings.begin();
  for (const std::string& name : names) {
    const std::string complaint = drawing->finish(longest, checkpoint);
    if (complaint.empty()) {
      pictures.files.push_back({"plots/" + name + ".svg", marked_picture(drawing->picture())});
    } else {
      pictures.failed.push_back({name, complaint});
    }
    ++drawing;
  }
  return pictures;
}

}  // namespace shadefit
