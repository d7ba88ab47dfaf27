#include "fit/rounding/round_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/proof/interval_ends.hpp"
#include "fit/rounding/lattice_search.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/even_grid.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/study_proof/study_certificate.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The most boxes of a search. An enclosure in 50 digits takes microseconds.
constexpr long most_boxes_of_studies = 20'000;

void require_plain(const StudyObjective& objective, const NumberFormat& format) {
  const auto refuse = [&](bool is_there, const std::string& why) {
    if (is_there) throw UserError("--round '" + to_text(format) + "' does not go with " + why);
  };
  refuse(format.is_narrow(), "a study: take float or decimal:N");
  refuse(objective.study.rows != nullptr, "--table: rows are measured, and have no largest error to keep");
  refuse(integral_depth(error_formula(read_formulas(objective.study))) > 0,
         "'integral': no enclosure of it is fast enough");
  refuse(objective.constraints != Constraints{}, "a constraint: rounding would break it");
  refuse(!objective.study.bounds.empty(), "--bounds: rounding would break them");
}

/// The steps of the grid of the first places, in one, two and three variables.
constexpr std::array<int, most_axes> steps_of_grid{16, 4, 2};

/// The constants on a lattice. A box of them is ruled out by an enclosure of the error at places where it is
/// large; the error of a point is sampled and refined.
template <std::size_t N, class Lattice>
class StudyProblem {
 public:
  StudyProblem(const ReadStudy& study, const Lattice& lattice)
      : study_(study),
        lattice_(lattice),
        error_(tape_of(error_formula(study), formula_inputs(study)), {}),
        places_(even_grid(study.axes, steps_of_grid.at(study.axes.size() - 1))) {}

  double bound(const LatticeBox<N>& box, double best) {
    std::vector<Interval> inputs(study_.axes.size());
    for (std::size_t i = 0; i < N; ++i)
      inputs.push_back(span_of(lattice_.value(box.lower[i]), lattice_.value(box.upper[i])));
    double least = 0;
    for (std::size_t i = 0; i < places_.size() && least < best; ++i) {
      std::transform(places_[i].begin(), places_[i].end(), inputs.begin(),
                     [](double x) { return Interval(x); });
      error_.run(inputs);
      const Interval& error = error_.output(0);
      if (is_bounded(error)) least = std::max(least, smallest_magnitude_in(error));
      // A place that rules out one box may rule out the next.
      if (least >= best) std::swap(places_[i], places_[i / 2]);
    }
    return least;
  }

  double error(const LatticePoint<N>& point, double) {
    std::vector<double> parameters;
    for (const std::int64_t index : point) parameters.push_back(lattice_.value(index));
    const StudyExtremum worst = largest_weighted_error(study_, parameters);
    if (std::ranges::find(places_, worst.at) == places_.end()) places_.insert(places_.begin(), worst.at);
    return worst.magnitude;
  }

 private:
  const ReadStudy& study_;
  Lattice lattice_;
  TapeProgram<Interval> error_;
  std::vector<std::vector<double>> places_;
};

/// A set of constants with the proven bound of its error.
RoundedStudySet assessed(const StudyObjective& objective, const ReadStudy& study, std::vector<double> values,
                         std::vector<std::string> texts, const Checkpoint& checkpoint) {
  StudySubject subject{objective.study, {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    subject.parameters.emplace_back(study.parameters[i], hex_text(values[i]));
  const double width = std::max(1e-6, usual_study_width(study.axes.size()));
  const StudyCertificate proof = certify_study(subject, width, checkpoint).certificate;
  return {std::move(values), std::move(texts), proof.upper, proof.attained};
}

template <std::size_t N, class Lattice>
RoundedStudy round_on(const Lattice& lattice, const StudyObjective& objective, const ReadStudy& study,
                      const StudyFit& fit, const NumberFormat& format, const Checkpoint& checkpoint) {
  const auto point_of = [&](const std::vector<double>& values) {
    LatticePoint<N> point;
    for (std::size_t i = 0; i < N; ++i) {
      point[i] = lattice.nearest(values[i]);
      if (std::abs(point[i]) > lattice.last())
        throw UserError("--round '" + to_text(format) + "': " + study.parameters[i] + " = " +
                        decimal(values[i], 6) + " overflows: the largest is " + largest_text(lattice));
    }
    return point;
  };
  std::vector<LatticePoint<N>> starts{point_of(fit.parameters)};
  if (objective.norm == Norm::least_squares && study.axes.size() == 1) {
    StudyObjective minimax = objective;
    minimax.norm = Norm::minimax;
    const StudyFit nearer = fit_study(minimax, checkpoint);
    if (nearer.status == Status::converged) starts.push_back(point_of(nearer.parameters));
  }
  StudyProblem<N, Lattice> problem(study, lattice);
  const auto best = search_format<N>(lattice_problem<N>(problem), lattice.last(), starts, {}, format,
                                     most_boxes_of_studies, checkpoint);
  const auto set_at = [&](const LatticePoint<N>& point) {
    std::vector<double> values;
    std::vector<std::string> texts;
    for (const std::int64_t index : point) {
      values.push_back(lattice.value(index));
      texts.push_back(shortest(lattice, index));
    }
    return assessed(objective, study, values, texts, checkpoint);
  };
  return {format, set_at(best.point), set_at(starts.front()), best.is_proven, best.searched, best.evaluated};
}

template <class Lattice>
RoundedStudy round_to(const Lattice& lattice, const StudyObjective& objective, const StudyFit& fit,
                      const NumberFormat& format, const Checkpoint& checkpoint) {
  const ReadStudy study = read_study(objective.study);
  switch (study.parameters.size()) {
    case 1:
      return round_on<1>(lattice, objective, study, fit, format, checkpoint);
    case 2:
      return round_on<2>(lattice, objective, study, fit, format, checkpoint);
    case 3:
      return round_on<3>(lattice, objective, study, fit, format, checkpoint);
    case most_rounded_parameters:
      return round_on<most_rounded_parameters>(lattice, objective, study, fit, format, checkpoint);
    default:
      throw UserError("--round '" + to_text(format) + "' takes at most " +
                      std::to_string(most_rounded_parameters) + " parameters: the form has " +
                      std::to_string(study.parameters.size()));
  }
}

}  // namespace

RoundedStudy round_study(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                         const Checkpoint& checkpoint) {
  require_plain(objective, format);
  if (format.kind == NumberFormat::Kind::single)
    return round_to(BinaryLattice<FloatFormat>{}, objective, fit, format, checkpoint);
  return round_to(DecimalLattice{format.digits}, objective, fit, format, checkpoint);
}

}  // namespace shadefit
