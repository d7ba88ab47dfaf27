#include "fit/bounds/study_box.hpp"

#include <algorithm>

#include "fit/proof/interval_ends.hpp"

namespace shadefit {

std::vector<StudyBox> corners_of(std::span<const Domain> ranges) {
  std::vector<StudyBox> corners{{}};
  for (const Domain& range : ranges) {
    // Rounded upward: the two sides meet, or overlap.
    const Interval width = Interval(range.upper) - Interval(range.lower);
    const double half = upper_end(Interval(width / Interval(2)));
    std::vector<StudyBox> longer;
    for (const StudyBox& corner : corners) {
      for (const Stretch& side : {Stretch{false, 0, half}, Stretch{true, -half, 0}}) {
        longer.push_back(corner);
        longer.back().push_back(side);
      }
    }
    corners = std::move(longer);
  }
  return corners;
}

Stretch middle_of(const Stretch& stretch) {
  const double middle = stretch.lower + (stretch.upper - stretch.lower) / 2;
  return {stretch.is_from_upper, middle, middle};
}

StudyBox middle_of_all(StudyBox box) {
  for (Stretch& side : box) side = middle_of(side);
  return box;
}

std::optional<std::array<StudyBox, 2>> halves_of(const StudyBox& box, std::size_t axis) {
  const double middle = middle_of(box[axis]).lower;
  if (!(box[axis].lower < middle && middle < box[axis].upper)) return std::nullopt;
  std::array halves{box, box};
  halves[0][axis].upper = middle;
  halves[1][axis].lower = middle;
  return halves;
}

Interval numbers_of(const Stretch& stretch, const Domain& range) {
  return Interval(stretch.is_from_upper ? range.upper : range.lower) + span_of(stretch.lower, stretch.upper);
}

std::vector<Interval> numbers_on(const StudyBox& box, std::span<const Domain> ranges) {
  std::vector<Interval> numbers;
  for (std::size_t i = 0; i < box.size(); ++i) numbers.push_back(numbers_of(box[i], ranges[i]));
  return numbers;
}

std::size_t widest_axis(const StudyBox& box, std::span<const Domain> ranges) {
  std::size_t widest = 0;
  const auto share = [&](std::size_t i) {
    return (box[i].upper - box[i].lower) / (ranges[i].upper / 2 - ranges[i].lower / 2);
  };
  for (std::size_t i = 1; i < box.size(); ++i) {
    if (share(i) > share(widest)) widest = i;
  }
  return widest;
}

std::vector<double> place_in(const StudyBox& box, std::span<const Domain> ranges) {
  std::vector<double> place;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double end = box[i].is_from_upper ? ranges[i].upper : ranges[i].lower;
    place.push_back(std::clamp(end + middle_of(box[i]).lower, ranges[i].lower, ranges[i].upper));
  }
  return place;
}

std::string visit_boxes(std::span<const Domain> ranges, std::string_view text,
                        const std::function<std::string(const StudyBox&)>& visit) {
  std::vector<StudyBox> open = corners_of(ranges);
  std::ranges::reverse(open);
  for (const char c : text) {
    if (open.empty()) return "its boxes go on after the last one";
    const StudyBox box = open.back();
    open.pop_back();
    if (c == '.') {
      if (std::string answer = visit(box); !answer.empty()) return answer;
      continue;
    }
    const auto axis = static_cast<std::size_t>(c - '1');
    if (c < '1' || axis >= box.size()) return std::string("its boxes have an unknown sign: '") + c + "'";
    const auto halves = halves_of(box, axis);
    if (!halves) return "its boxes cut one between neighbouring doubles";
    open.push_back((*halves)[1]);
    open.push_back((*halves)[0]);
  }
  return open.empty() ? "" : "its boxes end before they cover the ranges";
}

}  // namespace shadefit
