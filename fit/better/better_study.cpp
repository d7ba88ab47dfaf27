#include "fit/better/better_study.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "approx/scalar.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

Study with_form(const Study& study, const StudyForm& form) {
  Study result = study;
  take_form(result, form);
  return result;
}

/// The name of the error by which contenders are compared. Rows with sigma are weighted without being asked;
/// their residuals have the unit of the rows.
std::string_view error_of(const Study& study) {
  const bool is_of_sigma = study.rows && study.weight == "1/sigma";
  if (study.weight != "1" && !is_of_sigma) return "max_weighted_error";
  return study.error == Error::relative && !study.rows ? "max_rel_error" : "max_abs_error";
}

/// That of a form with this largest error: none if it is exact, up to rounding.
Effect effect_of(const SampledCurve& curve, double largest) {
  Effect effect;
  if (largest == 0) return effect;
  for (std::size_t i = 0; i < curve.form.size(); ++i) effect.show(curve.target[i], curve.form[i], {});
  return effect;
}

/// Whether a display can show the target, which may leave [0, 1] by a fortieth of an 8-bit code.
bool is_shown(const SampledCurve& curve) {
  constexpr double slack = 1e-4;
  return std::ranges::all_of(curve.target,
                             [](double value) { return -slack <= value && value <= 1 + slack; });
}

/// The study by its formulas next to the peak of its form, if it has a peak, and the variable of those.
struct NearPeak {
  NearPeak(const Study& study, const ReadStudy& plain)
      : read(has_peak(study) ? read_formulas(near_peak(study)) : plain), variable(peak_variable(study)) {}

  double cosine_of(double value) const { return variable.cosine_at(value).cos_theta; }

  /// In the variable of the study. A sharp lobe is sampled a second time where it is not 0: c^k < exp(-48)
  /// elsewhere.
  SampledCurve sample(const std::vector<double>& values) const {
    constexpr double end_of_lobe = -48;
    SampledCurve curve = sample_curve(read, values);
    if (variable.exponent > -end_of_lobe) {
      ReadStudy lobe = read;
      lobe.axes.front().lower = std::max(lobe.axes.front().lower, end_of_lobe);
      append(curve, sample_curve(lobe, values));
    }
    for (SampledPlace& place : curve.places) place.front() = cosine_of(place.front());
    return curve;
  }

  ReadStudy read;
  PeakVariable variable;
};

StudyContender contender_of(const StudyForm& form, const Study& study, OthersText origin,
                            const std::vector<double>& values, const std::vector<std::string>& printed,
                            const Checkpoint& checkpoint) {
  const ReadStudy read = read_formulas(study);
  const bool is_plain = error_of(study) == "max_abs_error";
  const NearPeak peak(study, read);
  StudyExtremum largest =
      is_plain ? largest_error(peak.read, values) : largest_weighted_error(peak.read, values);
  largest.at.front() = peak.cosine_of(largest.at.front());
  const SampledCurve curve = peak.sample(values);
  const Symbolic code = at_parameters(read, read.form, values);
  StudyContender contender{.form = form.id,
                           .formula = form.formula,
                           .origin = std::move(origin),
                           .names = read.parameters,
                           .printed = printed,
                           .values = values,
                           .code = code,
                           .operations = count_operations(code),
                           .max_error = largest,
                           .rms_error = rms_error(peak.read, StudyError(peak.read), values),
                           .properties = properties_of(read, curve, printed),
                           .effect = effect_of(curve, largest.magnitude),
                           .is_shown = is_shown(curve)};
  // The largest error may lie between the samples.
  if (!read.rows)
    contender.effect.include(effect_of(sample_place(read, contender.values, largest.at), largest.magnitude));
  prove_properties(study, size_of(curve), contender, checkpoint);
  return contender;
}

using Cuts = std::optional<std::vector<double>>;

void append_published(StudyComparison& comparison, const StudyFile& file, const StudyForm& form,
                      const Cuts& cuts, const Checkpoint& checkpoint, const Checkpoint& next, Judged judged) {
  const Study study = with_form(comparison.study, form);
  const ReadStudy read = read_formulas(study);
  for (const PublishedSet& set : file.published) {
    if (set.form != form.id || !is_for(set, study)) continue;
    next();
    const std::vector<std::string> printed = values_of(set, read.parameters);
    std::vector<double> values;
    for (const std::string& text : printed) values.push_back(constant<double>(text));
    StudyContender contender = contender_of(form, study, set.source, values, printed, checkpoint);
    contender.published = &set;
    if (judged == Judged::yes) {
      // Several sources may print the same digits.
      const auto same = std::ranges::find_if(comparison.contenders, [&](const StudyContender& other) {
        return other.form == form.id && other.printed == printed;
      });
      StudyObjective asked = objective_of(study, file.norm, file.constraints);
      asked.recompute = file.recompute;
      asked.target_cuts = cuts;
      contender.judgement =
          same != comparison.contenders.end() ? same->judgement : judge_set(asked, set, checkpoint);
      for (const ErrorClaim& claim : set.claims)
        contender.claims.push_back(judge_error(claim, study, values));
    }
    comparison.contenders.push_back(std::move(contender));
  }
}

