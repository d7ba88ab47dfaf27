#include "bench/tradeoff/report.hpp"

#include <fmt/format.h>

namespace shadefit::bench {
namespace {

/// A form that takes at most this many copies is limited by its data, not by its arithmetic: the copy itself
/// varies by that much with the place of its arrays.
constexpr double as_fast_as_a_copy = 1.25;

/// The library's function in the widest registers, the precision of `timed`: the obvious code.
const TimedForm* wide_reference(const Trade& trade, const TimedForm& timed) {
  const TimedForm* widest = nullptr;
  for (const TimedForm& other : trade.forms) {
    if (!other.is_reference || other.target != timed.target || other.is_double != timed.is_double ||
        other.place != timed.place || other.width == forms::Width::scalar)
      continue;
    if (widest == nullptr || other.ns.median < widest->ns.median) widest = &other;
  }
  return widest;
}

std::string times(double ratio) {
  return ratio < 10 ? fmt::format("{:.1f} x", ratio) : fmt::format("{:.0f} x", ratio);
}

std::string gains(const Trade& trade, const TimedForm& timed) {
  if (timed.is_reference) return "the library's own functions";
  std::string text =
      timed.pows ? fmt::format("{} as fast as the scalar loop of the library", times(*timed.pows)) : "";
  if (const TimedForm* wide = wide_reference(trade, timed)) {
    text += fmt::format("{}{} as fast as its widest form", text.empty() ? "" : ", ",
                        times(wide->ns.median / timed.ns.median));
  }
  return text;
}

/// The bottleneck of a form, its loads and stores or its computation, and the remaining difference with data
/// in memory.
std::string bound_of(const Trade& trade, const TimedForm& timed) {
  if (!timed.copies) return "";
  std::string text = *timed.copies <= as_fast_as_a_copy
                         ? fmt::format("bound by loads and stores ({} a copy)", times(*timed.copies))
                         : fmt::format("bound by its arithmetic ({} a copy)", times(*timed.copies));
  const TimedForm* far = in_memory(trade, timed);
  if (far == nullptr || !far->copies) return text;
  text += *far->copies <= as_fast_as_a_copy ? ", in memory by the memory"
                                            : fmt::format(", in memory {} a copy", times(*far->copies));
  return text;
}

}  // namespace

std::string advice(const Trade& trade, const std::string& target) {
  std::string text;
  for (const TimedForm& timed : front_of_target(trade, target)) {
    const std::string gain = gains(trade, timed), bound = bound_of(trade, timed);
    text += fmt::format("- An error of {:.2g} allowed: {} in {} ({}), {:.3g} ns an element{}{}{}{}.\n",
                        *timed.max_abs_error, timed.label, timed.is_double ? "double" : "float",
                        forms::name(timed.width), timed.ns.median, gain.empty() ? "" : "; ", gain,
                        bound.empty() ? "" : "; ", bound);
  }
  return text.empty() ? "Nothing was measured.\n" : text;
}

}  // namespace shadefit::bench
