#include "fit/ledger/lobes/march.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fit/ledger/finding.hpp"
#include "fit/support/format.hpp"

namespace shadefit {

std::vector<double> dither_matrix(std::string_view text, double x) {
  const auto bad = [&] {
    return std::invalid_argument(fmt::format("not a square matrix with one x: {}", text));
  };
  std::vector<double> entries;
  int letters = 0;
  const auto rows = items_of(text, '/');
  for (const std::string_view row : rows) {
    const auto words = items_of(row, ' ');
    if (words.size() != rows.size()) throw bad();
    for (const std::string_view word : words) {
      letters += word == "x" ? 1 : 0;
      entries.push_back(word == "x" ? x : number_of(word));
    }
  }
  const bool is_power_of_two = (rows.size() & (rows.size() - 1)) == 0;
  if (letters != 1 || !is_power_of_two) throw bad();
  return entries;
}

std::vector<double> missing_from(const std::vector<double>& entries) {
  std::vector<double> missing;
  const auto n = static_cast<double>(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const double value = static_cast<double>(k) / n;
    if (std::ranges::find(entries, value) == entries.end()) missing.push_back(value);
  }
  return missing;
}

MarchError march_error(std::vector<double> places) {
  std::ranges::sort(places);
  const auto n = static_cast<double>(places.size());
  const auto cube = [](double t) { return t * t * t; };
  MarchError error;
  double squares = 0, left = 0;
  // For an edge between `left` and `right`, k places lie below it: the error is k/n - e.
  const auto piece = [&](double k, double right) {
    const double at_left = k / n - left, at_right = k / n - right;
    squares += (cube(at_left) - cube(at_right)) / 3;
    error.largest = std::max({error.largest, std::abs(at_left), std::abs(at_right)});
    left = right;
  };
  double k = 0, squared_places = 0, larger_of_pairs = 0;
  for (const double place : places) {
    piece(k, place);
    ++k;
    squared_places += place * place;
    larger_of_pairs += (2 * k - 1) * place;  // it is the larger one in 2k - 1 of the ordered pairs
  }
  piece(k, 1);
  error.rms = std::sqrt(squares);
  error.rms_by_warnock = std::sqrt(1.0 / 3 - (1 - squared_places / n) + (1 - larger_of_pairs / (n * n)));
  return error;
}

std::vector<double> march_places(int steps, const std::vector<double>& offsets) {
  std::vector<double> places;
  for (int i = 0; i < steps; ++i) {
    for (const double offset : offsets) places.push_back((i + offset) / steps);
  }
  return places;
}

double share_made_worse(int fewer, int more) {
  // In units of 1/(fewer more) every jump of either estimate is a whole number.
  const long all = static_cast<long>(fewer) * more;
  long worse = 0;
  for (long cell = 0; cell < all; ++cell) {
    const long estimate_of_fewer = (cell / more + 1) * more, estimate_of_more = (cell / fewer + 1) * fewer;
    worse += estimate_of_more > estimate_of_fewer ? 1 : 0;
  }
  return static_cast<double>(worse) / static_cast<double>(all);
}

}  // namespace shadefit
