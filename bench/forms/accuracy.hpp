#pragma once

#include <functional>

#include "fit/support/checkpoint.hpp"
#include "reports/table/table.hpp"

/// The errors of every form: the table `accuracy.csv`.
namespace shadefit::forms {

/// A row for each form with each set of its constants, each exp2 and each arithmetic:
/// - `target`, `form`, `constants`: ids of the catalogue; `values`: the constants;
/// - `exp2`: the degree of the polynomial, `library`, or empty if the form has none;
/// - `arithmetic`: `double`, `float`, `half`, and `double SSE2`, `float SSE2` if these differ from the scalar
/// ones, which only happens with functions of the library;
/// - `max_abs_error` and `max_abs_error_at` (the smallest c of those equal within 1e-6; empty for lights),
///   `max_rel_error` and `max_ulps`, of the arithmetic (both for targets of at least 1/255), `rms_error`
///   (uniform in the cosine) and `srgb_codes`: over a dense grid and the edges, against the target in long
///   double;
/// - bounds, rounded up: `own_error`: the proven bound of the form's error with an exact exp2, in exact
/// arithmetic, over all
///   cosines, codes and places of lights; `total_error`: the same with the polynomial of this row;
///   `rounding_error`: the largest additional error of float, proven (empty for lights, see `Pairing`);
/// - `paired`: `yes` if the exp2 is the cheapest with a total that is proven to be within 1 % of the form's
/// own error; else `no`.
///
/// Functions are those of `Library` and of xsimd, all the rest are basic operations: the same bytes
/// everywhere. The checkpoint is called for each row, `progress` with the share that is done.
Table accuracy_table(
    const Checkpoint& checkpoint = keep_going,
    const std::function<void(double share)>& progress = [](double) {});

}  // namespace shadefit::forms
