#pragma once

#include <functional>

#include "fit/support/checkpoint.hpp"
#include "reports/io/table.hpp"

/// The errors of every form: the table `accuracy.csv`.
namespace shadefit::forms {

/// A row for each form with each set of its constants, each exp2 and each arithmetic:
/// - `target`, `form`, `constants`: ids of the catalogue; `values`: the constants;
/// - `exp2`: the degree of the polynomial, `library`, or empty if the form has none;
/// - `arithmetic`: `double`, `float` or `half`;
/// - `max_abs_error` and `max_abs_error_at` (the smallest c of those equal within 1e-6; empty for lights),
///   `max_rel_error` and `max_ulps`, of the arithmetic (both for targets of at least 1/255), `rms_error`
///   (uniform in the cosine) and `srgb_codes`: over a dense grid and the edges, against the target in long
///   double.
///
/// Functions are evaluated in long double and rounded once, all the rest are basic operations: the same bytes
/// everywhere. The checkpoint is called for each row, `progress` with the share that is done.
Table accuracy_table(
    const Checkpoint& checkpoint = keep_going,
    const std::function<void(double share)>& progress = [](double) {});

}  // namespace shadefit::forms