/// What the file asks for, least squares, and minimax.
std::vector<StudyObjective> objectives_of(const StudyFile& file, const Study& study) {
  std::vector<StudyObjective> objectives{objective_of(study, file.norm, file.constraints)};
  for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
    const StudyObjective other = objective_of(study, norm, {});
    if (other.words != objectives.front().words) objectives.push_back(other);
  }
  return objectives;
}

void append_fit(StudyComparison& comparison, const StudyFile& file, const StudyForm& form,
                StudyObjective objective, const Checkpoint& checkpoint) {
  checkpoint();
  const Study asked = objective.study;
  if (asked.starts.empty()) objective.study.starts = published_starts(file, form.id, asked);
  const StudyFit fit = fit_study(objective, checkpoint);
  if (fit.status == Status::converged) {
    StudyContender contender = contender_of(form, asked, objective.words, fit.parameters, {}, checkpoint);
    contender.digits = fit.digits;
    comparison.contenders.push_back(std::move(contender));
  } else {
    comparison.left_out.push_back(form.id + ", " + objective.words + ": " + std::string(name(fit.status)) +
                                  ", " + fit.why);
  }
}

/// Whether a form has published constants but none to fit: it has no parameters, or one without a derivative,
/// such as the threshold of a choice that jumps there. They can be compared, but no fit can judge them.
bool is_only_published(const StudyFile& file, const StudyForm& form, const Study& study) {
  if (std::ranges::find(file.published, form.id, &PublishedSet::form) == file.published.end()) return false;
  const ReadStudy read = read_formulas(study);
  const StudyError error(read);
  return read.parameters.empty() || std::ranges::find(error.is_open(), true) != error.is_open().end();
}

void append_fits(StudyComparison& comparison, const StudyFile& file, const StudyForm& form, const Cuts& cuts,
                 const Checkpoint& checkpoint, const Checkpoint& next) {
  const Study study = with_form(comparison.study, form);
  for (StudyObjective objective : objectives_of(file, study)) {
    next();
    objective.target_cuts = cuts;
    append_fit(comparison, file, form, objective, checkpoint);
  }
}

/// Whether a contender stands before another: by its error, and of equal errors the one of fewer
/// instructions. Two forms of the same curve have the same error but for the last digits of its search, so
/// digits beyond the ninth do not count.
bool ranks_before(const StudyContender& a, const StudyContender& b) {
  constexpr int bits = 30;
  const auto rounded = [](double error) {
    int exponent = 0;
    const double significand = std::frexp(error, &exponent);
    return std::ldexp(std::round(std::ldexp(significand, bits)), exponent - bits);
  };
  const double of_a = rounded(a.max_error.magnitude), of_b = rounded(b.max_error.magnitude);
  return of_a != of_b ? of_a < of_b : a.operations.total() < b.operations.total();
}

/// The fit with the smallest error that costs no more than a published contender, of those with these
/// properties.
const StudyContender* best_at_the_same_cost(const StudyComparison& comparison,
                                            const StudyContender& published,
                                            const std::vector<StudyProperty>& wanted) {
  constexpr double worth = 0.99;  // a smaller gain is rounding of the printed digits
  constexpr double most_rms = 2;  // a smaller peak is not worth a larger error everywhere else
  const StudyContender* best = nullptr;
  for (const StudyContender& contender : comparison.contenders) {
    const bool is_candidate = contender.published == nullptr &&
                              contender.operations.total() <= published.operations.total() &&
                              contender.max_error.magnitude < worth * published.max_error.magnitude &&
                              contender.rms_error <= most_rms * published.rms_error &&
                              lost_properties(wanted, contender.properties).empty();
    if (is_candidate && (best == nullptr || ranks_before(contender, *best))) best = &contender;
  }
  return best;
}

/// A fit that is to keep the properties of a published set.
struct KeepingFit {
  const StudyForm* form;
  StudyObjective objective;
};

