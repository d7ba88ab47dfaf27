#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/io/own_fields.hpp"

/// Long work in parts: each part is done by one process and written as a file, and `merge` unites the files.
namespace shadefit {

/// A part of divided work: number `index`, counted from 1, of `of` parts.
struct Shard {
  unsigned index = 1, of = 1;
  bool operator==(const Shard&) const = default;
};

/// "2/4". Throws UserError, naming the option, unless 1 <= i <= n.
Shard parse_shard(const std::string& text);

/// The shard as `parse_shard` reads it.
std::string text_of(const Shard& shard);

/// The field `shard` of a file: [i, n]. Throws UserError unless 1 <= i <= n.
Shard read_shard(const OwnFields& fields);

/// The file of a part, in the directory --out.
inline constexpr const char* shard_file = "shard.json";

/// The field with the version of shadefit, in a file and in an identity.
inline constexpr const char* version_field = "version";

/// The names and values that all parts of one work have in common, in one order.
using WorkIdentity = std::vector<std::pair<std::string, std::string>>;

/// The first thing that differs, "another form: sg, not schlick"; empty if nothing does.
std::string difference(const WorkIdentity& found, const WorkIdentity& wanted);

/// A part that was read back.
struct Part {
  std::string file;  ///< as messages name it: "state file 'a.json'"
  WorkIdentity identity;
  Shard shard;
  bool is_done = true;
};

/// Throws UserError, naming the file, unless the parts belong to one work of this version, are done, and each
/// shard occurs once.
void require_whole(const std::vector<Part>& parts, const std::string& version);

}  // namespace shadefit
