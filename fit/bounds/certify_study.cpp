#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "fit/bounds/enclosed_error.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A box of the search. If it was cut, it has halves.
struct SearchedBox {
  StudyBox box;
  BoxBound on_box;
  std::size_t lower_half = 0, upper_half = 0;  ///< places in the list of all boxes
};

/// A box that may still hold a larger error. Of equal bounds the newest box comes first, so a pole is soon
/// followed down to neighbouring doubles.
struct OpenBox {
  double bound;
  std::size_t index;
  bool operator<(const OpenBox& other) const {
    return bound != other.bound ? bound < other.bound : index < other.index;
  }
};

/// The search for the largest magnitude.
class LargestStudyError {
 public:
  explicit LargestStudyError(EnclosedError& error) : error_(error) {
    const std::vector<StudyBox> corners = corners_of(error.ranges());
    roots_ = corners.size();
    for (const StudyBox& corner : corners) raise(outer_place(corner));
    for (const StudyBox& corner : corners) add(corner);
  }

  /// Whether the width was reached.
  bool search(double width, std::size_t box_limit, const Checkpoint& checkpoint) {
    for (;;) {
      const OpenBox top = open_.top();
      if (top.bound - lower_ <= width * lower_) return true;
      if (open_.size() >= box_limit) return false;
      checkpoint();
      const auto halves = cut(boxes_[top.index]);
      if (!halves) return false;
      open_.pop();
      boxes_[top.index].lower_half = boxes_.size();
      add((*halves)[0]);
      boxes_[top.index].upper_half = boxes_.size();
      add((*halves)[1]);
    }
  }

  double lower() const { return lower_; }
  double upper() const { return std::fmax(open_.top().bound, lower_); }
  const std::vector<double>& attained() const { return attained_; }
  /// A place in the box with the largest bound.
  const std::vector<double>& worst_place() const { return boxes_[open_.top().index].on_box.place; }

  /// The boxes as `visit_boxes` reads them.
  std::string text() const {
    std::string text;
    std::vector<std::size_t> pending;
    for (std::size_t i = roots_; i > 0; --i) pending.push_back(i - 1);
    while (!pending.empty()) {
      const SearchedBox& box = boxes_[pending.back()];
      pending.pop_back();
      if (box.lower_half == 0) {
        text += '.';
        continue;
      }
      text += static_cast<char>('1' + box.on_box.axis);
      pending.push_back(box.upper_half);
      pending.push_back(box.lower_half);
    }
    return text;
  }

 private:
  /// The corner of the ranges at which a box begins.
  std::vector<double> outer_place(const StudyBox& box) const {
    std::vector<double> place;
    for (std::size_t i = 0; i < box.size(); ++i)
      place.push_back(box[i].is_from_upper ? error_.ranges()[i].upper : error_.ranges()[i].lower);
    return place;
  }

  void raise(const std::vector<double>& place) {
    const double magnitude = smallest_magnitude_in(error_.at(place));
    if (magnitude > lower_ || attained_.empty()) {
      lower_ = magnitude;
      attained_ = place;
    }
  }

  void add(const StudyBox& box) {
    const BoxBound found = error_.bound_on(box, lower_);
    if (found.bound > lower_) raise(found.place);
    open_.push({found.bound, boxes_.size()});
    boxes_.push_back({box, found});
  }

  /// Halves at the best variable, or at another one if no double lies within.
  static std::optional<std::array<StudyBox, 2>> cut(SearchedBox& searched) {
    auto result = halves_of(searched.box, searched.on_box.axis);
    for (std::size_t axis = 0; !result && axis < searched.box.size(); ++axis) {
      result = halves_of(searched.box, axis);
      searched.on_box.axis = axis;
    }
    return result;
  }

  EnclosedError& error_;
  std::vector<SearchedBox> boxes_;
  std::size_t roots_ = 0;
  std::priority_queue<OpenBox> open_;
  double lower_ = 0;
  std::vector<double> attained_;
};

}  // namespace

double usual_study_width(std::size_t variables) {
  constexpr std::array widths{usual_width, 1e-6, 1e-3};
  return widths.at(variables - 1);
}

CertifiedStudy certify_study(const StudySubject& subject, double width, const Checkpoint& checkpoint,
                             std::size_t box_limit, const KnownIntegrals* known) {
  if (!(width >= least_width && width < 1))
    throw UserError("width '" + decimal(width, 6) + "' cannot be reached: it must be at least " +
                    decimal(least_width, 6) + ", what an enclosure by doubles can say, and less than 1");
  if (const std::string fault = fault_of(subject); !fault.empty()) throw UserError(fault);
  const ReadStudy study = read_formulas(subject.study);
  EnclosedError error(without_equal_terms(study, subject.parameters), enclosed_constants(subject.parameters),
                      known != nullptr ? *known : KnownIntegrals{});
  LargestStudyError largest(error);
  CertifiedStudy result;
  std::size_t most = study.axes.size() == 1 ? most_boxes_of_one_variable : most_study_boxes;
  if (error.has_integrals()) most = most_boxes_of_integrals;
  result.is_reached = largest.search(width, std::min(box_limit, most), checkpoint);
  if (!std::isfinite(largest.upper()))
    throw CheckFailed(
        "no double was proven to bound the largest error: the formulas have no finite bound near " +
        to_text(study.axes, largest.worst_place()));
  const auto ranges = error.ranges();
  result.certificate = {.subject = subject,
                        .ranges = {ranges.begin(), ranges.end()},
                        .lower = largest.lower(),
                        .upper = largest.upper(),
                        .attained = largest.attained(),
                        .boxes = largest.text(),
                        .precision = interval_precision()};
  return result;
}

}  // namespace shadefit
