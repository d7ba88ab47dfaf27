#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "bench/tradeoff/measure.hpp"

namespace shadefit::bench {
namespace {

/// The place of a column.
std::size_t find_column(const Table& table, const std::string& name) {
  const auto column = std::find(table.columns.begin(), table.columns.end(), name);
  if (column == table.columns.end()) throw std::logic_error("no column " + name);
  return static_cast<std::size_t>(column - table.columns.begin());
}

/// The degree in a cell; 0 for the library's functions and for forms without exp2.
int degree_of(const std::string& text) {
  int degree = 0;
  std::from_chars(text.data(), text.data() + text.size(), degree);
  return degree;
}

}  // namespace

std::vector<FormError> form_errors(const Table& accuracy) {
  const std::size_t target = find_column(accuracy, "target"), form = find_column(accuracy, "form"),
                    constants = find_column(accuracy, "constants"), exp2 = find_column(accuracy, "exp2"),
                    arithmetic = find_column(accuracy, "arithmetic"),
                    error = find_column(accuracy, "max_abs_error");
  std::vector<FormError> scalar, wide;
  for (const auto& row : accuracy.rows) {
    const auto word = [&](std::size_t column) { return text(row.at(column), Precision::full); };
    const auto* number = std::get_if<Number>(&row.at(error));
    const std::string in = word(arithmetic);
    if (number == nullptr || !(in.starts_with("float") || in.starts_with("double"))) continue;
    FormError found{
        word(target), word(form), word(constants), degree_of(word(exp2)), in.starts_with("double"),
        number->value};
    (in.ends_with(" SSE2") ? wide : scalar).push_back(std::move(found));
  }
  // The first of two is the one that is found.
  wide.insert(wide.end(), scalar.begin(), scalar.end());
  return wide;
}

}  // namespace shadefit::bench
