#include <algorithm>
#include <string>

#include "fit/input/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "lint/tree/source_tree.hpp"

namespace shadefit::lint {
namespace {

/// A text has no byte 0; git looks for it in the first 8000 bytes.
constexpr std::size_t looked_at = 8192;

/// People write lines of 30 to 100 bytes. Other code may have data in a long line; in minified code nearly
/// all lines are long.
constexpr std::size_t least_minified_bytes = 8192, least_minified_mean = 1000;

bool is_minified(const std::string& text) {
  if (text.size() < least_minified_bytes) return false;
  const auto ends = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  return text.size() / (ends + 1) >= least_minified_mean;
}

}  // namespace

void add(SkippedFiles& sum, const SkippedFiles& part) {
  using Skipped = SkippedFiles;
  for (const auto count :
       {&Skipped::unknown_language, &Skipped::binary, &Skipped::too_large, &Skipped::vendored,
        &Skipped::minified, &Skipped::ignored, &Skipped::unreadable, &Skipped::links, &Skipped::in_tables})
    sum.*count += part.*count;
  sum.messages.insert(sum.messages.end(), part.messages.begin(), part.messages.end());
}

std::optional<std::string> read_source(const SourceFile& file, SkippedFiles& skipped) {
  std::string text;
  try {
    text = read_bounded(file.path, largest_source);  // it may have grown since it was found
  } catch (const UserError& error) {
    ++skipped.unreadable;
    skipped.messages.emplace_back(error.what());
    return std::nullopt;
  }
  if (text.find('\0') < looked_at) {
    ++skipped.binary;
    return std::nullopt;
  }
  if (is_minified(text)) {
    ++skipped.minified;
    return std::nullopt;
  }
  return text;
}

}  // namespace shadefit::lint
