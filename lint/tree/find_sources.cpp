#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <set>
#include <system_error>
#include <unordered_set>
#include <utility>

#include "fit/input/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "lint/scan/characters.hpp"
#include "lint/tree/git_files.hpp"
#include "lint/tree/source_tree.hpp"

namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;

/// Folders with code of others, in lower case: those of package managers, and those that engines use.
constexpr std::string_view vendored_names[] = {
    // package managers and build tools
    "node_modules", "bower_components", "jspm_packages", "site-packages", ".venv", "venv", ".tox", ".yarn",
    ".cargo", "godeps", "pods", "carthage", "vcpkg_installed", "_deps",
    // by hand
    "third_party", "third-party", "thirdparty", "3rdparty", "3rd_party", "3rd-party", "external", "externals",
    "extern", "externs", "vendor", "vendors", "vendored", ".vendored", "deps", "dependencies"};

constexpr std::size_t most_large_messages = 5;

/// A licence may come before the first line that shows the language.
constexpr std::uintmax_t looked_into = 16384;

template <class Values, class Value>
bool contains(const Values& values, const Value& value) {
  return std::ranges::find(values, value) != std::end(values);
}

/// A path as shown: relative to `current`, an absolute folder, if it is absolute and below that; otherwise as
/// given. With '/' between its names, without "." and double '/'. The folder `current` itself is the empty
/// text.
std::string shown_name(const fs::path& path, const fs::path& current) {
  fs::path shown = path;
  if (path.is_absolute()) {
    const fs::path relative = path.lexically_relative(current);
    if (!relative.empty() && *relative.begin() != "..") shown = relative;
  }
  fs::path result;
  for (const auto& part : shown)
    if (!part.empty() && part != ".") result /= part;
  return result.generic_string();
}

/// A place on the walk: its absolute name without links, and its shown name, which is empty for the current
/// folder.
struct FoundPath {
  std::string absolute, name;

  fs::path path() const { return name.empty() ? "." : name; }

  FoundPath below(const std::string& entry) const {
    const auto joined = [&](const std::string& folder) {
      return folder.empty() || folder.ends_with('/') ? folder + entry : folder + "/" + entry;
    };
    return {joined(absolute), joined(name)};
  }
};

/// The absolute names of what is read below a folder: the files of git_files(), and the folders above them.
/// Null: all files are read.
using List = std::shared_ptr<const std::unordered_set<std::string>>;

/// A glob with '**' is not exact about the others: there '*' matches '/' too.
bool matches(std::string glob, const std::string& path) {
  const int flags = glob.find("**") == std::string::npos ? FNM_PATHNAME : 0;
  if (::fnmatch(glob.c_str(), path.c_str(), flags) == 0) return true;
  const std::size_t any = glob.find("/**/");  // also no folder
  return any != std::string::npos && matches(glob.replace(any, 4, "/"), path);
}

/// Whether a glob matches a path.
bool is_excluded(const FolderGlobs& globs, const std::string& path) {
  const std::string folder = globs.folder == "/" ? "" : globs.folder.string();
  if (!path.starts_with(folder + "/")) return false;
  return std::ranges::any_of(globs.globs, [&](std::string_view glob) {
    if (glob.ends_with('/')) glob.remove_suffix(1);
    const bool is_for_names = glob.find('/') == std::string_view::npos;
    const std::string from = is_for_names || glob.starts_with('/') ? "" : "/";
    return matches(from + std::string(glob), path.substr(is_for_names ? path.rfind('/') + 1 : folder.size()));
  });
}

class Search {
 public:
  explicit Search(const TreeOptions& options) : options_(options) {
    std::error_code none;  // a folder that was removed: all names stay as given
    current_ = fs::current_path(none);
  }

  void add_path(const std::string& given) {
    std::error_code error;
    const fs::path absolute = given.empty() ? fs::path() : fs::canonical(given, error);
    if (given.empty() || error == std::errc::no_such_file_or_directory)
      throw UserError(fmt::format("path '{}': there is no such file or folder", given));
    if (error) throw UserError(fmt::format("path '{}': {}", given, error.message()));
    const FoundPath place{absolute.string(), shown_name(given, current_)};
    const fs::file_status status = fs::status(absolute, error);
    if (!fs::is_directory(status)) {
      // Refused here: a gate must not pass for what it could not read.
      read_part(place.path(), 0, 0);
      if (const auto size = fs::file_size(place.path(), error); !error && size > largest_source)
        throw UserError(fmt::format("cannot read '{}': it has {} bytes, more than {}", place.path().string(),
                                    size, largest_source));
      add_named_file(place);
      return;
    }
    fs::directory_iterator(place.path(), error);
    if (error) throw UserError(fmt::format("path '{}': {}", given, error.message()));
    globs_ = {above(absolute, {current_, options_.exclude}), above(absolute, options_.configured)};
    const auto repository = repository_of(absolute);
    walk(place, repository && *repository != absolute ? list_of(place) : nullptr);
  }

  SourceTree take() {
    std::ranges::sort(tree_.files, {}, &SourceFile::name);
    return std::move(tree_);
  }

 private:
  /// Globs with their absolute folder: that of the path unless it is above the path.
  FolderGlobs above(const fs::path& path, const FolderGlobs& given) const {
    std::error_code none;
    const fs::path folder = fs::weakly_canonical(given.folder.empty() ? current_ : given.folder, none);
    const fs::path relative = path.lexically_relative(folder);
    const bool is_above = !none && !relative.empty() && *relative.begin() != "..";
    return {is_above ? folder : path, given.globs};
  }

