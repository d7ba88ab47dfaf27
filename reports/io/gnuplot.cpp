#include "reports/io/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <list>
#include <sstream>
#include <string_view>
#include <system_error>

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

/// gnuplot's messages, in an unlinked file of `directory`. Its descriptor is above the standard ones even if
/// those were closed, and is not inherited.
class Transcript : boost::noncopyable {
 public:
  explicit Transcript(const fs::path& directory) {
    std::string name = (directory / ".transcript-XXXXXX").string();
    const int file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0) descriptor_ = ::fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (descriptor_ < 0)
      error_ = fmt::format("cannot create a file in '{}': {}", directory.string(), std::strerror(errno));
    if (file < 0) return;
    ::unlink(name.c_str());
    ::close(file);
  }
  ~Transcript() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  /// Why there is no transcript; empty if there is one.
  const std::string& error() const { return error_; }
  int descriptor() const { return descriptor_; }

  /// The first line that names a place in the script and is not a warning, else the first line that is not
  /// empty.
  std::string complaint() const {
    std::string text(4096, '\0');
    const auto size = ::pread(descriptor_, text.data(), text.size(), 0);
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    std::istringstream lines(text);
    std::string first;
    for (std::string line; std::getline(lines, line);) {
      line.erase(0, line.find_first_not_of(" \t^"));
      const auto has = [&](const char* part) { return line.find(part) != std::string::npos; };
      if (has(" line ") && has(": ") && !has("warning:")) return line;
      if (first.empty()) first = line;
    }
    return first.empty() ? "gnuplot failed and said nothing" : first;
  }

 private:
  int descriptor_ = -1;
  std::string error_;
};

/// The settings of posix_spawn, freed by the destructor.
struct SpawnSettings : boost::noncopyable {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  SpawnSettings() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
};

/// The picture of a plot.
std::string picture_file(const std::string& name) {
  return name.ends_with(".png") || name.ends_with(".pdf") ? name : name + ".svg";
}
/// A gnuplot process for one script. It ends with `finish`; otherwise the destructor ends it.
class Drawing : boost::noncopyable {
 public:
  Drawing(const fs::path& gnuplot, const fs::path& directory, const std::string& name)
      : name_(name),
        place_(directory / picture_file(name)),
        // The script chooses the format by the ending of the name.
        partial_(directory / fmt::format(".partial-{}-{}", ::getpid(), picture_file(name))),
        transcript_(directory),
        error_(transcript_.error()) {
    remove(partial_);
    if (error_.empty()) start(gnuplot, directory);
  }
  ~Drawing() {
    if (process_ > 0) kill();
    remove(partial_);
  }

  /// Waits for gnuplot and moves the picture to its place, or returns why there is none.
  std::optional<FailedPlot> finish(std::chrono::seconds longest, const Checkpoint& checkpoint) {
    std::string complaint = outcome(longest, checkpoint);
    std::error_code error;
    if (complaint.empty()) fs::rename(partial_, place_, error);
    if (error) complaint = error.message();
    if (complaint.empty()) return std::nullopt;
    remove(place_);
    return FailedPlot{name_, complaint};
  }

