#include "fit/truths/albedo_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace shadefit {
namespace {

constexpr double side_in_alpha = 2, least_alpha = -10;
/// The last row begins so far below alpha, and is smooth in this root of c.
constexpr double below_alpha = 4, root_of_last = 8;

/// From 0 to the last value; sides are shorter at the edges.
std::vector<double> ends_of(double side, const std::vector<double>& edges, double last) {
  std::vector<double> ends{0};
  for (const double edge : edges) ends.push_back(std::log(edge));
  while (ends.back() > last) ends.push_back(std::max(ends.back() - side, last));
  return ends;
}

/// The derivatives of orders 0 to 3 of a sum of Chebyshev polynomials of degrees 0, 1 .. need those of the
/// polynomials: here at x, of one order.
template <class T, std::size_t terms>
std::array<T, terms> chebyshev(T x, int order) {
  std::array<T, terms> lower{}, result{};
  for (int of = 0; of <= order; ++of) {
    // T(k+1) = 2 x T(k) - T(k-1), differentiated.
    result[0] = of == 0 ? 1 : 0;
    result[1] = of == 0 ? x : static_cast<T>(of == 1 ? 1 : 0);
    for (std::size_t k = 2; k < terms; ++k)
      result[k] = 2 * x * result[k - 1] - result[k - 2] + 2 * static_cast<T>(of) * lower[k - 1];
    lower = result;
  }
  return result;
}

/// The same for derivatives by log(x'), where x' in [0, 1] is x = 2 x' - 1 and the function is one of
/// c = x'^root_of_last: with D = d/dx', (x' D)^2 = x'^2 D^2 + x' D and (x' D)^3 = x'^3 D^3 + 3 x'^2 D^2 + x'
/// D.
template <class T, std::size_t terms>
std::array<T, terms> chebyshev_of_root(T share, int order) {
  constexpr int factors[][4]{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 1, 0}, {0, 1, 3, 1}};
  std::array<T, terms> result{};
  T power = 1, scale = 1;
  for (int of = 0; of <= order; ++of, power *= 2 * share) {
    const std::array<T, terms> part = chebyshev<T, terms>(2 * share - 1, of);
    for (std::size_t k = 0; k < terms; ++k) result[k] += static_cast<T>(factors[order][of]) * power * part[k];
    if (of > 0) scale /= static_cast<T>(root_of_last);
  }
  for (T& value : result) value *= scale;
  return result;
}

/// The same for derivatives by a variable in [low, high].
template <class T, std::size_t terms>
std::array<T, terms> chebyshev_between(double low, double high, T at, int order) {
  std::array<T, terms> result = chebyshev<T, terms>((2 * at - (low + high)) / (high - low), order);
  for (int k = 0; k < order; ++k) {
    for (T& value : result) value *= 2 / static_cast<T>(high - low);
  }
  return result;
}

}  // namespace

AlbedoTable::AlbedoTable(Rule rule, double side, const std::vector<double>& edges) : rule_(rule) {
  const std::vector<double> ends = ends_of(side_in_alpha, {}, least_alpha);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    Column column{ends[i - 1], ends[i], ends_of(side, edges, ends[i] - below_alpha), nullptr};
    column.rectangles = std::make_unique<Rectangle[]>(column.rows.size());
    columns_.push_back(std::move(column));
  }
}

AlbedoTable::Coefficients AlbedoTable::computed(const Column& column, std::size_t row) const {
  const auto angle = [](std::size_t k) {
    return std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(terms);
  };
  const auto between = [&](double high, double low, std::size_t k) {
    return std::exp((high + low) / 2 + (high - low) / 2 * std::cos(angle(k)));
  };
  const auto c_at = [&](std::size_t k) {
    if (row + 1 < column.rows.size()) return between(column.rows[row], column.rows[row + 1], k);
    return std::exp(column.rows[row] + root_of_last * std::log((1 + std::cos(angle(k))) / 2));
  };
  Coefficients values, half, result;
  for (std::size_t i = 0; i < terms; ++i) {
    for (std::size_t j = 0; j < terms; ++j)
      values[i][j] = rule_(c_at(i), between(column.most, column.least, j));
  }
  // The cosine sums of the values, along one variable and then along the other.
  const auto weight = [&](std::size_t degree, std::size_t k) {
    return (degree == 0 ? 1 : 2) * std::cos(static_cast<double>(degree) * angle(k)) /
           static_cast<double>(terms);
  };
  const auto transform = [&](const Coefficients& from, Coefficients& to) {
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t degree = 0; degree < terms; ++degree) {
        to[degree][i] = 0;
        for (std::size_t k = 0; k < terms; ++k) to[degree][i] += weight(degree, k) * from[i][k];
      }
    }
  };
  transform(values, half);
  transform(half, result);
  return result;
}

template <class T>
T AlbedoTable::derivative(int by_c, int by_alpha, T c, T alpha) const {
  // What is above 1 by rounding is 1.
  constexpr double above = 1 + 1e-12;
  if (!(c >= 0 && c <= above && alpha >= 0 && alpha <= above)) return std::numeric_limits<T>::quiet_NaN();
  const T given = std::log(alpha), log_alpha = std::clamp(given, static_cast<T>(least_alpha), T(0));
  if (given < log_alpha && by_alpha > 0) return 0;
  const T log_c = std::min(std::log(c), T(0));

  const auto is_in = [&](const Column& column) { return log_alpha >= column.least; };
  const Column& column = *std::find_if(columns_.begin(), columns_.end() - 1, is_in);
  const auto below =
      std::find_if(column.rows.begin() + 1, column.rows.end(), [&](double end) { return log_c >= end; });
  const auto row = static_cast<std::size_t>(below - column.rows.begin()) - 1;
  Rectangle& rectangle = column.rectangles[row];
  std::call_once(rectangle.is_made, [&] { rectangle.coefficients = computed(column, row); });

  const auto of_c = below == column.rows.end()
                        ? chebyshev_of_root<T, terms>(
                              std::exp((log_c - column.rows[row]) / static_cast<T>(root_of_last)), by_c)
                        : chebyshev_between<T, terms>(*below, column.rows[row], log_c, by_c);
  const auto of_alpha = chebyshev_between<T, terms>(column.least, column.most, log_alpha, by_alpha);
  T sum = 0;
  for (std::size_t i = terms; i-- > 0;) {
    T of_row = 0;
    for (std::size_t j = terms; j-- > 0;)
      of_row += static_cast<T>(rectangle.coefficients[i][j]) * of_alpha[j];
    sum += of_row * of_c[i];
  }
  return sum;
}

template double AlbedoTable::derivative<double>(int, int, double, double) const;
template long double AlbedoTable::derivative<long double>(int, int, long double, long double) const;

}  // namespace shadefit
