#include "fit/bounds/cut_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "fit/proof/interval_ends.hpp"

namespace shadefit {
namespace {

/// Sums of the violations along all lines of a variable.
class LineSums {
 public:
  LineSums(std::span<const JudgedBox> boxes, std::size_t variable, double slack)
      : boxes_(boxes), variable_(variable), slack_(slack), is_on_long_line_(boxes.size(), false) {}

  /// Marks the boxes on lines through a region whose sum is above the slack. `inside` are the boxes that
  /// reach into it. The variable of the lines does not count in a region.
  void mark(const StudyBox& region, const std::vector<std::size_t>& inside) {
    mark(region, inside, {}, Interval(0));
  }

  const std::vector<bool>& marked() const { return is_on_long_line_; }

 private:
  /// `across` are boxes that all lines of the region cross, with their sum.
  void mark(const StudyBox& region, const std::vector<std::size_t>& inside, std::vector<std::size_t> across,
            Interval sum) {
    std::vector<std::size_t> rest;
    for (const std::size_t i : inside) {
      if (narrower_axis(i, region)) {
        rest.push_back(i);
      } else {
        across.push_back(i);
        sum = sum + Interval(boxes_[i].amount);
      }
    }
    if (!(upper_end(sum) <= slack_)) {
      for (const std::size_t i : across) is_on_long_line_[i] = true;
      for (const std::size_t i : rest) is_on_long_line_[i] = true;
      return;
    }
    if (rest.empty()) return;
    const std::size_t axis = *narrower_axis(rest.front(), region);
    // Boxes are cut at the same middles, so a narrower box lies in one half.
    const auto halves = halves_of(region, axis).value();
    for (const StudyBox& half : halves) {
      std::vector<std::size_t> inside_half;
      std::ranges::copy_if(rest, std::back_inserter(inside_half), [&](std::size_t i) {
        const Stretch& side = boxes_[i].box[axis];
        return side.lower < half[axis].upper && side.upper > half[axis].lower;
      });
      mark(half, inside_half, across, sum);
    }
  }

  /// A variable in which a box does not reach over the whole region.
  std::optional<std::size_t> narrower_axis(std::size_t i, const StudyBox& region) const {
    const StudyBox& box = boxes_[i].box;
    for (std::size_t axis = 0; axis < region.size(); ++axis) {
      const bool is_narrower = box[axis].lower > region[axis].lower || box[axis].upper < region[axis].upper;
      if (axis != variable_ && is_narrower) return axis;
    }
    return std::nullopt;
  }

  std::span<const JudgedBox> boxes_;
  std::size_t variable_;
  double slack_;
  std::vector<bool> is_on_long_line_;
};

/// Whether two boxes begin at the same ends of the ranges, but for one variable.
bool are_beside(const StudyBox& a, const StudyBox& b, std::size_t variable) {
  for (std::size_t axis = 0; axis < a.size(); ++axis)
    if (axis != variable && a[axis].is_from_upper != b[axis].is_from_upper) return false;
  return true;
}

std::vector<JudgedBox> chosen(std::vector<JudgedBox> boxes, const BoxesToCut& to_cut) {
  const std::vector<bool> is_cut = to_cut(boxes);
  std::vector<JudgedBox> result;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (is_cut[i]) result.push_back(std::move(boxes[i]));
  return result;
}

std::vector<StudyBox> halves_of_all(std::span<const JudgedBox> boxes) {
  std::vector<StudyBox> result;
  for (const JudgedBox& judged : boxes) {
    if (const auto halves = halves_of(judged.box, judged.axis)) {
      result.insert(result.end(), halves->begin(), halves->end());
    } else {
      result.push_back(judged.box);  // others may still be cut
    }
  }
  return result;
}

/// The answer for boxes that would have to be cut on.
ShapeProof open_at(std::span<const JudgedBox> boxes, std::span<const Domain> ranges, std::size_t count,
                   std::size_t most) {
  const auto worst = std::ranges::max_element(boxes, {}, &JudgedBox::amount);
  return {Proof::open, place_in(worst->box, ranges), count,
          std::isfinite(worst->amount) ? "a proof needs more than " + std::to_string(most) + " boxes"
                                       : "a proof finds no finite bound"};
}

}  // namespace

BoxesToCut each_above(double slack) {
  return [slack](std::span<const JudgedBox> boxes) {
    std::vector<bool> result;
    for (const JudgedBox& judged : boxes) result.push_back(!(judged.amount <= slack));
    return result;
  };
}

BoxesToCut lines_above(double slack, std::size_t variable, std::span<const Domain> ranges) {
  return [slack, variable, corners = corners_of(ranges)](std::span<const JudgedBox> boxes) {
    LineSums sums(boxes, variable, slack);
    for (const StudyBox& corner : corners) {
      if (corner[variable].is_from_upper) continue;  // the same lines
      std::vector<std::size_t> inside;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!(boxes[i].amount <= 0) && are_beside(boxes[i].box, corner, variable)) inside.push_back(i);
      sums.mark(corner, inside);
    }
    return sums.marked();
  };
}

ShapeProof prove_on_boxes(std::span<const Domain> ranges, const ShapeRule& rule, const BoxesToCut& to_cut,
                          const Checkpoint& checkpoint, std::size_t most) {
  std::size_t count = 0;
  std::vector<StudyBox> open = corners_of(ranges);
  std::vector<JudgedBox> judged;
  while (count + open.size() <= most) {
    judged.clear();
    for (StudyBox& box : open) {
      checkpoint();
      ++count;
      const Violation found = rule(box);
      if (found.place) return {Proof::refuted, *found.place, count};
      judged.push_back({std::move(box), found.amount, found.axis});
    }
    judged = chosen(std::move(judged), to_cut);
    if (judged.empty()) return {Proof::proven, {}, count};
    open = halves_of_all(judged);
  }
  return open_at(judged, ranges, count, most);
}

}  // namespace shadefit
