#include "reports/io/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <list>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>

#include "reports/io/output.hpp"
#include "reports/io/own_file.hpp"
#include "reports/io/scratch_directory.hpp"

extern char** environ;

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// Our environment without gnuplot's own variables and the locale, which could change a picture or the
/// language of messages.
std::vector<std::string> environment_of_gnuplot() {
  std::vector<std::string> kept{"LC_ALL=C.UTF-8"};
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const bool matters = text.starts_with("GNU") || text.starts_with("LC_") || text.starts_with("LANG");
    if (!matters) kept.emplace_back(text);
  }
  return kept;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// The picture of a plot.
std::string picture_file(const std::string& name) {
  return name.ends_with(".png") || name.ends_with(".pdf") ? name : name + ".svg";
}

/// Whether gnuplot wrote a picture to its end. It reports success even if the disk is full.
bool is_whole(const std::string& picture, const std::string& file) {
  constexpr std::size_t enough = 64;
  const std::string_view end = file.ends_with(".png") ? "IEND" : file.ends_with(".pdf") ? "%%EOF" : "</svg>";
  return picture.find(end, picture.size() - std::min(picture.size(), enough)) != std::string::npos;
}

/// The first line of gnuplot's messages that names a place in the script and is not a warning, else the first
/// line that is not empty.
std::string complaint_in(const std::string& messages) {
  std::istringstream lines(messages);
  std::string first;
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(" \t^"));
    const auto has = [&](const char* part) { return line.find(part) != std::string::npos; };
    if (has(" line ") && has(": ") && !has("warning:")) return line;
    if (first.empty()) first = line;
  }
  return first.empty() ? "gnuplot failed and said nothing" : first;
}

/// A gnuplot process that draws one picture in `directory`. The destructor ends it.
class Drawing : boost::noncopyable {
 public:
  Drawing(const fs::path& gnuplot, const fs::path& directory, const std::string& name)
      : picture_(directory / picture_file(name)), messages_(directory / (name + ".messages")) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, messages_.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
    // -d: no startup file of the user's.
    std::vector<std::string> arguments{"gnuplot", "-d", "-e",
                                       fmt::format("output = '{}'", picture_.filename().string()),
                                       picture_.filename().replace_extension(".gnuplot").string()};
    auto environment = environment_of_gnuplot();
    error_ = ::posix_spawn(&process_, gnuplot.c_str(), &actions, nullptr, pointers_to(arguments).data(),
                           pointers_to(environment).data());
    if (error_ != 0) process_ = 0;
    posix_spawn_file_actions_destroy(&actions);
  }
  ~Drawing() {
    if (process_ == 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// Waits for gnuplot. What went wrong; empty if nothing did.
  std::string finish(std::chrono::milliseconds longest, const Checkpoint& checkpoint) {
    if (error_ != 0) return std::strerror(error_);
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
    if (WIFSIGNALED(status)) return fmt::format("gnuplot was ended: {}", ::strsignal(WTERMSIG(status)));
    if (status != 0) return complaint_in(read_file(messages_));
    return fs::exists(picture_) && is_whole(picture(), picture_.string()) ? ""
                                                                          : "gnuplot left no whole picture";
  }

  std::string picture() const { return read_file(picture_); }

 private:
  fs::path picture_, messages_;
  pid_t process_ = 0;
  int error_ = 0;  ///< why it was not started
};

}  // namespace

std::optional<fs::path> find_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');) {
    std::error_code error;
    const fs::path candidate = fs::absolute(fs::path(directory) / "gnuplot", error);
    const bool is_program = !directory.empty() && !error && fs::is_regular_file(candidate, error);
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
    const std::string complaint = drawing->finish(longest, checkpoint), file = "plots/" + picture_file(name);
    if (complaint.empty()) {
      pictures.files.push_back({file, marked_picture(file, drawing->picture())});
    } else {
      pictures.failed.push_back({name, complaint});
    }
    ++drawing;
  }
  return pictures;
}

}  // namespace shadefit
