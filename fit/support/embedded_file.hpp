#pragma once

#include <string_view>

namespace shadefit {

/// A file of studies/ that comes with the library.
struct EmbeddedFile {
  std::string_view name, text;
};

}  // namespace shadefit
