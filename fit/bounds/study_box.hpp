#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/quadrature/metric.hpp"

/// Boxes of the ranges of a study, for proofs.
namespace shadefit {

/// The numbers from `end + lower` to `end + upper`, where `end` is one end of a range. Near an end a formula
/// such as sqrt(1 - x) turns within a distance that is far below the spacing of doubles there. So a box holds
/// distances from the nearer end; those from the upper end are negative.
struct Stretch {
  bool is_from_upper = false;
  double lower = 0, upper = 0;
};

/// One stretch for each variable.
using StudyBox = std::vector<Stretch>;

/// The ranges cut at their middles, so that each stretch begins at an end: 2, 4 or 8 boxes, which cover the
/// ranges. Stretches of the two sides may overlap by a rounding.
std::vector<StudyBox> corners_of(std::span<const Domain> ranges);

/// The stretch of one number, the middle of this one.
Stretch middle_of(const Stretch& stretch);

/// The box of one place, the middles of all its stretches.
StudyBox middle_of_all(StudyBox box);

/// A box cut at the middle of one variable; empty if no double lies between its ends.
std::optional<std::array<StudyBox, 2>> halves_of(const StudyBox& box, std::size_t axis);

/// The numbers of a stretch, enclosed; and those of each stretch of a box.
Interval numbers_of(const Stretch& stretch, const Domain& range);
std::vector<Interval> numbers_on(const StudyBox& box, std::span<const Domain> ranges);

/// The variable with the largest part of its range in a box.
std::size_t widest_axis(const StudyBox& box, std::span<const Domain> ranges);

/// The place of doubles nearest to the middle of a box, within the ranges.
std::vector<double> place_in(const StudyBox& box, std::span<const Domain> ranges);

/// Calls `visit` for each box that a text describes, and returns the first answer that is not empty. The text
/// says how the boxes of `corners_of` are cut, one after the other: "." is a box; "1", "2" or "3" cuts at the
/// middle of that variable, and the lower half follows, then the upper one. So the boxes cover the ranges,
/// whatever the text says. For a text of another kind the answer is the reason.
std::string visit_boxes(std::span<const Domain> ranges, std::string_view text,
                        const std::function<std::string(const StudyBox&)>& visit);

}  // namespace shadefit
