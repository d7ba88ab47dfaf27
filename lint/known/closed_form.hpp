#pragma once

namespace shadefit::lint {

/// Whether a number is, to seven digits, a simple fraction, perhaps times pi, 1/pi, sqrt(2), ln 2 or 1/ln 2.
/// Such numbers occur in all kinds of code, so their digits tell little.
bool is_common_number(double value);

}  // namespace shadefit::lint
