#include "app/shards/merge_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/output/output_folder.hpp"
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

PartText read_shard_file(const std::string& given) {
  std::error_code error;
  const fs::path path = fs::is_directory(given, error) ? fs::path(given) / shard_file : fs::path(given);
  return {fmt::format("shard file '{}'", path.string()), read_file(path)};
}

/// What the file says that it is.
std::string kind_of(const PartText& part) {
  const auto json = parse_own_json(part.text, part.name);
  return OwnFields(json, part.name).text("file");
}

/// The files of the whole; the first is the one to be named.
std::vector<File> merged(const std::vector<PartText>& parts) {
  if (const std::string kind = kind_of(parts.front()); kind == bench::sweep_kind) {
    std::vector<bench::NamedSweep> sweeps;
    for (const auto& [name, text] : parts) sweeps.push_back({name, bench::parse_state(text, name)});
    const bench::Sweep whole = bench::merge(sweeps, SHADEFIT_VERSION);
    return {{bench::file_of(whole.identity), bench::state_text(whole)}};
  } else if (kind != gallery_kind) {
    throw UserError(fmt::format("{} is not a part of divided work: it says '{}'", parts.front().name, kind));
  }
  std::vector<NamedGalleryShard> shards;
  for (const auto& [name, text] : parts) shards.push_back({name, parse_gallery_shard(text, name)});
  return gallery_files(merge(shards, SHADEFIT_VERSION));
}

}  // namespace

Outcome merge_command(const MergeOptions& options, const Checkpoint& checkpoint) {
  std::vector<PartText> parts;
  for (const std::string& part : options.parts) parts.push_back(read_shard_file(part));
  const std::vector<File> files = merged(parts);
  const OutputFolder folder(options.out);
  const auto put = folder.prepare(files, {}, options.force, checkpoint);
  const fs::path first = without_detours(options.out) / files.front().name;
  return {0, fmt::format("Whole: {}\n", printable(first.string())), "", put};
}

}  // namespace shadefit
