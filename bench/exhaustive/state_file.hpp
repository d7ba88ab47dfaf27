#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "bench/exhaustive/sweep.hpp"

/// Sweeps as files. A shard's result, a state to resume and the final result are the same kind of file. So
/// the final file has the same bytes, whether the sweep was interrupted or not.
///
/// Constants and errors are hexadecimal texts, nothing is rounded; floats are named by their bit patterns.
/// `digest` is that of certificates.
namespace shadefit::bench {

/// The field `file` of these files.
inline constexpr const char* sweep_kind = "shadefit exhaustive";

/// The version of the file; it grows when a field changes its meaning.
inline constexpr int sweep_schema = 2;

/// The size limit of a file; written files have 2 KB.
inline constexpr std::uintmax_t most_state_bytes = 1U << 16;

/// The text of a file.
std::string state_text(const Sweep& sweep);

/// Reads a text back. Messages begin with `name`: "state file 'a.json'". Throws UserError with one line if
/// `parse_own_json` refuses the text, if it is not a state or has another version, if a field is missing, if
/// the digest is wrong, or if `state_text` would write its content differently.
Sweep parse_state(const std::string& text, const std::string& name);

/// Writes a state like `write_files`: after an error the old file is unchanged.
void keep_state(const std::filesystem::path& path, const Sweep& sweep);

/// Reads a file. Throws UserError as `parse_state` and `read_bounded` do.
NamedSweep read_state(const std::filesystem::path& path);

}  // namespace shadefit::bench
