#pragma once

#include <vector>

#include "fit/proof/certificate.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/support/checkpoint.hpp"

/// Proves the properties of a form that its record states: monotonic in the angle, not below 0, not above 1.
namespace shadefit {

/// The most boxes that the proof of a curve may add. The forms here need none or a few.
inline constexpr int most_curve_boxes = 2000;

/// A form's value and its slope in the direction of the rising angle (towards c = 0), on a box. A box with
/// equal ends is a single place.
inline EnclosedFunction::Jet form_on(const EnclosedFunction& form, const Box& box) {
  using Jet = EnclosedFunction::Jet;
  Jet value = form(cosine_at(box.side, Jet(span_of(box.lower, box.upper), 0)));
  if (box.side == Origin::horizon) value.v[0] = -value.v[0];
  return value;
}

/// Proves one property by cutting boxes until it holds on each. `holds` and `fails` take a Jet of `form_on`;
/// `fails` is tested only at single places. After a proof, `boxes` are the boxes on which the property holds.
/// The checkpoint is called for each box.
template <class Holds, class Fails>
Proof prove(const EnclosedFunction& form, std::vector<Box>& boxes, const Holds& holds, const Fails& fails,
            const Checkpoint& checkpoint) {
  std::vector<Box> open(boxes.rbegin(), boxes.rend()), done;
  const std::size_t most = boxes.size() + most_curve_boxes;
  while (!open.empty()) {
    checkpoint();
    const Box box = open.back();
    open.pop_back();
    if (holds(form_on(form, box))) {
      done.push_back(box);
      continue;
    }
    const double centre = box.lower + (box.upper - box.lower) / 2;
    for (const double place : {box.lower, centre, box.upper}) {
      if (fails(form_on(form, {box.side, place, place}))) return Proof::refuted;
    }
    if (done.size() + open.size() >= most || !(box.lower < centre && centre < box.upper)) return Proof::open;
    const Box low{box.side, box.lower, centre}, high{box.side, centre, box.upper};
    const bool is_rising = box.side == Origin::horizon;  // in the cosine, the order of all boxes
    open.push_back(is_rising ? high : low);
    open.push_back(is_rising ? low : high);
  }
  boxes = done;
  return Proof::proven;
}

/// Proves the properties that the record states of a curve, over boxes by rising cosine. It cuts boxes
/// further where needed.
inline CurveProof prove_curve(const EnclosedFunction& form, const CurveShape& curve, std::vector<Box>& boxes,
                              const Checkpoint& checkpoint) {
  CurveProof result;
  if (curve.trend != Trend::none) {
    const bool falls = curve.trend == Trend::falls;
    const auto down = [](const auto& f) { return is_never_positive(f.v[0]); };
    const auto up = [](const auto& f) { return is_never_negative(f.v[0]); };
    const auto is_down = [](const auto& f) { return upper_end(f.v[0]) < 0; };
    const auto is_up = [](const auto& f) { return lower_end(f.v[0]) > 0; };
    result.trend =
        falls ? prove(form, boxes, down, is_up, checkpoint) : prove(form, boxes, up, is_down, checkpoint);
  }
  if (curve.is_non_negative) {
    result.non_negative = prove(
        form, boxes, [](const auto& f) { return is_never_negative(f.a); },
        [](const auto& f) { return upper_end(f.a) < 0; }, checkpoint);
  }
  if (curve.is_at_most_one) {
    result.at_most_one = prove(
        form, boxes, [](const auto& f) { return upper_end(f.a) <= 1; },
        [](const auto& f) { return lower_end(f.a) > 1; }, checkpoint);
  }
  return result;
}

}  // namespace shadefit
