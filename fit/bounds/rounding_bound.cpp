#include "fit/bounds/rounding_bound.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include "fit/bounds/running_narrow.hpp"
#include "fit/bounds/study_box.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

template <class Format>
std::vector<RunningNarrow<Format>> rounded_constants(const Constants& constants) {
  std::vector<RunningNarrow<Format>> rounded;
  for (const Interval& value : enclosed_constants(constants))
    rounded.push_back(RunningNarrow<Format>::rounded_number(value));
  return rounded;
}

/// The bound on boxes. The variables are exact: they are numbers of the format.
template <class Format>
class RoundingOnBoxes {
 public:
  RoundingOnBoxes(const ReadStudy& study, const Constants& constants, const GpuModel* gpu)
      : gpu_(gpu),
        form_(tape_of(study.form, formula_inputs(study)), rounded_constants<Format>(constants)),
        scale_(tape_of(error_factor(study), node_variables(study)), {}) {
    for (const StudyAxis& axis : study.axes) ranges_.push_back({axis.lower, axis.upper});
  }

  std::span<const Domain> ranges() const { return ranges_; }

  double bound_on(const StudyBox& box) {
    const std::vector<Interval> numbers = numbers_on(box, ranges_);
    std::vector<RunningNarrow<Format>> operands;
    for (const Interval& x : numbers) operands.push_back(RunningNarrow<Format>::exact(x, gpu_));
    form_.run(operands);
    scale_.run(numbers);
    return largest_magnitude_in(Interval(form_.output(0).error) * scale_.output(0));
  }

 private:
  const GpuModel* gpu_;
  std::vector<Domain> ranges_;
  TapeProgram<RunningNarrow<Format>> form_;
  TapeProgram<Interval> scale_;
};

struct RoundedBox {
  double bound;
  StudyBox box;
  bool operator<(const RoundedBox& other) const { return bound < other.bound; }
};

/// A narrow box in the middle of one. At a single place the enclosures would know the exact rounding.
StudyBox centre_of(StudyBox box) {
  constexpr double share = 0x1p-10;
  for (Stretch& side : box) {
    side.lower = middle_of(side).lower;
    side.upper = side.lower + (side.upper - side.lower) * share;
  }
  return box;
}

/// The bound on all boxes, which are cut where it is largest.
template <class Format>
double bound_on_boxes(RoundingOnBoxes<Format> rounding, const Checkpoint& checkpoint, std::size_t box_limit) {
  std::priority_queue<RoundedBox> open;
  double reached = 0;  // on narrow boxes: the bound will not fall far below
  const auto add = [&](const StudyBox& box) {
    open.push({rounding.bound_on(box), box});
    reached = std::max(reached, rounding.bound_on(centre_of(box)));
  };
  for (const StudyBox& box : corners_of(rounding.ranges())) add(box);
  constexpr double near = 1.05;
  while (open.top().bound > near * reached && open.size() < box_limit) {
    checkpoint();
    const StudyBox& box = open.top().box;
    const auto halves = halves_of(box, widest_axis(box, rounding.ranges()));
    if (!halves) break;
    open.pop();
    for (const StudyBox& half : *halves) add(half);
  }
  return open.top().bound;
}

}  // namespace

template <class Format>
double bound_of_rounding(const StudySubject& subject, const Checkpoint& checkpoint, std::size_t box_limit,
                         const GpuModel* gpu) {
  const ReadStudy study = read_formulas(subject.study);
  // An integral stands for a sum, and in intervals that sum does not enclose it.
  if (integral_depth(study.form) > 0 || integral_depth(error_factor(study)) > 0)
    return std::numeric_limits<double>::infinity();
  return bound_on_boxes(RoundingOnBoxes<Format>(study, subject.parameters, gpu), checkpoint, box_limit);
}

template double bound_of_rounding<FloatFormat>(const StudySubject&, const Checkpoint&, std::size_t,
                                               const GpuModel*);
template double bound_of_rounding<HalfFormat>(const StudySubject&, const Checkpoint&, std::size_t,
                                              const GpuModel*);

}  // namespace shadefit
