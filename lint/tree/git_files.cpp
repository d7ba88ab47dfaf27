#include "lint/tree/git_files.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

extern char** environ;

namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;

/// Ours, without the variables that lead git to another repository, as those of a hook do. git takes no lock,
/// asks nothing, and uses no protocol: a list may need a part of the tree that was never fetched.
std::vector<std::string> environment_of_git() {
  std::vector<std::string> kept{"GIT_OPTIONAL_LOCKS=0", "GIT_TERMINAL_PROMPT=0", "GIT_NO_LAZY_FETCH=1",
                                "GIT_ALLOW_PROTOCOL=none"};
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    if (!text.starts_with("GIT_") || text.starts_with("GIT_CONFIG_")) kept.emplace_back(text);
  }
  return kept;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Starts git in the root folder with its output to a descriptor, and without other streams. 0 if it cannot
/// be started.
pid_t start_git(std::vector<std::string> arguments, int output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  // A PATH may have the current folder, which may be that of the tree.
  posix_spawn_file_actions_addchdir_np(&actions, "/");
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  // An interruption, which we hold back until a checkpoint, ends git at once.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  auto environment = environment_of_git();
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, arguments.front().c_str(), &actions, &attributes,
                                   pointers_to(arguments).data(), pointers_to(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? process : 0;
}

std::string read_to_end(int descriptor) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

/// What git prints; empty if it does not succeed.
std::optional<std::string> output_of_git(std::vector<std::string> arguments) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  const pid_t process = start_git(std::move(arguments), ends[1]);
  ::close(ends[1]);
  std::string text = read_to_end(ends[0]);
  ::close(ends[0]);
  int status = -1;
  while (process > 0 && ::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status == 0 ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

std::optional<fs::path> repository_of(const fs::path& folder) {
  for (fs::path at = folder;; at = at.parent_path()) {
    std::error_code none;
    if (fs::exists(fs::symlink_status(at / ".git", none))) return at;
    if (at == at.parent_path()) return std::nullopt;
  }
}

std::optional<std::vector<std::string>> git_files(const fs::path& folder) {
  // A tree may name a program in core.fsmonitor, and the user's own rules are not the project's.
  const auto output =
      output_of_git({"git", "-C", folder.string(), "-c", "core.fsmonitor=false", "-c",
                     "core.excludesFile=/dev/null", "ls-files", "-co", "--exclude-standard", "-z"});
  if (!output) return std::nullopt;
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin < output->size(); begin = output->find('\0', begin) + 1) {
    names.emplace_back(output->c_str() + begin);
    if (names.back().ends_with('/')) names.back().pop_back();  // a repository within
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace shadefit::lint
