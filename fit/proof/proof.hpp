#pragma once

#include <functional>
#include <string>
#include <string_view>

/// What all proofs share.
namespace shadefit {

/// The result of proving one property of a curve.
enum class Proof {
  none,     ///< nothing was asked
  proven,   ///< on the whole domain
  refuted,  ///< it certainly fails at a place that was found
  open,     ///< undecided within the allowed number of boxes
};

constexpr std::string_view name(Proof proof) {
  switch (proof) {
    case Proof::none:
      return "none";
    case Proof::proven:
      return "proven";
    case Proof::refuted:
      return "refuted";
    case Proof::open:
      return "open";
  }
  return "";
}

/// The default relative width of bounds: far below any printed digit.
inline constexpr double usual_width = 1e-9;
/// The ends of an enclosure are doubles, so it cannot be narrower than a few of their steps of 2.2e-16.
inline constexpr double least_width = 1e-15;

/// The finished fraction of a check, from 0 to 1; throws to stop it.
using ShareDone = std::function<void(double share)>;

}  // namespace shadefit