 private:
  void start(const fs::path& gnuplot, const fs::path& directory) {
    SpawnSettings settings;
    auto* actions = &settings.actions;
    posix_spawn_file_actions_addopen(actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(actions, transcript_.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(actions, transcript_.descriptor(), STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(actions, directory.c_str());
    // gnuplot shall end if its file reaches the size limit: it would not notice otherwise. We ignore that
    // signal and SIGPIPE, and gnuplot would inherit that. It shall also end at once on an interruption, which
    // we hold back until a checkpoint.
    sigset_t defaults, none;
    sigemptyset(&none);
    sigemptyset(&defaults);
    for (const int signal : {SIGXFSZ, SIGPIPE}) sigaddset(&defaults, signal);
    posix_spawnattr_setsigdefault(&settings.attributes, &defaults);
    posix_spawnattr_setsigmask(&settings.attributes, &none);
    posix_spawnattr_setflags(&settings.attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    // -d: no startup file of the user's.
    std::vector<std::string> arguments{"gnuplot", "-d", "-e",
                                       "output = '" + partial_.filename().string() + "'",
                                       fs::path(picture_file(name_)).replace_extension(".gnuplot").string()};
    auto environment = environment_of_gnuplot();
    const int error = ::posix_spawn(&process_, gnuplot.c_str(), actions, &settings.attributes,
                                    pointers_to(arguments).data(), pointers_to(environment).data());
    if (error == 0) return;
    process_ = 0;
    error_ = std::strerror(error);
  }

  /// What went wrong; empty if nothing did.
  std::string outcome(std::chrono::seconds longest, const Checkpoint& checkpoint) {
    if (!error_.empty()) return error_;
    const auto status = wait(longest, checkpoint);
    if (!status) {
      kill();
      return fmt::format("gnuplot took longer than {} s", longest.count());
    }
    if (WIFSIGNALED(*status)) return fmt::format("gnuplot was ended: {}", ::strsignal(WTERMSIG(*status)));
    if (*status != 0) return transcript_.complaint();
    return is_whole_picture() ? "" : "gnuplot left no whole picture";
  }

  /// gnuplot's status from waitpid, 0 is success; nothing if it has not ended after `longest`. Time is
  /// counted in pauses, so the time while the run is stopped does not count.
  std::optional<int> wait(std::chrono::milliseconds longest, const Checkpoint& checkpoint) {
    for (std::chrono::milliseconds waited{0};; waited += pause) {
      int status = -1;
      if (::waitpid(process_, &status, WNOHANG) != 0) {
        process_ = 0;
        return status;
      }
      checkpoint();
      if (waited >= longest) return std::nullopt;
      sleep_for_a_pause();
    }
  }

  /// Asks gnuplot to end, and kills it if it does not end within a second.
  void kill() {
    ::kill(process_, SIGTERM);
    if (wait(std::chrono::seconds(1), keep_going)) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
  }

  /// Short compared with the 10 to 40 ms of a picture, long compared with the microseconds of a test.
  static constexpr std::chrono::milliseconds pause{2};
  static void sleep_for_a_pause() {
    const std::timespec time{0, std::chrono::nanoseconds(pause).count()};
    ::nanosleep(&time, nullptr);
  }

  /// gnuplot reports success even if the disk is full.
  bool is_whole_picture() const {
    const std::string_view end = name_.ends_with(".png")   ? "IEND"
                                 : name_.ends_with(".pdf") ? "%%EOF"
                                                           : "</svg>";
    std::array<char, 64> tail{};
    std::FILE* file = std::fopen(partial_.c_str(), "rb");
    if (file == nullptr) return false;
    if (std::fseek(file, -static_cast<long>(tail.size()), SEEK_END) != 0) std::rewind(file);
    const std::size_t size = std::fread(tail.data(), 1, tail.size(), file);
    std::fclose(file);
    return std::string_view(tail.data(), size).find(end) != std::string_view::npos;
  }

  static void remove(const fs::path& path) {
    std::error_code ignored;
    fs::remove(path, ignored);
  }

  std::string name_;
  fs::path place_, partial_;
  Transcript transcript_;
  pid_t process_ = 0;
  std::string error_;  ///< why it was not started
};

}  // namespace

std::optional<fs::path> find_gnuplot() {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');) {
    if (directory.empty()) continue;
    std::error_code ignored;
    std::error_code without_working_directory;
    const fs::path candidate = fs::absolute(fs::path(directory) / "gnuplot", without_working_directory);
    if (without_working_directory) continue;
    if (fs::is_regular_file(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return std::nullopt;
}

std::vector<FailedPlot> draw_plots(const fs::path& gnuplot, const fs::path& directory,
                                   const std::vector<std::string>& names, const Checkpoint& checkpoint,
                                   std::chrono::seconds longest) {
  constexpr std::size_t at_once = 2;
  std::vector<FailedPlot> failed;
  std::list<Drawing> running;
  const auto finish_oldest = [&] {
    if (auto failure = running.front().finish(longest, checkpoint)) failed.push_back(*failure);
    running.pop_front();
  };
  for (const std::string& name : names) {
    if (running.size() == at_once) finish_oldest();
    checkpoint();
    running.emplace_back(gnuplot, directory, name);
  }
  while (!running.empty()) finish_oldest();
  return failed;
}

Pictures draw_pictures(const fs::path& gnuplot, const std::vector<File>& files,
                       const std::vector<std::string>& names, const Checkpoint& checkpoint) {
  const ScratchDirectory scratch;
  write_files(scratch.path(), files, checkpoint);
  Pictures pictures;
  pictures.failed = draw_plots(gnuplot, scratch.path() / "plots", names, checkpoint);
  checkpoint();
  for (const std::string& name : names) {
    const bool has_failed =
        std::ranges::find(pictures.failed, name, &FailedPlot::name) != pictures.failed.end();
    if (has_failed) continue;
    const std::string file = "plots/" + picture_file(name);
    pictures.files.push_back({file, marked_picture(file, read_file(scratch.path() / file))});
  }
  return pictures;
}

}  // namespace shadefit
