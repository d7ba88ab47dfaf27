#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

/// A function of c and alpha on [0, 1] that costs a quadrature, interpolated.
namespace shadefit {

/// The table has Chebyshev polynomials of degree 23 in two variables, on rectangles. These are log(c) and
/// log(alpha), with sides of 2 or 1: there the albedos of microfacets are analytic, up to a distance of pi/2
/// from the axis. The last row reaches from c = e^-4 times the least alpha of its column down to 0, where
/// they have terms such as c log(c): there the first variable is the eighth root of c. A rectangle is
/// computed when it is used first. alpha below e^-10 counts as e^-10.
class AlbedoTable {
 public:
  using Rule = double (*)(double c, double alpha);

  /// The function is not analytic at the `edges`, values of c in falling order. `side` is the largest one in
  /// log(c).
  AlbedoTable(Rule rule, double side, const std::vector<double>& edges);

  /// (c d/dc)^by_c (alpha d/dalpha)^by_alpha of the function, each at most 3; not a number outside of [0, 1].
  template <class T>
  T derivative(int by_c, int by_alpha, T c, T alpha) const;

 private:
  static constexpr std::size_t terms = 24;
  using Coefficients = std::array<std::array<double, terms>, terms>;  ///< by degree in c, in alpha
  struct Rectangle {
    std::once_flag is_made;
    Coefficients coefficients;
  };
  struct Column {
    double most, least;        ///< log(alpha)
    std::vector<double> rows;  ///< the ends of its rows in log(c), falling from 0; the last row is below them
    std::unique_ptr<Rectangle[]> rectangles;
  };

  Coefficients computed(const Column& column, std::size_t row) const;

  Rule rule_;
  std::vector<Column> columns_;
};

extern template double AlbedoTable::derivative<double>(int, int, double, double) const;
extern template long double AlbedoTable::derivative<long double>(int, int, long double, long double) const;

}  // namespace shadefit
