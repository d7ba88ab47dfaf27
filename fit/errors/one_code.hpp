#pragma once

/// The second reading of words like "accurate": the smallest change that a display shows.
namespace shadefit {

/// The smallest relative change that moves a grey in [0, 1] by a whole 8-bit sRGB code: white that is darker
/// by this is sent as 254.
double change_of_one_code();

}  // namespace shadefit
