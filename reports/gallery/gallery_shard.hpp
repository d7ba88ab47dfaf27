#pragma once

#include <string>
#include <vector>

#include "reports/gallery/gallery.hpp"
#include "reports/io/shard.hpp"

/// A part of a gallery as a file. Study number k, counted from 0, belongs to shard k mod n + 1.
namespace shadefit {

/// The field `file` of these files.
inline constexpr const char* gallery_kind = "shadefit gallery";

/// The version of the file; it grows when a field changes its meaning.
inline constexpr int gallery_schema = 1;

/// A study of the whole gallery, judged in this shard or not.
struct ListedStudy {
  std::string id;
  std::string digest;  ///< of its file and its table
};

struct GalleryShard {
  std::string version;                    ///< of shadefit
  std::vector<ListedStudy> studies = {};  ///< of the whole gallery, in its order
  Shard shard = {};
  std::vector<JudgedStudy> judged = {};  ///< those of this shard
};

/// Whether study number `k` belongs to the shard.
inline bool belongs(std::size_t k, const Shard& shard) {
  return k % shard.of + 1 == shard.index;
}

/// The text of a file, with its digest. Numbers have the digits that the gallery shows.
std::string shard_text(const GalleryShard& shard);

/// Reads a text back. Messages begin with `name`: "shard file 'a.json'". Throws UserError with one line if
/// `parse_own_json` refuses the text, if it is another kind of file or version of it, if a field is missing,
/// if the digest is wrong, if the judged studies are not those of the shard, or if `shard_text` would write
/// its content differently.
GalleryShard parse_gallery_shard(const std::string& text, const std::string& name);

/// A shard with the name of its file, for messages.
struct NamedGalleryShard {
  std::string name;
  GalleryShard shard;
};

/// All studies in their order, from at least one shard. Throws UserError like `require_whole`.
std::vector<JudgedStudy> merge(const std::vector<NamedGalleryShard>& shards, const std::string& version);

}  // namespace shadefit
