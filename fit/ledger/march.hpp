#pragma once

#include <string_view>
#include <vector>

/// Marching a ray past one shadow edge: errors over all places of the edge, in closed form.
namespace shadefit {

/// The entries of a dither matrix, "0 0.5 / 0.75 x", row by row, with `x` for the letter x.
std::vector<double> dither_matrix(std::string_view text, double x);

/// The numbers of 0/n .. (n-1)/n, n the number of entries, that are missing.
std::vector<double> missing_from(const std::vector<double>& entries);

/// Errors of the estimated lit share of a ray, over a shadow edge uniform along it; light of strength 1.
struct MarchError {
  double rms = 0;
  double largest = 0;
  double rms_by_warnock = 0;  ///< the same rms by another formula
};

/// The error of the mean of samples at these places in [0, 1), in any order, with the ray lit from 0 to the
/// edge e: #{s < e}/N - e. Between two places it is linear in e, so the integral of its square is exact.
///
/// Warnock's formula for the same (1972, "Computational investigations of low-discrepancy point sets"):
///   1/3 - (1/N) sum (1 - s^2) + (1/N^2) sum sum (1 - max(s, s')).
MarchError march_error(std::vector<double> places);

/// n steps started at the offset of one pixel, or of each of several: (i + offset)/n.
std::vector<double> march_places(int steps, const std::vector<double>& offsets);

/// The share of all edges for which `more` plain steps have a larger error than `fewer` have.
double share_made_worse(int fewer, int more);

}  // namespace shadefit