/// The fits that are missing: of the form that would be the best but for lost properties. Constraints are for
/// one variable.
std::vector<KeepingFit> keeping_fits(const StudyComparison& comparison, const StudyFile& file) {
  std::vector<KeepingFit> fits;
  if (comparison.study.rows || comparison.study.over.size() > 1) return fits;
  for (const StudyContender& published : comparison.contenders) {
    if (published.published == nullptr) continue;
    const StudyContender* best = least_error_at_the_same_cost(comparison, published);
    if (best == nullptr || lost_properties(published.properties, best->properties).empty()) continue;
    const auto form =
        std::ranges::find_if(file.forms, [&](const StudyForm& other) { return other.id == best->form; });
    const StudyObjective objective =
        objective_of(with_form(comparison.study, *form), Norm::minimax, constraints_of(published.properties));
    const bool is_there = std::ranges::any_of(fits, [&](const KeepingFit& other) {
      return other.form == &*form && other.objective.words == objective.words;
    });
    if (!is_there) fits.push_back({&*form, objective});
  }
  return fits;
}

/// The properties that a target shares with itself.
std::vector<StudyProperty> properties_of_target(const StudyForm& form, const Study& study,
                                                const std::vector<double>& values) {
  const Study asked = with_form(study, form);
  const ReadStudy read = read_formulas(asked);
  SampledCurve curve = NearPeak(asked, read).sample(values);
  curve.form = curve.target;
  return properties_of(read, curve, {});
}

bool is_better(const StudyContender& contender, const StudyContender& published) {
  return contender.max_error.magnitude < published.max_error.magnitude &&
         contender.operations.total() <= published.operations.total();
}

}  // namespace

ReadStudy formulas_of(const StudyComparison& comparison, const StudyContender& contender) {
  Study study = comparison.study;
  study.form = contender.formula;
  return read_formulas(study);
}

double codes_of(const StudyComparison& comparison, const StudyContender& contender) {
  constexpr double most = 255;
  return comparison.is_encoded ? most * contender.effect.absolute.magnitude : contender.effect.srgb_codes;
}

const StudyContender* first_published(const StudyComparison& comparison) {
  const StudyContender* first = nullptr;
  for (const StudyContender& contender : comparison.contenders) {
    // The sets stand one after the other in the list of their file.
    if (contender.published != nullptr && (first == nullptr || contender.published < first->published))
      first = &contender;
  }
  return first;
}

const StudyContender* least_error_at_the_same_cost(const StudyComparison& comparison,
                                                   const StudyContender& published) {
  return best_at_the_same_cost(comparison, published, {});
}

const StudyContender* better_at_the_same_cost(const StudyComparison& comparison,
                                              const StudyContender& published) {
  return best_at_the_same_cost(comparison, published, published.properties);
}

const StudyContender* better_with_all_properties(const StudyComparison& comparison,
                                                 const StudyContender& published) {
  return best_at_the_same_cost(comparison, published, comparison.properties);
}

std::size_t steps_to_compare(const StudyFile& file, const Study& study) {
  std::size_t steps = 1;
  for (const StudyForm& form : file.forms) {
    const Study with = with_form(study, form);
    if (!is_only_published(file, form, with)) steps += objectives_of(file, with).size();
    for (const PublishedSet& set : file.published) steps += set.form == form.id && is_for(set, with) ? 1 : 0;
  }
  return steps;
}

StudyComparison compare_study(const StudyFile& file, const Study& study, const Checkpoint& checkpoint,
                              const Checkpoint& next, Judged judged) {
  StudyComparison comparison{.study = study, .error = error_of(study), .is_encoded = file.is_encoded};
  for (const StudyRange& range : study.over) comparison.variables.push_back(range.variable);
  for (const StudyForm& form : file.forms) {
    const bool is_first = comparison.contenders.empty();
    const bool is_fitted = !is_only_published(file, form, with_form(study, form));
    const Cuts cuts = is_fitted ? cuts_of_target(with_form(study, form)) : std::nullopt;
    append_published(comparison, file, form, cuts, checkpoint, next, is_fitted ? judged : Judged::no);
    if (is_fitted) append_fits(comparison, file, form, cuts, checkpoint, next);
    if (is_first && !comparison.contenders.empty())
      comparison.properties = properties_of_target(form, study, comparison.contenders.front().values);
  }
  next();
  for (const KeepingFit& fit : keeping_fits(comparison, file)) {
    try {
      append_fit(comparison, file, *fit.form, fit.objective, checkpoint);
    } catch (const UserError& error) {  // the form cannot keep them all
      comparison.left_out.push_back(fit.form->id + ", " + fit.objective.words + ": " + error.what());
    }
  }
  auto& contenders = comparison.contenders;
  std::ranges::stable_sort(contenders, [](const StudyContender& a, const StudyContender& b) {
    const bool is_first = a.published != nullptr, is_other_first = b.published != nullptr;
    return is_first != is_other_first ? is_first : ranks_before(a, b);
  });
  for (StudyContender& contender : contenders) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      if (contenders[i].published != nullptr && is_better(contender, contenders[i]))
        contender.beats.push_back(i);
    }
  }
  return comparison;
}

}  // namespace shadefit
