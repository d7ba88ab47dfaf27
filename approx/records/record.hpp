#pragma once

#include <string_view>

/// Records: what was published, where, and its meaning. Records are data; the formulas are separate.
namespace shadefit {

/// Where a number was published. `title` is quoted as it stands there.
struct Source {
  std::string_view author;
  int year;
  std::string_view title;
  std::string_view place;
  std::string_view address = {};  ///< on the web; empty where `place` is one, or where we know none
};

/// One published normalisation constant: a closed form that numerical integration has to confirm.
struct Normalisation {
  std::string_view id;
  std::string_view lobe;     ///< the function whose integral over the hemisphere is normalised
  std::string_view printed;  ///< the closed form as printed, a = alpha
  bool has_exponent;
  Source source;
  /// The relative difference that its source's claim allows: 0 for an exact closed form.
  double closeness = 0;
};

}  // namespace shadefit
