#pragma once

#include <optional>
#include <string>

#include "approx/cosine.hpp"
#include "fit/study/study.hpp"

/// Curves of a cosine c that are steep next to c = 1, such as c^k: their fits are in another variable.
namespace shadefit {

/// The smallest cosine with c^k >= 1/255, one code of an 8-bit linear target: exp(-log(255)/k). Empty below
/// k = 0.0078, where that is less than any double.
std::optional<Cosine<double>> where_lobe_is_visible(double exponent);

/// Whether a study has formulas of y = 1 - c.
bool has_peak(const Study& study);

/// The study in which such a curve is fitted, by those formulas. For an exponent k of at least 2 its variable
/// is t = k (c - 1), in which all lobes are equally wide; else it is c. A study without a peak is returned
/// as it is.
Study near_peak(Study study);

/// The variable of that study.
struct PeakVariable {
  double exponent = 0;  ///< above 0 the variable is t = exponent (c - 1); 0: it is c itself

  Cosine<double> cosine_at(double value) const;
  double value_at(const Cosine<double>& cosine) const;
};

PeakVariable peak_variable(const Study& study);

/// A sentence that ends with a place of that study, with its cosine: "no parameters .. at c = 0".
std::string in_cosines(const PeakVariable& variable, std::string sentence);

}  // namespace shadefit
