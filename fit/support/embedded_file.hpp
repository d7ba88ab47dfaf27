#pragma once

#include <algorithm>
#include <string_view>

namespace shadefit {

/// A file that comes with the library, by its name without its ending.
struct EmbeddedFile {
  std::string_view name, text;
};

/// The text of one of these files, which has to be there.
template <class Files>
constexpr std::string_view embedded_text(const Files& files, std::string_view name) {
  return std::ranges::find(files, name, &EmbeddedFile::name)->text;
}

}  // namespace shadefit
