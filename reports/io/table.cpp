#include "reports/io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/io/escape.hpp"

namespace shadefit {
namespace {

constexpr int parameter_digits = 10;
constexpr int place_digits = 6;

/// The decimal exponent of a number: 0 for [1, 10).
int decimal_exponent(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

}  // namespace

std::string text(const Cell& cell, Precision precision) {
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  if (const auto* others = std::get_if<OthersText>(&cell)) return for_terminal(*others);
  if (const auto* whole = std::get_if<long>(&cell)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<Number>(&cell)) {
    const double value = number->value == 0 ? 0 : number->value;
    const bool is_shortest = precision == Precision::full || number->digits >= all_digits;
    return is_shortest ? fmt::format("{}", value) : fmt::format("{:.{}g}", value, number->digits);
  }
  return "";
}

Table with_columns_as_one(const Table& table, std::size_t first, std::size_t count, const std::string& title,
                          Precision precision) {
  Table result = table;
  const auto replace = [&](auto& cells, auto cell) {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(first);
    cells.insert(cells.erase(begin, begin + static_cast<std::ptrdiff_t>(count)), cell);
  };
  replace(result.columns, title);
  for (auto& row : result.rows) {
    std::string parts;
    for (std::size_t i = first; i < first + count; ++i) {
      const std::string value = text(row[i], precision);
      if (!value.empty()) parts += (parts.empty() ? "" : ", ") + table.columns[i] + " = " + value;
    }
    replace(row, parts.empty() ? Cell() : Cell(parts));
  }
  return result;
}

Table columns_of(const Table& table, const std::vector<std::size_t>& places) {
  Table result{{}, std::vector<std::vector<Cell>>(table.rows.size())};
  for (const std::size_t place : places) {
    result.columns.push_back(table.columns[place]);
    for (std::size_t i = 0; i < table.rows.size(); ++i) result.rows[i].push_back(table.rows[i][place]);
  }
  return result;
}

Table transposed(const Table& table) {
  Table result{{table.columns.front()}};
  for (const auto& row : table.rows) result.columns.push_back(text(row.front(), Precision::report));
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    auto& cells = result.rows.emplace_back(std::vector<Cell>{table.columns[i]});
    for (const auto& row : table.rows) cells.push_back(row[i]);
  }
  return result;
}

std::string in_digits(double value, int digits) {
  return text(Number{value, digits}, Precision::report);
}

Cell word(std::string_view text) {
  return std::string(text);
}

Number converged(double value) {
  return Number{value, parameter_digits};
}

Cell place(const Cosine<double>& at) {
  const int zeros = at.one_minus_cos > 0 ? -1 - decimal_exponent(at.one_minus_cos) : 0;
  return Number{at.cos_theta, std::max(place_digits, zeros + 3)};
}

Cell difference(double value, double minuend) {
  if (value == 0 || minuend == 0) return Number{value, parameter_digits};
  const int digits = parameter_digits + decimal_exponent(value) - decimal_exponent(minuend);
  return digits < 1 ? Number{0, 1} : Number{value, std::min(digits, parameter_digits)};
}

Cell above_floor(double value, double least) {
  return std::abs(value) < least ? Number{0, 1} : Number{value, 2};
}

}  // namespace shadefit
