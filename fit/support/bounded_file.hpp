#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

/// Reading files of others: never more of one than was bargained for.
namespace shadefit {

/// Throws UserError where there is no such regular file, or it has more than `most_bytes`.
void require_size(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// The whole of a file of at most `most_bytes`, which its size is compared with before anything is read.
/// Throws UserError naming the file.
std::string read_bounded(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// `length` bytes of a file from `offset` on. Throws UserError naming the file, also where it ends before.
std::string read_part(const std::filesystem::path& path, std::uintmax_t offset, std::uintmax_t length);

}  // namespace shadefit
