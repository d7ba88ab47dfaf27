#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bench/forms/forms.hpp"
#include "fit/study/study_fit.hpp"

/// The timed targets and every form that approximates them, with all their constants: the published ones, and
/// those fitted here under each objective.
namespace shadefit::forms {

/// A number with its name and its text: ten digits for a fit, the same on every machine. The value is that of
/// the text.
struct NamedNumber {
  std::string name;
  std::string printed;
  double value = 0;
};

/// A form's own constants, which follow the target's parameters.
struct Constants {
  std::string id;  ///< "published-sg-offset-mean", "minimax-absolute", "least-squares-cosine", "none" ..
  std::vector<NamedNumber> numbers;
};

struct FormEntry {
  std::string_view id;               ///< that of its kernels
  std::vector<Constants> constants;  ///< at least one set, which may be empty of numbers
};

/// The approximated function. Its parameters come first in the parameters of each of its kernels.
struct Target {
  std::string_view id;      ///< "lobe", "lobe-gloss", "schlick", "phong-1" .. "phong-64", "henyey-greenstein"
  std::string_view text;    ///< "c^k, k = 16"
  Arguments arguments;      ///< what it reads of each element
  double from = 0, to = 1;  ///< the range of its cosines
  std::vector<NamedNumber> parameters;
  std::vector<FormEntry> forms;  ///< the first is the target itself
};

/// The catalogue. Each call computes its fits, in a fraction of a second.
std::vector<Target> catalogue();

/// The pair of exp2((a c + b) c) with the least largest |form - (1-c)^5| over c in [0, 1] if exp2 is a
/// polynomial of approx/exp2_polynomial.hpp and everything else is exact. It compensates a part of the
/// polynomial's error: with degree 2 the published pair is off by 0.0050, this pair by 0.0037. The parameters
/// are b and a, in this order; the level, the largest error, is sampled.
///
/// The degree goes from `least_exp2_degree` to `largest_exp2_degree`, of the polynomials for float. Throws
/// std::logic_error for another.
StudyFit fit_pair_for_exp2(int degree);

/// The parameters of a kernel: the target's, then the form's.
std::vector<double> parameters_of(const Target& target, const Constants& constants);

/// The i-th of N evenly spread directions in the hemisphere around z. It uses only additions, products and
/// quotients, so it is the same on every machine.
std::array<double, 3> spread_direction(std::size_t i);

}  // namespace shadefit::forms
