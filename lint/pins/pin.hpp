#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Marks that say which published constant a number is.
namespace shadefit::lint {

/// A comment that begins with "shadefit: STUDY.CONSTANT" or "shadefit: STUDY.FORM.CONSTANT".
struct Pin {
  std::size_t offset = 0;  ///< of `name`
  std::string_view name;   ///< "acos-linear.a"
  /// The last number between an earlier mark and the comment in its line; empty: there is none.
  std::size_t number_offset = 0;
  std::string_view number;
};

/// The marks of a text, by their places. A comment begins with //, #, /* or <!--, or with the signs of one
/// that documents, such as //!< and /**, in every language.
std::vector<Pin> pins_of(std::string_view text);

/// The reason of a comment in a line that begins with "shadefit: ignore REASON".
std::optional<std::string> ignore_reason(std::string_view line);

}  // namespace shadefit::lint
