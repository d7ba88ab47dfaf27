#pragma once

namespace shadefit {

/// The possible results of `less` for two intervals.
enum class Certainty { no, yes, unknown };

}  // namespace shadefit
