#pragma once

/// The second reading of words like "accurate": what a display first shows.
namespace shadefit {

/// The smallest relative change that moves a grey in [0, 1] by a whole 8-bit sRGB code: how much darker white
/// has to become to be sent as 254.
double change_of_one_code();

}  // namespace shadefit
