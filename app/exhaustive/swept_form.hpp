#pragma once

#include <string>
#include <vector>

#include "app/options/bench_options.hpp"
#include "bench/exhaustive/float_errors.hpp"
#include "bench/forms/catalogue.hpp"

/// The form that `bench --exhaustive` names.
namespace shadefit {

/// Instead of the name of a form: every form of one cosine.
inline constexpr const char* every_form = "all";

/// The form and its target that a sweep compares.
struct SweptForm {
  const forms::FormEntry* form;
  const forms::Target* target;
  const forms::Constants* constants;
  int exp2_degree = 0;  ///< 0: the exp2 of the library
  forms::Width width = forms::Width::sse2;
};

/// Every form of one cosine with every set of its constants.
std::vector<SweptForm> all_of_one_cosine(const forms::Catalogue& catalogue);

/// Throws UserError for a form or a set of constants that the catalogue does not have.
SweptForm chosen_by(const forms::Catalogue& catalogue, const BenchOptions& options);

/// The form with its constants in words: "sg, published-sg-offset-mean".
std::string words_of(const SweptForm& form);

/// The id of its set of constants; empty for a form without any.
std::string set_of(const SweptForm& form);

std::vector<float> in_float(const std::vector<double>& numbers);

/// The form in float. The reference is the target's formula in double, by the library. Its error is a few
/// last bits of a double: less than one for pow of the C library (as documented), half of one for 1 - c of a
/// float, multiplied by a power of some tens. One ulp of a float is 2^29 ulps of a double, so the reference
/// rounds to the right float, except within a millionth of the middle between two floats.
///
/// Throws UserError for a degree of exp2 that the form does not have.
bench::FloatSubject subject_of(const forms::Catalogue& catalogue, const SweptForm& chosen);

}  // namespace shadefit