  /// What git lists in a folder. Where it refuses or lists nothing, all files are read.
  List list_of(const FoundPath& folder) {
    auto names = git_files(folder.absolute);
    if (!names && !std::exchange(is_git_missed_, true))
      tree_.skipped.messages.push_back(fmt::format(
          "git is missing or refuses '{0}' (git -C '{0}' ls-files says why): files that it ignores are read",
          folder.path().string()));
    if (!names || names->empty()) return nullptr;
    const auto listed = std::make_shared<std::unordered_set<std::string>>();
    for (const std::string& name : *names) {
      std::string part = folder.below(name).absolute;
      while (part.size() > folder.absolute.size() && listed->insert(part).second)
        part.resize(part.rfind('/'));
    }
    return listed;
  }

  void cannot_read(const fs::path& path, const std::string& reason) {
    ++tree_.skipped.unreadable;
    tree_.skipped.messages.push_back(fmt::format("cannot read '{}': {}", path.string(), reason));
  }

  /// `list`: of the folder or of one above.
  void walk(const FoundPath& folder, List list) {
    if (!seen_.insert(folder.absolute).second) return;
    std::error_code error;
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator entry(folder.path(), error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) entries.push_back(*entry);
    if (error) cannot_read(folder.path(), error.message());
    std::ranges::sort(entries);
    if (fs::exists(fs::symlink_status(folder.path() / ".git", error))) list = list_of(folder);
    for (const fs::directory_entry& one : entries) {
      const std::string name = one.path().filename().string();
      const FoundPath place = folder.below(name);
      // The type comes with the list of the folder, so that no file is looked at.
      if (one.is_symlink(error)) {
        ++tree_.skipped.links;
      } else if (one.is_directory(error)) {
        if (is_wanted_folder(place, name, list))
          walk(place, list && list->contains(place.absolute) ? list : nullptr);
      } else {
        add_found_file(place, name, one.is_regular_file(error), list);
      }
    }
  }

  bool is_wanted_folder(const FoundPath& place, const std::string& name, const List& list) {
    if (name == ".git") return false;
    if (is_ignored(place, true, list)) {
      ++tree_.skipped.ignored;
      return false;
    }
    const bool is_others = contains(vendored_names, in_small_letters(name));
    if (is_others) ++tree_.skipped.vendored;
    return !is_others;
  }

  bool is_ignored(const FoundPath& place, bool is_folder, const List& list) const {
    for (const FolderGlobs& globs : globs_)
      if (is_excluded(globs, place.absolute)) return true;
    return list ? !list->contains(place.absolute) : is_folder && place.absolute.ends_with("/build");
  }

  void add_found_file(const FoundPath& place, const std::string& name, bool is_regular, const List& list) {
    const auto named = language_of(name);
    if (!named) {
      ++tree_.skipped.unknown_language;
      return;
    }
    const auto& wanted = options_.languages;
    if (!wanted.empty() && !contains(wanted, named->language)) return;
    if (is_ignored(place, false, list)) {
      ++tree_.skipped.ignored;
    } else if (in_small_letters(name).find(".min.") != std::string::npos) {
      ++tree_.skipped.minified;
    } else {
      add_file(place, *named, is_regular);
    }
  }

  /// A file of an unknown language is read as if it were C: most languages write numbers and comments alike.
  void add_named_file(const FoundPath& place) {
    const auto named = language_of(fs::path(place.absolute).filename().string());
    const auto language = named ? named->language : SourceLanguage::c_family;
    add_file(place, {language, true}, true);
  }

  void add_file(const FoundPath& place, NamedLanguage named, bool is_regular) {
    if (!seen_.insert(place.absolute).second) return;
    if (!is_regular) {
      cannot_read(place.name, "it is not a regular file");
      return;
    }
    std::error_code error;
    const std::uintmax_t size = fs::file_size(place.path(), error);
    if (error) {
      cannot_read(place.name, error.message());
    } else if (size > largest_source) {
      if (++tree_.skipped.too_large <= most_large_messages)
        tree_.skipped.messages.push_back(
            fmt::format("'{}' has {} bytes, more than {}", place.name, size, largest_source));
    } else if (named.is_sure || is_shader(place, size)) {
      tree_.files.push_back({place.path(), place.name, named.language});
    }
  }

  /// Whether a file whose name does not tell its language is a shader. If not, it is counted.
  bool is_shader(const FoundPath& place, std::uintmax_t size) {
    try {
      if (looks_like_shader(read_part(place.path(), 0, std::min(size, looked_into)))) return true;
      ++tree_.skipped.unknown_language;
    } catch (const UserError& error) {
      ++tree_.skipped.unreadable;
      tree_.skipped.messages.emplace_back(error.what());
    }
    return false;
  }

  const TreeOptions& options_;
  fs::path current_;
  std::array<FolderGlobs, 2> globs_;  ///< of the command line, and of the configuration
  bool is_git_missed_ = false;        ///< whether a message says so: one is enough
  std::set<std::string> seen_;        ///< absolute names
  SourceTree tree_;
};

}  // namespace

SourceTree find_sources(const std::vector<std::string>& paths, const TreeOptions& options) {
  Search search(options);
  for (const std::string& path : paths) search.add_path(path);
  return search.take();
}

}  // namespace shadefit::lint
