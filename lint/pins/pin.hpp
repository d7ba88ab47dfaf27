#pragma once

#include <cstddef>
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

/// The marks of a text, by their places. A comment begins with //, #, /* or <!--, in every language.
std::vector<Pin> pins_of(std::string_view text);

}  // namespace shadefit::lint
