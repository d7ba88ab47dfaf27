#include "app/shards/merge_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/output/output_file.hpp"
#include "app/shards/sweeps.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "fit/support/json_document.hpp"
#include "fit/support/user_error.hpp"
#include "reports/gallery/gallery_shard.hpp"
#include "reports/io/own_fields.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// A part as it was read: the name of its file, for messages, and its text.
struct PartText {
  std::string name, text;
};

PartText read_part(const fs::path& path) {
  return {fmt::format("shard file '{}'", path.string()), read_file(path)};
}

/// The file of a part that was given by its name or by its directory.
fs::path shard_file_of(const fs::path& given) {
  std::error_code error;
  return fs::is_directory(given, error) ? given / shard_file : given;
}

/// The names of the sweeps in a directory without a shard file: a part of every form.
std::vector<std::string> sweeps_in(const fs::path& given) {
  std::error_code error;
  std::vector<std::string> names;
  if (!fs::is_directory(given, error) || fs::exists(given / shard_file, error)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(given, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("exhaustive-") && name.ends_with(".json")) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// What the file says that it is.
std::string kind_of(const PartText& part) {
  const auto json = parse_own_json(part.text, part.name);
  return OwnFields(json, part.name).text("file");
}

bench::Sweep merged_sweep(const std::vector<PartText>& parts) {
  std::vector<bench::NamedSweep> sweeps;
  for (const auto& [name, text] : parts) sweeps.push_back({name, bench::parse_state(text, name)});
  return bench::merge(sweeps, SHADEFIT_VERSION);
}

File file_of(const bench::Sweep& sweep) {
  return {bench::file_of(sweep.identity), bench::state_text(sweep)};
}

/// The files of the whole; the first is the one to be named.
std::vector<File> merged(const std::vector<PartText>& parts) {
  if (const std::string kind = kind_of(parts.front()); kind == bench::sweep_kind) {
    return {file_of(merged_sweep(parts))};
  } else if (kind != gallery_kind) {
    throw UserError(fmt::format("{} is not a part of divided work: it says '{}'", parts.front().name, kind));
  }
  std::vector<NamedGalleryShard> shards;
  for (const auto& [name, text] : parts) shards.push_back({name, parse_gallery_shard(text, name)});
  return gallery_files(merge(shards, SHADEFIT_VERSION));
}

/// The same of parts that have sweeps of these names: their table, and each sweep.
std::vector<File> merged_forms(const std::vector<std::string>& names, const std::vector<std::string>& parts) {
  std::vector<bench::Sweep> sweeps;
  for (const std::string& name : names) {
    std::vector<PartText> texts;
    for (const std::string& part : parts) texts.push_back(read_part(fs::path(part) / name));
    sweeps.push_back(merged_sweep(texts));
  }
  std::vector<File> files{errors_file(forms::catalogue(), sweeps)};
  for (const bench::Sweep& sweep : sweeps) files.push_back(file_of(sweep));
  return files;
}

std::vector<File> merged(const std::vector<std::string>& given) {
  if (const auto names = sweeps_in(given.front()); !names.empty()) {
    for (const std::string& part : given) {
      if (sweeps_in(part) != names)
        throw UserError(
            fmt::format("'{}' has other sweeps than '{}': all parts must come from the same command", part,
                        given.front()));
    }
    return merged_forms(names, given);
  }
  std::vector<PartText> parts;
  for (const std::string& part : given) parts.push_back(read_part(shard_file_of(part)));
  return merged(parts);
}

}  // namespace

Outcome merge_command(const MergeOptions& options, const Checkpoint& checkpoint) {
  const std::vector<File> files = merged(options.parts);
  const OutputFolder folder(options.out);
  const auto put = folder.prepare(files, {}, options.force, checkpoint);
  const fs::path first = without_detours(options.out) / files.front().name;
  return {0, fmt::format("Whole: {}\n", printable(first.string())), "", put};
}

}  // namespace shadefit
