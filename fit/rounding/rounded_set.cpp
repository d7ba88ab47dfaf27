#include "fit/rounding/rounded_set.hpp"

#include "fit/bounds/rounding_bound.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// The most boxes for a bound of rounding, which may be rough.
constexpr std::size_t most_boxes_of_sets = 200;

StudySubject subject_of(const StudyObjective& objective, const ReadStudy& study,
                        const std::vector<double>& values) {
  StudySubject subject{objective.study, {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    subject.parameters.emplace_back(study.parameters[i], hex_text(values[i]));
  return subject;
}

}  // namespace

void require_plain(const StudyObjective& objective, const Symbolic& formula, const std::string& option) {
  const auto refuse = [&](bool is_there, const std::string& why) {
    if (is_there) throw UserError(option + " does not go with " + why);
  };
  refuse(objective.study.rows != nullptr, "--table: rows are measured, and have no largest error to keep");
  refuse(integral_depth(formula) > 0, "'integral': no enclosure of it is fast enough");
  refuse(objective.constraints != Constraints{}, "a constraint: rounding would break it");
  refuse(!objective.study.bounds.empty(), "--bounds: rounding would break them");
}

std::vector<std::vector<double>> fitted_values(const StudyObjective& objective, const StudyFit& fit,
                                               const Checkpoint& checkpoint) {
  std::vector<std::vector<double>> values{fit.parameters};
  if (objective.norm == Norm::minimax || objective.study.over.size() > 1) return values;
  StudyObjective minimax = objective;
  minimax.norm = Norm::minimax;
  const StudyFit nearer = fit_study(minimax, checkpoint);
  if (nearer.status == Status::converged) values.push_back(nearer.parameters);
  return values;
}

bool has_bound(const StudyObjective& objective, const ReadStudy& study, const std::vector<double>& values,
               const Checkpoint& checkpoint) {
  constexpr double rough = 0.5;  // any width will do
  try {
    certify_study(subject_of(objective, study, values), rough, checkpoint);
    return true;
  } catch (const CheckFailed&) {
    return false;
  }
}

void add_proven_errors(RoundedStudySet& set, const StudyObjective& objective, const ReadStudy& study,
                       bool is_float, const Checkpoint& checkpoint) {
  const StudySubject subject = subject_of(objective, study, set.values);
  const StudyCertificate proof =
      certify_study(subject, usual_study_width(study.axes.size()), checkpoint).certificate;
  set.max_error = proof.upper;
  set.real_error = proof.upper;
  set.at = proof.attained;
  if (!is_float) return;
  const auto with_rounding = [&](const GpuModel* gpu) {
    return bound_of_rounding<FloatFormat>(subject, checkpoint, most_boxes_of_sets, gpu);
  };
  const auto sum = [&](double rounding) { return std::nextafter(proof.upper + rounding, HUGE_VAL); };
  if (const double rounding = with_rounding(nullptr); std::isfinite(rounding)) {
    set.rounding_error = rounding;
    set.max_error = sum(rounding);
  }
  if (const double rounding = with_rounding(&usual_gpu); std::isfinite(rounding))
    set.gpu_bound = sum(rounding);
}

}  // namespace shadefit
