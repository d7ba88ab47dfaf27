#pragma once

#include <string>

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/study_file.hpp"

namespace shadefit {

/// A family of the catalogue as a study: its form, its target on a surface, its usual exponents, and the best
/// fits that were published for it. A published number alone is a set of its own, for any exponent. The
/// weight multiplies that of the surface.
StudyFile family_file(const Family& family, const Published* published, const Surface& surface,
                      Error error = Error::absolute, const std::string& weight = "");

/// Replaces the forms by all forms of the catalogue for the target of the family, its own first, each with
/// the curves that were published for it, whatever they were published for. On an exact surface Schlick's
/// formula is one of them. A published number of the family, or null, has the first curve.
void take_rivals(StudyFile& file, const Family& family, const Published* published, const Surface& surface);

/// Whether two families approximate the same function.
bool have_same_target(const Family& a, const Family& b);

/// The part of the range that counts for a relative error of a lobe: where it is at least 1/255, one code of
/// an 8-bit linear target. Throws UserError where that is below any double.
void narrow_to_visible(StudyFile& file);

}  // namespace shadefit
