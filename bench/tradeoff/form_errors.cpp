#include <algorithm>
#include <cstdlib>

#include "bench/tradeoff/measure.hpp"

namespace shadefit::bench {

std::vector<FormError> form_errors(const Table& accuracy) {
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(accuracy.columns, name) - accuracy.columns.begin());
  };
  std::vector<FormError> scalar, wide;
  for (const auto& row : accuracy.rows) {
    const auto word = [&](const char* name) { return text(row.at(column(name)), Precision::full); };
    const auto* number = std::get_if<Number>(&row.at(column("max_abs_error")));
    const std::string in = word("arithmetic");
    if (number == nullptr || !(in.starts_with("float") || in.starts_with("double"))) continue;
    // An exp2 is the degree of a polynomial; 0 for the library's functions and for forms without one.
    FormError found{word("target"),           word("form"),
                    word("constants"),        std::atoi(word("exp2").c_str()),
                    in.starts_with("double"), number->value};
    (in.ends_with(" SSE2") ? wide : scalar).push_back(std::move(found));
  }
  // The first of two is the one that is found.
  wide.insert(wide.end(), scalar.begin(), scalar.end());
  return wide;
}

}  // namespace shadefit::bench
