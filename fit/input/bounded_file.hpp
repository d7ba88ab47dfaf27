#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "fit/support/checkpoint.hpp"
#include "fit/support/lines.hpp"

/// Reads files of users, never more than a limit.
namespace shadefit {

/// Throws UserError if this is not a regular file, or has more than `most_bytes`.
void require_size(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// A whole file of at most `most_bytes`; the size is checked before anything is read. Throws UserError naming
/// the file.
std::string read_bounded(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// `length` bytes of a file from `offset` on. Throws UserError naming the file, also if it ends before.
std::string read_part(const std::filesystem::path& path, std::uintmax_t offset, std::uintmax_t length);

/// The parts of such a file, of a MiB each: they are read when they are asked for.
TextParts parts_of(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// Standard input to its end, at most `most_bytes`. Calls the checkpoint while it waits. Throws UserError
/// where it cannot be read or has more.
std::string read_standard_input(std::uintmax_t most_bytes, const Checkpoint& checkpoint);
/// The same in parts.
TextParts parts_of_standard_input(std::uintmax_t most_bytes, const Checkpoint& checkpoint);

}  // namespace shadefit
